/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fit of an order.  With m points the standard error s of the slope has m - 2 degrees of freedom, and the interval
 * is slope +- t s, t the 97.5 % point of Student's distribution (GSL: gsl_fit_linear scales the covariance by the
 * residuals; gsl_cdf_tdist_Pinv). */
#include "verification/judge/slope.h"

#include "verification/case/experiment.h"
#include "verification/judge/window.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <math.h>

enum { POINTS = RUNG_MAX * SEEDS_MAX };
static const double ROUNDED = 1e-6; /* a smaller relative scatter is rounding of typed numbers */

void slope_local(const double *x, const double *error, int n, double *local) {
    for (int i = 0; i + 1 < n; i++) local[i] = log(error[i] / error[i + 1]) / log(x[i] / x[i + 1]);
}

struct slope slope_fit(const double *x, const double *error, int n) {
    struct slope s = {.value = NAN, .ci = {NAN, NAN}, .n = n};
    double u[POINTS], v[POINTS], c0, c1, cov00, cov01, cov11, chi2;
    if (n < 2 || n > POINTS) return s;
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

/* The third divided difference of v over u[0 .. 3], scaled such that its variance equals that of independent scatter
 * in v. */
static double third_difference(const double *u, const double *v) {
    double sum = 0, squares = 0;
    for (int i = 0; i < 4; i++) {
        double weight = 1;
        for (int j = 0; j < 4; j++)
            if (j != i) weight /= u[i] - u[j];
        sum += weight * v[i];
        squares += weight * weight;
    }
    return sum / sqrt(squares);
}

double slope_roughness(const double *x, const double *error, int n) {
    double u[RUNG_MAX], v[RUNG_MAX], rough = 0, misfit = 0, mean = 0, middle = 0;
    struct slope s = slope_fit(x, error, n);
    if (n < 5 || !isfinite(s.value)) return 0;
    for (int i = 0; i < n; i++) {
        u[i] = log(x[i]);
        v[i] = log(error[i]);
        middle += u[i] / n;
        mean += v[i] / n;
    }
    for (int i = 0; i + 3 < n; i++) rough += pow(third_difference(u + i, v + i), 2) / (n - 3);
    for (int i = 0; i < n; i++) misfit += pow(v[i] - mean - s.value * (u[i] - middle), 2) / (n - 2);
    return misfit > ROUNDED * ROUNDED ? rough / misfit : 0;
}
