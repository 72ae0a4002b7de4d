/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_SSPH_H
#define HEATLADDER_SOLVER_PARTICLES_SSPH_H

#include "solver/space/operator.h"

enum { SSPH_ORDER_MAX = 4, SSPH_TERMS_MAX = 14 };

/* A condition number (1-norm, in units of h) past this leaves fewer than six digits in the weights: an error. */
#define SSPH_CONDITION_MAX 1e10

/* Weights of a linear combination of second derivatives from a Taylor expansion to `order` (Song eqs. 9-13): w[j]
 * (nb->n of them) such that sum_j w[j] (f_j - f_i) approximates sum_k target[k] times the k-th derivative.  Terms are
 * ordered x, y, x^2, xy, y^2, x^3, ... (x, x^2, ... on a rod); those of another degree than 2 are 0.
 * STATUS_NUMERICAL names the particle, its neighbour count and the condition number. */
int ssph_weights(const struct neighbourhood *nb, enum kernel_name kernel, int order, const double *target, double *w,
                 struct failure *why);

/* The first derivatives by that expansion to order 1, apart (struct scheme): F_j = W_j and C = (sum_j W_j d_j
 * d_j)^-1, m^-2. */
int ssph_gradient(const struct neighbourhood *nb, enum kernel_name kernel, double *F, double C[3],
                  struct failure *why);

/* The same least squares with any functions: P[j][k], k < terms, of each neighbour, its equation weighted
 * with the kernel and divided by size[j] (NULL: 1).  Weights w of sum_k target[k] c_k, where sum_k c_k P[j][k]
 * approximates f_j - f_i.  Columns are scaled before the condition number is taken. */
int ssph_fit(const struct neighbourhood *nb, enum kernel_name kernel, int terms, double P[][SSPH_TERMS_MAX],
             const double *size, const double *target, double *w, struct failure *why);

/* The condition number of the moment matrix of ssph_weights; infinite where it has no Cholesky factor. */
double ssph_condition(const struct neighbourhood *nb, enum kernel_name kernel, int order);

/* w (n) >= 0, least in sum_j w_j^2/W_j, with sum_j w_j P[j][k] = b[k], k < terms, to rounding; neighbours with
 * W_j <= 0 get 0.  Returns 1, or 0 where there are no such weights: w is then undefined. */
int nonnegative_weights(size_t n, int terms, double P[][SSPH_TERMS_MAX], const double *W, const double *b, double *w);

#endif
