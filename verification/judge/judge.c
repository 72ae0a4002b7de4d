/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The verdict on an order.
 *
 * A straight line through (log x, log error) can mislead in four ways; each has its own test besides the fit.
 *
 * Flattening ladder: a share f of the finest error that does not decrease reduces the last local slope by f (1 -
 * r^-p)/log r (about f for r = 2 and p = 2), but the previous one only by r^-p of that, and so on.  The mean over
 * many rungs hides it, so the local slope of the two finest rungs must be in the band.
 *
 * Scattered errors: with a relative scatter s a local slope has the standard error sqrt(2) s/log r, 0.2 for s = 0.1
 * and r = 2, too much for a band of +-0.1.  The fine slope is then that of the finer half of the local slopes,
 * rounded up: m + 1 rungs at equal ratios have 2 s/log r sqrt(3/(m (m + 1) (m + 2))), 0.046 for 5. window.c decides
 * when errors are scattered.
 *
 * Short span: over a span S errors C exp(a x) look like a power of any order a x, because the local slope changes
 * only by the factor S.  For S >= 4 it leaves any band with hi/lo < 4.
 *
 * Floor between wide rungs: the last local slope of ratio r is log_r(r^p (1 - f) + f).  For large r it decreases
 * more slowly than f: by 0.07 for r = 4, p = 2 and f = 0.1.  Therefore C x^p + F is fitted, and F must be at most a
 * tenth of the finest error.  This is a linear least-squares fit of C x^p/E + F/E = 1 for each p of the band.  It
 * uses the finest rungs that span a factor of 4 (at least four), since coarser ones have higher-order terms.
 * Scattered errors use all rungs, and a floor counts if it is significant: an F-test at 1 % of its reduction of the
 * sum of squares.  If the band contains an order of 0, a floor is expected. */
#include "verification/judge/judge.h"

#include "solver/words.h"
#include "verification/judge/slope.h"
#include "verification/judge/window.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double SPAN_LEAST = 4, FLOOR_MOST = 0.1, SIGNIFICANCE = 0.01, ROUNDED = 1 - 1e-9;
static const double FALLEN = 1 - 1e-6; /* a smaller decrease is only a difference in rounding */

/* Writes the first defect of the errors that excludes an order to `reason`; returns 0 if there is none. */
static int spoilt(const struct judged *l, double lo, char *reason, size_t size) {
    for (int i = 0; i < l->n; i++)
        if (!isfinite(l->error[i])) return snprintf(reason, size, "the error at %.6g is not finite", l->x[i]);
    for (int i = 0; i + 1 < l->n; i++)
        if (!(l->error[i + 1] < FALLEN * l->error[i]) && !l->scattered && lo > 0)
            return snprintf(reason, size, "the error does not fall: %.4e at %.6g, %.4e at %.6g", l->error[i], l->x[i],
                            l->error[i + 1], l->x[i + 1]);
    return 0;
}

/* Number of rungs in the fine slope. */
static int fine_rungs(const struct judged *l) {
    return l->scattered ? l->n / 2 + 1 : 2;
}

double judge_fine_slope(const struct judged *l) {
    int first = l->n - fine_rungs(l);
    return first < 0 ? NAN : slope_fit(l->x + first, l->error + first, l->n - first).value;
}

struct floor_fit {
    double share;      /* share of the floor in the finest error of the fit */
    double line, with; /* sum of squares of C x^p/E - 1, and of (C x^p + F)/E - 1 */
};

/* Fit for one p.  With a_i = (x_i/x_n)^p E_n/E_i and c_i = E_n/E_i the sums below give C and F in units of E_n. */
static struct floor_fit fit_floor(const double *x, const double *error, int n, double p) {
    double a[RUNG_MAX], c[RUNG_MAX], aa = 0, cc = 0, ac = 0, sa = 0, sc = 0;
    struct floor_fit fit = {0};
    for (int i = 0; i < n; i++) {
        c[i] = error[n - 1] / error[i];
        a[i] = pow(x[i] / x[n - 1], p) * c[i];
        aa += a[i] * a[i], cc += c[i] * c[i], ac += a[i] * c[i];
        sa += a[i], sc += c[i];
    }
    double determinant = aa * cc - ac * ac, C = (sa * cc - sc * ac) / determinant,
           F = (sc * aa - sa * ac) / determinant;
    if (!(F > 0)) F = 0, C = sa / aa; /* a floor is not negative */
    for (int i = 0; i < n; i++) {
        fit.line += pow(sa / aa * a[i] - 1, 2);
        fit.with += pow(C * a[i] + F * c[i] - 1, 2);
    }
    fit.share = F / (C + F);
    return fit;
}

double judge_floor(const struct judged *l, double lo, double hi) {
    enum { STEPS = 64 };
    struct floor_fit best = {.line = INFINITY, .with = INFINITY};
    int first = l->n - WINDOW_LEAST;
    if (!(lo > 0) || first < 0 || l->n > RUNG_MAX) return 0;
    while (first > 0 && (l->scattered || l->x[first] / l->x[l->n - 1] < SPAN_LEAST * ROUNDED)) first--;
    int n = l->n - first;
    for (int k = 0; k <= STEPS; k++) {
        struct floor_fit fit = fit_floor(l->x + first, l->error + first, n, lo + (hi - lo) * k / STEPS);
        best.line = fmin(best.line, fit.line);
        if (fit.with < best.with) best.with = fit.with, best.share = fit.share;
    }
    double freedom = n - 3, gain = (best.line - best.with) * freedom;
    if (l->scattered && !(gain > gsl_cdf_fdist_Qinv(SIGNIFICANCE, 1, freedom) * best.with)) return 0;
    return best.share;
}

static enum verdict judge_fine_end(const struct judged *l, double lo, double hi, char *reason, size_t size) {
    double fine = judge_fine_slope(l), share = judge_floor(l, lo, hi);
    if (!(lo <= fine && fine <= hi))
        words_add(reason, size, ", but the %d finest rungs have the slope %.4f", fine_rungs(l), fine);
    else if (share > FLOOR_MOST)
        words_add(reason, size, ", but %.0f %% of the finest error do not fall (C x^p + floor)", 100 * share);
    else
        return VERDICT_PASS;
    return VERDICT_FAIL;
}

enum verdict judge_order(const struct judged *l, double lo, double hi, char *reason, size_t size) {
    if (spoilt(l, lo, reason, size)) return VERDICT_FAIL;
    if (l->n < WINDOW_LEAST) {
        snprintf(reason, size, "%d rung%s, at least %d must: more rungs are needed", l->n,
                 l->n == 1 ? " counts" : "s count", WINDOW_LEAST);
        return VERDICT_INCONCLUSIVE;
    }
    struct slope s = l->slope ? *l->slope : slope_fit(l->x, l->error, l->n);
    int used = snprintf(reason, size, "the interval [%.4f, %.4f] ", s.ci[0], s.ci[1]);
    char *rest = reason + used;
    size_t room = size - (size_t)used;
    double span = l->x[0] / l->x[l->n - 1];
    if (!(isfinite(s.ci[0]) && isfinite(s.ci[1]) && lo <= hi)) {
        snprintf(rest, room, "or the band [%g, %g] is not finite", lo, hi);
        return VERDICT_FAIL;
    }
    if (s.ci[1] < lo || s.ci[0] > hi) {
        snprintf(rest, room, "is outside [%g, %g]", lo, hi);
        return VERDICT_FAIL;
    }
    if (span < SPAN_LEAST * ROUNDED) {
        snprintf(rest, room, "is of rungs that span a factor of %.3g, at least %g is needed: finer rungs", span,
                 SPAN_LEAST);
        return VERDICT_INCONCLUSIVE;
    }
    if (!(lo <= s.ci[0] && s.ci[1] <= hi)) {
        snprintf(rest, room, "reaches past [%g, %g]: more or finer rungs narrow it", lo, hi);
        return VERDICT_INCONCLUSIVE;
    }
    snprintf(rest, room, "is inside [%g, %g]", lo, hi);
    return judge_fine_end(l, lo, hi, reason, size);
}

void judge_ceiling(double error, double ceiling, enum verdict *verdict, char *reason, size_t size) {
    char cause[80], rest[400];
    const char *apart = *reason ? "; " : "";
    if (error <= ceiling && *reason) return;
    if (error <= ceiling) {
        snprintf(reason, size, "the error %.4g is below its ceiling %.4g", error, ceiling);
        return;
    }
    int passed = *verdict == VERDICT_PASS;
    *verdict = VERDICT_FAIL;
    if (isfinite(error))
        snprintf(cause, sizeof cause, "the error %.4g is above its ceiling %.4g", error, ceiling);
    else
        snprintf(cause, sizeof cause, "no error to compare with the ceiling %.4g", ceiling);
    snprintf(rest, sizeof rest, "%.399s", reason);
    snprintf(reason, size, "%s%s%s", passed ? cause : rest, apart, passed ? rest : cause); /* the cause first */
}
