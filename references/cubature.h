/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_CUBATURE_H
#define HEATLADDER_REFERENCES_CUBATURE_H

#include "references/series.h"

/* Means over an interval or a rectangle, by Gauss-Legendre rules on parts that are refined where two of them differ.
 */

enum { CUBATURE_KNOTS = 8 };

/* Where the integrand may jump, or change within a distance far below the extents. */
struct cubature_knots {
    int grades; /* most parts on either side of a knot, each a quarter of the one before; 0 or less: as many as there
                   can be */
    int count[2];
    struct {
        double at;  /* m, any order; those outside are ignored */
        int graded; /* 1: parts are graded towards it; 0: they end there */
    } knot[2][CUBATURE_KNOTS];
};

/* The mean of f over [lo, hi], dim 1 or 2 (lo[1] = hi[1] for dim 1), to about 1e-14 of the largest |f| met or to the
 * mean of the errors that f states; `error` is an estimate with these in it. */
struct approx cubature_mean(struct approx (*f)(const void *data, const double x[2]), const void *data, int dim,
                            const double lo[2], const double hi[2], const struct cubature_knots *knots);

#endif
