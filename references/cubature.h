/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_CUBATURE_H
#define HEATLADDER_REFERENCES_CUBATURE_H

#include "references/series.h"
#include "solver/problem.h"

/* Means over an interval, a rectangle or a box by adaptive Gauss-Legendre quadrature. */

enum { CUBATURE_KNOTS = 8 };

/* Places at which the integrand may jump, or change over a distance far below the extents. */
struct cubature_knots {
    double accuracy; /* in space: accepted difference of two rules, relative to the largest |f|; 0: 1e-14, in space
                        1e-11 */
    int cell;        /* 1: a cell of a mesh, over which f varies little */
    int grades;      /* maximum number of graded parts on either side of a knot, each a quarter of the next; <= 0: the
                        built-in maximum */
    int count[DIM_MAX];
    struct {
        double at;  /* m, in any order; knots outside the domain are ignored */
        int graded; /* 1: the parts shrink towards the knot; 0: they only end there */
    } knot[DIM_MAX][CUBATURE_KNOTS];
};

/* Mean of f over [lo, hi] of dim axes, 1 to 3.  The error is about 1e-14 (in space 1e-11) of the largest |f|
 * sampled, or the mean of the errors that f reports if that is larger; `error` is an estimate that includes both. */
struct approx cubature_mean(struct approx (*f)(const void *data, const double *x), const void *data, int dim,
                            const double *lo, const double *hi, const struct cubature_knots *knots);

#endif
