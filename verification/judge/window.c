/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The window of rungs included in the fit.  Each rule depends on measurements of a rung, never on the expected
 * order.
 *
 *   Round-off floor     more than a tenth of the error may be rounding. It grows as dx decreases, and an order would
 * be fitted to noise. Reference floor     more than a tenth may be the error of the reference; same reason.
 *   Time-error floor    more than 1 % is the error of the time step. The sum of a spatial and a time error of some
 * order follows neither order. Pre-asymptotic      only from the coarse end. With E = C x^p (1 + c x^q) the local
 * slope of adjacent rungs deviates from p by about c q x^q, most at the coarsest. The coarsest rung is excluded while
 * its local slope deviates from the median of the finer ones by more than 0.1 and more than four rungs remain. The
 *                       end rung of m equidistant ones has the weight 6/(m (m+1)) per log spacing, so a deviation of
 * 0.1 moves a fit of four by 0.03 and one of five by 0.02. The finest rungs are never excluded for their slope.
 *
 * Scatter: with random errors the last rule would select among rungs, and the interval of the rest would be too
 * narrow or too wide, so no rung is excluded for its slope.  Errors scatter if particles are placed at random, and
 * also if the logarithms v = p log x + noise have comparable variance in their third differences and about the line
 * (slope_roughness): the ratio is near 1 for noise.  For one correction term, a deviation of v by g r^-qi at rung i,
 * or for a floor, it is (1 - r^-q)^6/20 g^2/(m - 3) over 0.5 g^2/(m - 2): 0.02 to 0.06 for r^q <= 4.  The limit of
 * 1/4 detects ten per cent of noise in 9 of 10 ladders with five rungs, and in 19 of 20 with eight. */
#include "verification/judge/window.h"

#include "verification/judge/slope.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>

static const double FLOOR_SHARE = 0.1, TIME_SHARE = 0.01, SLOPE_SPREAD = 0.1, ROUGH = 0.25;

static void leave_out_floors(const struct window_rung *rung, int n, struct window *w) {
    for (int i = 0; i < n; i++) {
        const struct window_rung *r = &rung[i];
        char *why = w->left_out[i];
        size_t size = sizeof w->left_out[i];
        if (r->rounding >= 1)
            snprintf(why, size, "round-off floor: all of the error may be rounding");
        else if (r->rounding > FLOOR_SHARE)
            snprintf(why, size, "round-off floor: up to %.0f %% of the error is rounding", 100 * r->rounding);
        else if (r->reference > FLOOR_SHARE)
            snprintf(why, size, "reference floor: up to %.0f %% is the reference's own error", 100 * r->reference);
        else if (r->time > TIME_SHARE)
            snprintf(why, size, "time-error floor: %.1f %% of the error is the time step's", 100 * r->time);
        w->counts[i] = why[0] == '\0';
        w->exact[i] = r->rounding > FLOOR_SHARE || r->reference > FLOOR_SHARE;
    }
}

/* Considers the included rungs; returns 1 if it excluded the coarsest. */
static int leave_out_coarsest(const struct window_rung *rung, int n, struct window *w) {
    double x[RUNG_MAX], error[RUNG_MAX], local[RUNG_MAX];
    int m = 0, coarsest = -1;
    for (int i = 0; i < n; i++) {
        if (!w->counts[i]) continue;
        if (coarsest < 0) coarsest = i;
        x[m] = rung[i].x;
        error[m++] = rung[i].error;
    }
    if (m <= WINDOW_LEAST) return 0;
    if (slope_roughness(x, error, m) > ROUGH) w->scattered = 1;
    if (w->scattered) return 0;
    slope_local(x, error, m, local);
    double finer = gsl_stats_median(local + 1, 1, (size_t)(m - 2)); /* median of the finer local slopes */
    if (!(fabs(local[0] - finer) > SLOPE_SPREAD)) return 0;
    w->counts[coarsest] = 0;
    snprintf(w->left_out[coarsest], sizeof w->left_out[coarsest],
             "pre-asymptotic: local slope %.2f, the finer ones' median %.2f", local[0], finer);
    return 1;
}

void window_choose(const struct window_rung *rung, int n, struct window *w) {
    *w = (struct window){0};
    for (int i = 0; i < n; i++) w->scattered |= rung[i].random;
    leave_out_floors(rung, n, w);
    while (leave_out_coarsest(rung, n, w)) continue;
    for (int i = 0; i < n; i++) w->n += w->counts[i];
}
