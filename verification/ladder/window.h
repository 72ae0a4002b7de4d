/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_WINDOW_H
#define HEATLADDER_VERIFICATION_LADDER_WINDOW_H

/* The rungs of a ladder that count for its order, and the reasons why others are left out. */

#include "verification/text/number.h"

enum { RUNG_MAX = NUMBERS_MAX, SEEDS_MAX = 16 };
enum { WINDOW_LEAST = 4 }; /* rungs that a gate needs: two parameters fitted, two left to see whether they fit */

struct window_rung {
    double x;         /* dx, m, or dt, s */
    double error;     /* in any norm */
    double time;      /* the share of the error that the time step can make up; NaN where unknown */
    double reference; /* the share that the reference's own error can make up */
    double rounding;  /* the share that rounding can make up */
    int random;       /* 1: the particles lie at random, and errors scatter from rung to rung */
};

struct window {
    int n;                       /* rungs that count */
    int scattered;               /* 1: the errors scatter at random from rung to rung */
    int counts[RUNG_MAX];        /* 1 or 0 */
    int exact[RUNG_MAX];         /* 1: left out since rounding, or the reference, can make up its error */
    char left_out[RUNG_MAX][96]; /* the reason; "" where it counts */
};

/* rung[0] is the coarsest.  A rung whose error is not finite counts, so that the verdict sees it. */
void window_choose(const struct window_rung *rung, int n, struct window *w);

#endif
