/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_CUBATURE_H
#define HEATLADDER_REFERENCES_CUBATURE_H

#include "references/series.h"

/* Means over an interval or a rectangle by adaptive Gauss-Legendre quadrature. */

enum { CUBATURE_KNOTS = 8 };

/* Places at which the integrand may jump, or change over a distance far below the extents. */
struct cubature_knots {
    int grades; /* maximum number of graded parts on either side of a knot, each a quarter of the next; <= 0: the
                   built-in maximum */
    int count[2];
    struct {
        double at;  /* m, in any order; knots outside the domain are ignored */
        int graded; /* 1: the parts shrink towards the knot; 0: they only end there */
    } knot[2][CUBATURE_KNOTS];
};

/* Mean of f over [lo, hi], dim 1 or 2 (lo[1] = hi[1] if dim is 1).  The error is about 1e-14 of the largest |f|
 * sampled, or the mean of the errors that f reports if that is larger; `error` is an estimate that includes both. */
struct approx cubature_mean(struct approx (*f)(const void *data, const double x[2]), const void *data, int dim,
                            const double lo[2], const double hi[2], const struct cubature_knots *knots);

#endif
