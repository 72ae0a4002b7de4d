#ifndef HEATLADDER_VERIFICATION_LADDER_SLOPE_H
#define HEATLADDER_VERIFICATION_LADDER_SLOPE_H

/* The order at which errors fall: a straight line through (log x, log error). */

#include "verification/text/verdict.h"

#include <stddef.h>

struct slope {
    double value;
    double ci[2]; /* 95 % confidence interval; NaN for fewer than three points */
    int n;        /* points fitted */
};

/* log(e[i]/e[i+1]) / log(x[i]/x[i+1]) into local[0 .. n-2]. */
void slope_local(const double *x, const double *error, int n, double *local);

/* Least squares; NaN for fewer than two points, or where an error is not finite or not positive. */
struct slope slope_fit(const double *x, const double *error, int n);

/* Pass: all errors finite, each smaller than the one before, at least four of them, and the whole interval inside
 * [lo, hi].  Fail: not finite, not falling, or the whole interval outside.  Else inconclusive.  x falls from the
 * first to the last; `reason` gets one line. */
enum verdict slope_judge(const struct slope *s, const double *x, const double *error, double lo, double hi,
                         char *reason, size_t size);

#endif
