/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_TALBOT_H
#define HEATLADDER_REFERENCES_TALBOT_H

#include <complex.h>

/* Numerical inversion of a Laplace transform F:  f(t) = sum over the nodes of Im(weight F(z/t)).  The error is 2e-13
 * of the largest |f| if F belongs to a diffusion problem (poles on the negative real axis). */

enum { TALBOT_NODES = 12 };

/* Node j: z, and its weight times t. */
void talbot_node(int j, double complex *z, double complex *weight);

/* 1 - exp(-2 u) for Re u >= 0, from e = exp(-u), without cancellation at small u (late times). */
double complex talbot_one_less(double complex u, double complex e);

#endif
