/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SERIES_H
#define HEATLADDER_REFERENCES_SERIES_H

#include <math.h>

/* Sums that the references share.  Each form exists twice, from images and from modes, so that one can check the
 * other; each states its error.  A width s = sqrt(4 kappa t), m, stands for the time. */

struct approx {
    double value;
    double error; /* bound: truncation and rounding, those of the arguments' own arithmetic included */
};

struct curve {
    struct approx at;    /* the function */
    struct approx slope; /* d/dx, m^-1 */
};

/* Images further away than SERIES_REACH s contribute less than erfc(SERIES_REACH) = 6.4e-18. */
#define SERIES_REACH 6.1

/* Unit box |x| <= a after a time of width s, between walls at -L and L that are held at zero.  Any s >= 0; at s = 0
 * the box itself, closed, where points on its edge to round-off (1e-12 a) count as inside, and no slope.  Where a is
 * small against s the box is a pulse of the area 2 a, and value and error are of the order a/s. */
struct curve series_box_images(double x, double L, double a, double s);
struct curve series_box_modes(double x, double L, double a, double s);
struct curve series_box(double x, double L, double a, double s);       /* the better of the two here */
struct curve series_box_other(double x, double L, double a, double s); /* the other one */

static inline int series_in_box(double x, double a) { /* 1 or 0 */
    return fabs(x) <= a * (1 + 1e-12);
}

/* The box on the infinite line: (erf((a+x)/s) + erf((a-x)/s))/2 (Song 2018 eq. 45). */
double series_box_line(double x, double a, double s);

/* sum_k (-1)^k exp(-(x-2kL)^2 / (2 sigma^2)): a Gaussian that vanishes at -L and L. */
struct curve series_gauss_images(double x, double L, double sigma);
struct curve series_gauss_modes(double x, double L, double sigma);
struct curve series_gauss(double x, double L, double sigma);
struct curve series_gauss_other(double x, double L, double sigma);

#endif
