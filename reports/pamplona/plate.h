/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_PLATE_H
#define HEATLADDER_REPORTS_PAMPLONA_PLATE_H

/* Pamplona 2019, section 6 and Table 1: the runs on the plate and their errors. */

#include "reports/ledger/claims.h"
#include "verification/judge/run.h"

/* PLATE_SPH has the cubic kernel of the first author's public code (github, almeriopamplona/msph, twoDimensionalSPH),
 * PLATE_PRINTED the quartic one of the paper. */
enum { PLATE_SPH, PLATE_FTCS, PLATE_PRINTED, PLATE_METHODS, PLATE_SIDE = 20, PLATE_TIMES = 4 };

/* The k-th time of Table 1, s. */
double plate_time(int k);

/* After "run plate ", in the order above.  The steps, which the paper does not print, make its four times whole
 * numbers of steps: 178, 357, 536, 714 of 0.1623 s (eq. 15 with beta = 0.08), twice as many of 0.08115 s (eq. 17 with
 * gamma = 0.0288, printed as 0.029). */
extern const char *const plate_words[PLATE_METHODS];

/* xi = 1.643 m conducts so many times too well with the cubic kernel and the public code's eta = 0.01 h. */
double plate_conducts(void);

struct plate_errors {
    double average;                 /* mean of |T - exact|/exact, %: "relative average error" (section 6) */
    double left_mean, left_max;     /* |e| beside the left wall, K */
    double centre_mean, centre_max; /* |e| of the middle 4 x 4, K */
    double ring_mean;               /* |e| of the outermost ring, K */
    double ring_late, centre_late;  /* mean of exact - T, K */
    double ring_part, centre_part;  /* mean of (exact - T)/exact */
    struct result result;
};

/* Errors of a run on a square plate, relative to the exact solution at time t, s. */
void plate_measure(const struct command_run *run, double t, struct plate_errors *e);

#endif
