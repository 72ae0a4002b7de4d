/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_JUDGE_H
#define HEATLADDER_VERIFICATION_JUDGE_JUDGE_H

/* The verdict on an order: whether the included rungs show an order inside a band. */

#include "verification/text/verdict.h"

#include <stddef.h>

struct slope;

struct judged {
    const double *x, *error; /* the included rungs; x is decreasing */
    int n;
    int scattered;             /* 1: errors scatter at random from rung to rung (window.h) */
    const struct slope *slope; /* fit to all draws, if `error` has their means; NULL: fit to `error` */
};

/* The verdict against [lo, hi].  `reason` becomes one line, for VERDICT_INCONCLUSIVE with the next step. */
enum verdict judge_order(const struct judged *l, double lo, double hi, char *reason, size_t size);

/* The right order with the wrong size does not pass: appends to `reason` if the error is not below the ceiling. */
void judge_ceiling(double error, double ceiling, enum verdict *verdict, char *reason, size_t size);

/* The local slope of the two finest rungs; for scattered errors that of the finer half.  NaN for fewer than two
 * rungs. */
double judge_fine_slope(const struct judged *l);

/* The share of the finest error that does not decrease with x, from a fit of C x^p + floor with p in [lo, hi]. 0 if
 * there is none, if scatter explains it, or if the band contains an order of 0. */
double judge_floor(const struct judged *l, double lo, double hi);

#endif
