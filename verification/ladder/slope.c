/* Fit and judgement of an order.  With m points the slope's standard error s has m - 2 degrees of freedom, and the
 * interval is slope +- t s, t the 97.5 % point of Student's distribution (GSL: gsl_fit_linear scales the covariance
 * by the residuals; gsl_cdf_tdist_Pinv). */
#include "verification/ladder/slope.h"

#include "verification/ladder/window.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdio.h>

void slope_local(const double *x, const double *error, int n, double *local) {
    for (int i = 0; i + 1 < n; i++) local[i] = log(error[i] / error[i + 1]) / log(x[i] / x[i + 1]);
}

struct slope slope_fit(const double *x, const double *error, int n) {
    struct slope s = {.value = NAN, .ci = {NAN, NAN}, .n = n};
    double u[RUNG_MAX], v[RUNG_MAX], c0, c1, cov00, cov01, cov11, chi2;
    if (n < 2 || n > RUNG_MAX) return s;
    for (int i = 0; i < n; i++) {
        if (!(isfinite(error[i]) && error[i] > 0)) return s;
        u[i] = log(x[i]);
        v[i] = log(error[i]);
    }
    gsl_fit_linear(u, 1, v, 1, (size_t)n, &c0, &c1, &cov00, &cov01, &cov11, &chi2);
    s.value = c1;
    if (n < 3) return s;
    double half = gsl_cdf_tdist_Pinv(0.975, n - 2) * sqrt(fmax(0, cov11));
    s.ci[0] = c1 - half;
    s.ci[1] = c1 + half;
    return s;
}

/* The first thing in the errors that no order can come from, into `reason`; 0 where there is none. */
static int spoilt(const double *x, const double *error, int n, char *reason, size_t size) {
    for (int i = 0; i < n; i++)
        if (!isfinite(error[i])) return snprintf(reason, size, "the error at %.6g is not finite", x[i]);
    for (int i = 0; i + 1 < n; i++)
        if (!(error[i + 1] < error[i]))
            return snprintf(reason, size, "the error does not fall: %.4e at %.6g, %.4e at %.6g", error[i], x[i],
                            error[i + 1], x[i + 1]);
    return 0;
}

enum verdict slope_judge(const struct slope *s, const double *x, const double *error, double lo, double hi,
                         char *reason, size_t size) {
    if (spoilt(x, error, s->n, reason, size)) return VERDICT_FAIL;
    if (s->n < WINDOW_LEAST) {
        snprintf(reason, size, "%d rung%s, at least %d must", s->n, s->n == 1 ? " counts" : "s count", WINDOW_LEAST);
        return VERDICT_INCONCLUSIVE;
    }
    const char *where = "is not a number";
    enum verdict verdict = VERDICT_FAIL;
    if (lo <= s->ci[0] && s->ci[1] <= hi) {
        where = "lies inside";
        verdict = VERDICT_PASS;
    } else if (s->ci[1] < lo || s->ci[0] > hi) {
        where = "lies outside";
    } else if (isfinite(s->ci[0]) && isfinite(s->ci[1])) {
        where = "reaches past";
        verdict = VERDICT_INCONCLUSIVE;
    }
    snprintf(reason, size, "the interval [%.4f, %.4f] %s [%g, %g]", s->ci[0], s->ci[1], where, lo, hi);
    return verdict;
}
