/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SERIES_H
#define HEATLADDER_REFERENCES_SERIES_H

#include <math.h>

/* Sums that several references share.  Each sum has two forms, image sources and eigenmodes, which check each other;
 * each form returns its error bound.  The diffusion width s = sqrt(4 kappa t), m, represents the time. */

struct approx {
    double value;
    double error; /* bound on truncation and round-off, including the rounding of the arguments */
};

struct curve {
    struct approx at;    /* the function */
    struct approx slope; /* d/dx, m^-1 */
};

/* Images beyond the distance SERIES_REACH s contribute less than erfc(SERIES_REACH) = 6.4e-18. */
#define SERIES_REACH 6.1

/* Initial unit box |x| <= a after the diffusion width s >= 0, between Dirichlet walls at -L and L held at zero.  At
 * s = 0 the result is the closed box: points within round-off (1e-12 a) of its edge are inside, and the slope is 0.
 * If a is small against s, the box is a pulse of area 2 a; value and error scale as a/s. */
struct curve series_box_images(double x, double L, double a, double s);
struct curve series_box_modes(double x, double L, double a, double s);
struct curve series_box(double x, double L, double a, double s);       /* the more accurate form at this s */
struct curve series_box_other(double x, double L, double a, double s); /* the other form */

static inline int series_in_box(double x, double a) { /* 1 or 0 */
    return fabs(x) <= a * (1 + 1e-12);
}

/* The same box on the infinite line: (erf((a+x)/s) + erf((a-x)/s))/2 (Song 2018 eq. 45). */
double series_box_line(double x, double a, double s);

/* sum_k (-1)^k exp(-(x-2kL)^2 / (2 sigma^2)): a Gaussian that vanishes at -L and L. */
struct curve series_gauss_images(double x, double L, double sigma);
struct curve series_gauss_modes(double x, double L, double sigma);
struct curve series_gauss(double x, double L, double sigma);
struct curve series_gauss_other(double x, double L, double sigma);

#endif
