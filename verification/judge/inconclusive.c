/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reasons for which a ladder shows no order.
 *
 * Noise: if E1 of two equal runs differs by d, each scatters by d/sqrt(2).  A tenth of the error moves a local slope
 * of ratio r by sqrt(2)/10/log r, 0.2 for r = 2: too much for a band of +-0.1.  An error above its ceiling by three
 * times its scatter is wrong in any case.
 *
 * Digits: rounding to a unit u has a mean error of u/4.  The unit of T is that of its last digit: of `digits`
 * significant ones (%g, %e), or of the largest number of decimals of any T (%f), whichever is coarser.  A program
 * prints T of the case; mapping to the scene and back adds rounding errors of the largest T or of the offset.
 *
 * Smoothness: C x^p + D x^q, for any C, D, p and q with errors of one sign, has monotone local slopes.  Slopes that
 * turn by 1/2 and back by 1/2 have more than two such terms, for example a tolerance or digits.
 *
 * Rungs: with the scatter s about the line, n rungs at log x = u have the interval +- t(n - 2) s/sqrt(sum (u -
 * mean)^2) about the slope.  The result is the smallest n by halving with an interval inside the band. */
#include "verification/judge/inconclusive.h"

#include "solver/words.h"
#include "references/mapping.h"
#include "verification/judge/judge.h"
#include "verification/judge/ladder.h"
#include "verification/judge/window.h"
#include "verification/text/number.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double DIGITS = 0.1, TURN = 0.5; /* a share of the error; a change of a local slope */

double inconclusive_digits(const struct field *f, const struct mapping *map, int *digits) {
    enum { POINTS = 500 };
    size_t stride = f->n / POINTS + 1;
    int decimals = 400;
    char text[NUMBER_PRINTED];
    double units = 0, sum = 0, scale = mapping_scale(map);
    double off = mapping_is_none(map) ? 0 : 4 * DBL_EPSILON * (scale * field_largest(f) + fabs(map->offset));
    *digits = 0;
    for (size_t i = 0; i < f->n; i += stride) {
        double T = mapping_temperature(map, f->T[i]);
        if (fabs(T) <= off) continue;
        int n = number_digits(T, off / fabs(T), 17, text), last = atoi(strchr(text, 'e') + 1) - n + 1;
        if (n > *digits) *digits = n;
        if (last < decimals) decimals = last; /* the power of ten of the last digit */
    }
    for (size_t i = 0; i < f->n; i += stride) {
        double T = fabs(mapping_temperature(map, f->T[i]));
        if (T > off) units += pow(10, fmax(floor(log10(T)) + 1 - *digits, decimals));
        sum += scale * fabs(f->T[i]);
    }
    return sum > 0 ? units / 4 / sum : 0;
}

/* Local slopes of the included rungs; returns their number. */
static int slopes(const struct ladder *l, double *slope) {
    double x[RUNG_MAX], error[RUNG_MAX];
    int n = ladder_counted(l, x, error);
    slope_local(x, error, n, slope);
    return n > 0 ? n - 1 : 0;
}

static int is_smooth(const double *slope, int n) {
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < n; i++) least = fmin(least, slope[i]), most = fmax(most, slope[i]);
    if (least < -TURN && most > TURN) return 0;
    for (int i = 0; i + 2 < n; i++) {
        double turn = slope[i + 1] - slope[i], back = slope[i + 1] - slope[i + 2];
        if (turn * back > 0 && fabs(turn) > TURN && fabs(back) > TURN) return 0;
    }
    return 1;
}

/* "2.1, -0.4, 3.0" */
static void list_slopes(const double *slope, int n, char *text, size_t size) {
    *text = '\0';
    for (int i = 0; i < n && strlen(text) + 12 < size; i++) words_add(text, size, "%s%.2f", i ? ", " : "", slope[i]);
}

/* The smallest number of rungs, with further ones by halving, for an interval inside the band; 0 if there is
 * none. */
static int rungs_needed(const struct ladder *l, double lo, double hi) {
    enum { MOST = 12 };
    double u[RUNG_MAX], error[RUNG_MAX], half = (l->slope.ci[1] - l->slope.ci[0]) / 2;
    int n = ladder_counted(l, u, error);
    if (n < WINDOW_LEAST) return 0;
    for (int i = 0; i < n; i++) u[i] = log(u[i]);
    double scatter = half / gsl_cdf_tdist_Pinv(0.975, n - 2) * sqrt(gsl_stats_tss(u, 1, (size_t)n)),
           room = fmin(l->slope.value - lo, hi - l->slope.value);
    double last = u[n - 1];
    for (int i = n; i < MOST; i++) {
        u[i] = last -= log(2);
        if (gsl_cdf_tdist_Pinv(0.975, i - 1) * scatter / sqrt(gsl_stats_tss(u, 1, (size_t)i + 1)) <= room)
            return i + 1 + l->n - n;
    }
    return 0;
}

/* States the missing number of rungs if the error is small and decreases throughout; returns 1 if so. */
static int says_what_is_missing(const struct ladder_rungs *rungs, struct ladder *l) {
    static const double FAR = 0.1;
    double slope[RUNG_MAX], error = ladder_finest_error(l);
    int n = slopes(l, slope), positive = 1;
    char list[80];
    for (int i = 0; i < n; i++) positive = positive && slope[i] > 0;
    if (l->slope.n < WINDOW_LEAST || !positive || !(error <= FAR * rungs->ceiling) || !rungs->expect.count) return 0;
    double lo = rungs->expect.value[0], hi = rungs->expect.value[1];
    list_slopes(slope, n, list, sizeof list);
    int needed = rungs_needed(l, lo, hi);
    snprintf(l->reason, sizeof l->reason,
             "the error %.2g is %.0f times below its ceiling and falls throughout (slopes %s), but the interval "
             "[%.2f, %.2f] of %d rungs reaches past [%g, %g]: ",
             error, rungs->ceiling / error, list, l->slope.ci[0], l->slope.ci[1], l->slope.n, lo, hi);
    if (needed)
        words_add(l->reason, sizeof l->reason, "with this scatter %d rungs decide (--rungs %d)", needed, needed);
    else
        words_add(l->reason, sizeof l->reason, "no 12 rungs with this scatter decide");
    return 1;
}

/* An error above its ceiling is wrong for any order. */
static void leave_open(const struct ladder_rungs *rungs, double error, struct ladder *l) {
    l->verdict = VERDICT_INCONCLUSIVE;
    if (rungs->ceiling > 0 && !(error <= rungs->ceiling))
        judge_ceiling(error, rungs->ceiling, &l->verdict, l->reason, sizeof l->reason);
}

static void judge_smoothness(const struct ladder_rungs *rungs, struct ladder *l) {
    double slope[RUNG_MAX];
    int n = slopes(l, slope);
    char list[80];
    if (is_smooth(slope, n) || l->diagnosis.named) return;
    list_slopes(slope, n, list, sizeof list);
    snprintf(l->reason, sizeof l->reason,
             "errors do not fall smoothly (slopes %s): points at random, a solver's tolerance, or errors that cancel",
             list);
    leave_open(rungs, ladder_finest_error(l), l);
}

void inconclusive_judge(const struct ladder_rungs *rungs, const struct inconclusive_noise *noise,
                        const struct field *finest, const struct mapping *map, struct ladder *l) {
    double error = ladder_finest_error(l);
    int digits;
    if (l->failure.status || (l->verdict != VERDICT_FAIL && l->verdict != VERDICT_INCONCLUSIVE)) return;
    double printed =
        l->norm == LADDER_QUANTITY ? 0 : inconclusive_digits(finest, map, &digits) / l->rung[l->n - 1].error.l1;
    if (noise->share > INCONCLUSIVE_NOISE) {
        snprintf(l->reason, sizeof l->reason,
                 "answers differ by %.2g K from run to run, %.0f %% of the error: random numbers, threads or an "
                 "unset variable; no order shows",
                 noise->apart, 100 * noise->share);
        leave_open(rungs, error - 3 * noise->finest, l);
    } else if (printed > DIGITS) {
        snprintf(l->reason, sizeof l->reason,
                 "printed digits: %d in the file make up %.0f %% of the finest error; more of them show the order",
                 digits, 100 * fmin(printed, 1));
        leave_open(rungs, error, l);
    } else if (!(l->verdict == VERDICT_INCONCLUSIVE && says_what_is_missing(rungs, l))) {
        judge_smoothness(rungs, l);
    }
}
