/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_KERNEL_H
#define HEATLADDER_SOLVER_SPACE_KERNEL_H

#include "solver/method.h"

/* Smoothing kernels W(r, h) = w(s) / h^dim with s = r / h and the support s < 2. */

enum { KERNEL_SUPPORT = 2 }; /* in units of h */

/* w(s), dimensionless, normalised so that its integral over R^dim is 1; dim 1 to 3, s >= 0. */
double kernel_value(enum kernel_name kernel, int dim, double s);

/* dw/ds */
double kernel_slope(enum kernel_name kernel, int dim, double s);

/* d2w/ds2; continuous for the cubic kernel, with kinks at 0, 1 and 2 */
double kernel_curvature(enum kernel_name kernel, int dim, double s);

#endif
