/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_CEILING_WEIGHTS_H
#define HEATLADDER_VERIFICATION_GATES_CEILING_WEIGHTS_H

/* Weights of the methods on a lattice of spacing 1, in units of kappa_x, for the ceilings. */

#include "verification/case/experiment.h"

enum { CEILING_REACH = 10, CEILING_WIDE = 2 * CEILING_REACH + 1 };

enum ceiling_family {
    UNKNOWN,
    LEAST_SQUARES,
    PAIRS,
    CURVATURE,
    TWICE_VALUE,
    TWICE_SLOPE,
    DIFFERENCE,
    DIFFERENCE_TWICE
};

struct ceiling_weights {
    enum ceiling_family family;
    enum kernel_name kernel;
    int dim, order;
    double h;                                           /* h/dx; 0 for finite differences */
    double ratio[DIM_MAX];                              /* kappa of each axis over kappa_x */
    double cross[DIM_MAX];                              /* kappa_xy, kappa_xz, kappa_yz over kappa_x */
    int corner;                                         /* 1: finite differences with gradients at corners */
    double eta;                                         /* eta in -W' r/(r^2 + eta^2), in units of dx */
    int reach;                                          /* weights beyond it are 0 */
    double w[CEILING_WIDE][CEILING_WIDE][CEILING_WIDE]; /* [z][y][x], offset + CEILING_REACH */
    double blind; /* first derivatives applied twice: diffusivity of the envelope of (-1)^i over kappa; else 0 */
};

/* The weights of e->method.  A method that has no row in the table of families has NAN for all of them, and so no
 * ceiling. */
struct ceiling_weights ceiling_weights(const struct experiment *e);

/* sum w x^a y^b z^c; sum w (u.x)^n; the sum of |w| of the neighbours. */
double ceiling_weights_moment(const struct ceiling_weights *s, int a, int b, int c);
double ceiling_weights_along(const struct ceiling_weights *s, const double u[DIM_MAX], int n);
double ceiling_weights_row(const struct ceiling_weights *s);

/* The weight of a pair at distance r, up to a factor. */
double ceiling_weights_radial(const struct ceiling_weights *s, double r);

#endif
