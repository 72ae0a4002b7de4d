/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_JUDGED_LADDER_H
#define HEATLADDER_VERIFICATION_UNIT_JUDGED_LADDER_H

/* A ladder of given errors, judged through the window as a ladder that was run is. */

#include "verification/judge/judge.h"
#include "verification/judge/window.h"

/* *scattered: the number of rungs that scatter excludes. */
static inline enum verdict judge(const double *x, const double *error, int n, double lo, double hi, int *scattered,
                                 char reason[240]) {
    struct window_rung rung[RUNG_MAX] = {0};
    struct window w;
    double in[RUNG_MAX], of[RUNG_MAX];
    int m = 0;
    for (int i = 0; i < n; i++) rung[i] = (struct window_rung){.x = x[i], .error = error[i]};
    window_choose(rung, n, &w);
    for (int i = 0; i < n; i++)
        if (w.counts[i]) in[m] = x[i], of[m++] = error[i];
    struct judged judged = {in, of, m, w.scattered, NULL};
    *scattered = w.scattered;
    return judge_order(&judged, lo, hi, reason, 240);
}

#endif
