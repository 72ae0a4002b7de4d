/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_SSPH_H
#define HEATLADDER_SOLVER_PARTICLES_SSPH_H

#include "solver/space/operator.h"

/* Terms of an expansion to order 4 in space; functions of ssph_fit and nonnegative_weights. */
enum { SSPH_ORDER_MAX = 4, SSPH_TERMS_MAX = 34, FIT_TERMS_MAX = 10 };

/* Maximum condition number (1-norm, in units of h); above it fewer than six digits of the weights remain. */
#define SSPH_CONDITION_MAX 1e10

/* Weights of a linear combination of second derivatives from a Taylor expansion to `order` (Song eqs. 9-13): w[j]
 * (nb->n values) such that sum_j w[j] (f_j - f_i) approximates sum_k target[k] times derivative k.  Terms are
 * ordered by degree, then by the exponents of z and y: x, y, x^2, xy, y^2, x^3, ... in the plane, x, y, z, x^2, xy,
 * y^2, xz, yz, z^2, x^3, ... in space; target is h times the factor of a first derivative, 0 for degrees over 2.
 * STATUS_NUMERICAL names the particle, its neighbour count and the condition number. */
int ssph_weights(const struct neighbourhood *nb, enum kernel_name kernel, int order, const double *target, double *w,
                 struct failure *why);

/* Index of the second derivative along an axis in that order. */
static inline int ssph_second(int dim, int axis) {
    return dim + axis * (axis + 3) / 2;
}

/* The mixed one of the axes a < b. */
static inline int ssph_mixed(int dim, int a, int b) {
    return ssph_second(dim, b) - (b - a);
}

/* First derivatives from the expansion to order 1, in factors (struct scheme): F_j = W_j and C = (sum_j W_j d_j
 * d_j^T)^-1, m^-2. */
int ssph_gradient(const struct neighbourhood *nb, enum kernel_name kernel, double *F, double C[DIM_MAX][DIM_MAX],
                  struct failure *why);

/* The same least squares with arbitrary functions: P[j][k], k < terms, for each neighbour, with the kernel as weight
 * and each equation divided by size[j] (NULL: 1). w are the weights of sum_k target[k] c_k, where sum_k c_k P[j][k]
 * approximates f_j - f_i.  The condition number is that of the matrix with scaled columns. */
int ssph_fit(const struct neighbourhood *nb, enum kernel_name kernel, int terms, double P[][FIT_TERMS_MAX],
             const double *size, const double *target, double *w, struct failure *why);

/* Condition number of the moment matrix of ssph_weights; infinite if it has no Cholesky factor. */
double ssph_condition(const struct neighbourhood *nb, enum kernel_name kernel, int order);

/* w (n) >= 0 with minimal sum_j w_j^2/W_j and sum_j w_j P[j][k] = b[k], k < terms, to round-off; 0 for neighbours
 * with W_j <= 0.  Returns 1, or 0 if there are no such weights; w is then undefined. */
int nonnegative_weights(size_t n, int terms, double P[][FIT_TERMS_MAX], const double *W, const double *b, double *w);

#endif
