/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_SLOPE_H
#define HEATLADDER_VERIFICATION_JUDGE_SLOPE_H

/* The order at which errors decrease: a straight line through (log x, log error). */

struct slope {
    double value;
    double ci[2]; /* 95 % confidence interval; NaN for fewer than three points */
    int n;        /* number of points */
};

/* Sets local[0 .. n-2] to log(e[i]/e[i+1]) / log(x[i]/x[i+1]). */
void slope_local(const double *x, const double *error, int n, double *local);

/* Least squares; NaN for fewer than two points, or if an error is not finite or not positive. */
struct slope slope_fit(const double *x, const double *error, int n);

/* Ratio of two variances of log errors: from third differences between rungs, and about the fitted line.  It is
 * about 1 for random scatter and a few hundredths for a smooth curve; 0 for fewer than five points. x is
 * decreasing. */
double slope_roughness(const double *x, const double *error, int n);

#endif
