/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_WINDOW_H
#define HEATLADDER_VERIFICATION_JUDGE_WINDOW_H

/* The rungs of a ladder included in the fit, and the reasons for excluding the others. */

#include "verification/text/number.h"

enum { RUNG_MAX = NUMBERS_MAX };
enum { WINDOW_LEAST = 4 }; /* rungs required by a gate: two fitted parameters, two for the residual */

struct window_rung {
    double x;         /* dx, m, or dt, s */
    double error;     /* in any norm */
    double time;      /* possible share of the time step in the error; NaN if unknown */
    double reference; /* possible share of the reference's error */
    double rounding;  /* possible share of rounding */
    int random;       /* 1: the particles are placed at random, and errors scatter from rung to rung */
};

struct window {
    int n;                       /* number of included rungs */
    int scattered;               /* 1: errors scatter at random from rung to rung */
    int counts[RUNG_MAX];        /* 1: included */
    int exact[RUNG_MAX];         /* 1: excluded because the error may be rounding or that of the reference */
    char left_out[RUNG_MAX][96]; /* the reason; "" if included */
};

/* rung[0] is the coarsest.  A rung with an error that is not finite is included, so that the verdict detects it. */
void window_choose(const struct window_rung *rung, int n, struct window *w);

#endif
