/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_SLOPE_H
#define HEATLADDER_VERIFICATION_LADDER_SLOPE_H

/* The order at which errors fall: a straight line through (log x, log error). */

struct slope {
    double value;
    double ci[2]; /* 95 % confidence interval; NaN for fewer than three points */
    int n;        /* points fitted */
};

/* log(e[i]/e[i+1]) / log(x[i]/x[i+1]) into local[0 .. n-2]. */
void slope_local(const double *x, const double *error, int n, double *local);

/* Least squares; NaN for fewer than two points, or where an error is not finite or not positive. */
struct slope slope_fit(const double *x, const double *error, int n);

/* Variance of the errors' logarithms from rung to rung, by their third differences, over their variance about the
 * fitted line: about 1 where they scatter at random, a few hundredths where they follow a smooth curve.  0 for fewer
 * than five points.  x falls from the first to the last. */
double slope_roughness(const double *x, const double *error, int n);

#endif
