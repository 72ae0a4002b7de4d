/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_CEILING_WEIGHTS_H
#define HEATLADDER_VERIFICATION_GATES_CEILING_WEIGHTS_H

/* Weights of the methods on a lattice of spacing 1, for the predicted errors of ceiling.h. */

#include "verification/solve/experiment.h"

enum { CEILING_WEIGHTS_REACH = 10, CEILING_WEIGHTS_WIDE = 2 * CEILING_WEIGHTS_REACH + 1 };

struct ceiling_weights {
    int dim, reach;                                                             /* weights beyond the reach are 0 */
    double w[CEILING_WEIGHTS_WIDE][CEILING_WEIGHTS_WIDE][CEILING_WEIGHTS_WIDE]; /* [z][y][x], offset + reach */
};

enum ceiling_family { LEAST_SQUARES, PAIRS, CURVATURE, TWICE_VALUE, TWICE_SLOPE, DIFFERENCE, DIFFERENCE_TWICE };

struct ceiling_weights_case {
    enum ceiling_family family;
    enum kernel_name kernel;
    int dim, order;
    double h;              /* h/dx */
    double ratio[DIM_MAX]; /* kappa of each axis over kappa_x */
    double eta;            /* eta in -W' r/(r^2 + eta^2), in units of dx */
};

struct ceiling_weights_case ceiling_weights_case(const struct experiment *e);

/* The weights in units of kappa_x; *blind: diffusivity of the envelope of (-1)^i over kappa for first derivatives
 * applied twice, else 0. */
void ceiling_weights_of(const struct ceiling_weights_case *c, struct ceiling_weights *s, double *blind);

/* sum w x^a y^b z^c */
double ceiling_weights_moment(const struct ceiling_weights *s, int a, int b, int c);

/* The weight of a pair at distance r, up to a factor. */
double ceiling_weights_radial(const struct ceiling_weights_case *c, double r);

#endif
