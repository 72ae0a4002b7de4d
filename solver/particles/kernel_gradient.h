/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_KERNEL_GRADIENT_H
#define HEATLADDER_SOLVER_PARTICLES_KERNEL_GRADIENT_H

#include "solver/space/operator.h"

/* The gradient that SPH codes have, <grad T>_i = sum_j V_j (T_j - T_i) grad W_ij: `volume` and `pairs` of schemes
 * of two sweeps (struct scheme).  --volume moment: V such that it is exact for linear T on the lattice.
 * STATUS_NUMERICAL for a particle all of whose neighbours lie on one line (correction_spans). */
double kernel_gradient_volume(const struct problem *p, const struct options *o, double h, double dV);
int kernel_gradient_pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                          double C[3], struct failure *why);

#endif
