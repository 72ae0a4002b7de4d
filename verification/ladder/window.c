/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The window of rungs that count.  Each rule looks at what a rung measured, never at the order that is hoped for.
 *
 *   Round-off floor     more than a tenth of the error can be rounding.  It grows as dx falls: an order would be read
 *                       off noise.
 *   Reference floor     more than a tenth can be the reference's own error: likewise.
 *   Time-error floor    more than 1 % is the time step's.  An error of space and one of time that both follow some
 *                       order, added up, follow neither.
 *   Pre-asymptotic      From the coarse end only.  With E = C x^p (1 + c x^q) the local slope of a rung and the next
 *                       finer one is off p by about c q x^q, most at the coarsest.  The coarsest rung is left out
 *                       while its local slope is off the median of the finer ones by more than 0.1, and more than
 *                       four rungs are left.  Of m equidistant rungs the one at the end has the weight 6/(m (m+1))
 *                       per log spacing, so a local slope that is 0.1 off moves a fit of four by 0.03 and one of five
 *                       by 0.02.  The finest rungs are never left out for their slope.
 *
 * Scatter.  Of errors that scatter at random the last rule would pick among rungs, and the interval of what is left
 * would be too narrow or too wide; there no rung is left out for its slope.  Particles placed at random scatter.  So
 * do errors whose logarithms v = p log x + noise have as much variance in their third differences as about the line
 * (slope_roughness): their ratio is near 1 for noise.  For one correction term, v off by g r^-qi at rung i, or a
 * floor, it is (1 - r^-q)^6/20 g^2/(m - 3) over 0.5 g^2/(m - 2): 0.02 to 0.06 for r^q <= 4.  The limit of 1/4 tells
 * ten per cent of noise in 9 ladders of 10 with five rungs, and in 19 of 20 with eight. */
#include "verification/ladder/window.h"

#include "verification/ladder/slope.h"

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

/* Looks at the rungs that count; returns 1 where it left the coarsest of them out. */
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
    double finer = gsl_stats_median(local + 1, 1, (size_t)(m - 2)); /* which moves them */
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
