/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_JUDGE_H
#define HEATLADDER_VERIFICATION_LADDER_JUDGE_H

/* The verdict on an order: whether the rungs that count show an order inside a band. */

#include "verification/text/verdict.h"

#include <stddef.h>

struct slope;

struct judged {
    const double *x, *error; /* of the rungs that count; x falls from the first to the last */
    int n;
    int scattered;             /* 1: the errors scatter at random from rung to rung (window.h) */
    const struct slope *slope; /* of all draws, where `error` has their means; NULL: of `error` */
};

/* The verdict against [lo, hi]; `reason` gets one line, and for VERDICT_INCONCLUSIVE what to do next. */
enum verdict judge_order(const struct judged *l, double lo, double hi, char *reason, size_t size);

/* A right order of a wrong size does not pass: appends to `reason` where the error is not below the ceiling. */
void judge_ceiling(double error, double ceiling, enum verdict *verdict, char *reason, size_t size);

/* The local slope of the two finest rungs; of scattered errors the slope of the finer half.  NaN for fewer than two.
 */
double judge_fine_slope(const struct judged *l);

/* The share of the finest error that does not fall with x, from a fit of C x^p + floor with p in [lo, hi].
 * 0 where there is none, where scatter explains it as well, or where an order of 0 lies in the band. */
double judge_floor(const struct judged *l, double lo, double hi);

#endif
