/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_PLATE_H
#define HEATLADDER_REPORTS_PAMPLONA_PLATE_H

/* Pamplona 2019, section 6 and Table 1: the two runs on the plate, and the errors that the paper may mean. */

#include "reports/ledger/claims.h"
#include "verification/ladder/command_run.h"

enum { PLATE_SPH, PLATE_FTCS, PLATE_METHODS, PLATE_SIDE = 20, PLATE_TIMES = 4 };

/* The k-th time of Table 1, s. */
double plate_time(int k);

/* After "run plate ", in the order above.  The steps, which the paper does not print, make its four times whole
 * numbers of steps: 178, 357, 536, 714 of 0.1623 s (eq. 15 with beta = 0.08), twice as many of 0.08115 s (eq. 17 with
 * gamma = 0.0288, printed as 0.029). */
extern const char *const plate_words[PLATE_METHODS];

/* Definitions of the average error, which the paper does not give; e = T - exact. */
enum plate_definition {
    PLATE_MEAN_RELATIVE, /* the one that the ledger takes: "relative average error" (section 6) */
    PLATE_E1,
    PLATE_OVER_KELVIN,
    PLATE_RMS,
    PLATE_L2,
    PLATE_WITH_GHOSTS,
    PLATE_MOST,
    PLATE_DEFINITIONS
};
extern const char *const plate_definitions[PLATE_DEFINITIONS];

/* By every definition, %.  T and exact are n x n, x fastest. */
void plate_average(const double *T, const double *exact, int n, double error[PLATE_DEFINITIONS]);

struct plate_errors {
    double average[PLATE_DEFINITIONS]; /* % */
    double left_mean, left_max;        /* |e| beside the left wall, K */
    double centre_mean, centre_max;    /* |e| of the middle 4 x 4, K */
    double ring_mean;                  /* |e| of the outermost ring, K */
    double ring_late, centre_late;     /* mean of exact - T, K */
    double ring_part, centre_part;     /* mean of (exact - T)/exact */
    struct result result;
};

/* Of a run on a square plate, against the exact solution at its end. */
void plate_measure(const struct command_run *run, struct plate_errors *e);

#endif
