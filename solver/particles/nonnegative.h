/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_NONNEGATIVE_H
#define HEATLADDER_SOLVER_PARTICLES_NONNEGATIVE_H

#include "solver/particles/ssph.h"

/* w (n) >= 0, least in sum_j w_j^2/W_j, with sum_j w_j P[j][k] = b[k], k < terms, to rounding; neighbours with
 * W_j <= 0 get 0.  Returns 1, or 0 where there are no such weights: w is then undefined. */
int nonnegative_weights(size_t n, int terms, double P[][SSPH_TERMS_MAX], const double *W, const double *b, double *w);

#endif
