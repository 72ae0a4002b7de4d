/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_CORRECTION_H
#define HEATLADDER_SOLVER_PARTICLES_CORRECTION_H

/* Kernel-gradient sums of one neighbourhood and the small matrices that correct them, in units of h: with
 * s_j = (x_j - x_i)/h and F_j = -V_j w'(s_j)/(s_j h^d), the gradient of the kernel is V_j grad W = F_j s_j / h, and
 *   Gamma = sum_j F_j s_j s_j^T,   h <grad T> = Gamma^-1 sum_j F_j s_j (T_j - T_i)   (Randles & Libersky 1996),
 * exact for linear T on any cloud for which Gamma is regular. */

#include "solver/space/operator.h"

struct correction {
    size_t n;
    double s[NEIGHBOURS_MAX][2], F[NEIGHBOURS_MAX];
    double inverse[2][2]; /* Gamma^-1 */
};

enum { CORRECTION_TERMS = 3 }; /* second derivatives: xx, xy, yy; xx alone on a rod */

/* A condition number (1-norm) past this leaves fewer than six digits: an error. */
#define CORRECTION_CONDITION_MAX 1e10

/* F_j, s_j and Gamma^-1, with the h of the particle.  STATUS_NUMERICAL names the particle, its neighbour count and
 * the condition number of Gamma. */
int correction_create(const struct neighbourhood *nb, enum kernel_name kernel, struct correction *c,
                      struct failure *why);

/* Gamma^-1 s_j */
void correction_apply(const struct correction *c, size_t j, double out[2]);

/* Target of the second derivatives, (kappa_x, 0, kappa_y) / h^2; returns their number. */
int correction_target(const struct neighbourhood *nb, double target[CORRECTION_TERMS]);

/* x^2/2, x y, y^2/2 at s; x^2/2 alone on a rod. */
void correction_quadratics(int dim, const double s[2], double q[CORRECTION_TERMS]);

/* z with K^T z = target, of the given number of terms.  STATUS_NUMERICAL as correction_create, `what` the matrix. */
int correction_solve(const struct neighbourhood *nb, const char *what, int terms,
                     double K[CORRECTION_TERMS][CORRECTION_TERMS], const double *target, double *z,
                     struct failure *why);

/* For operators without a matrix, whose gradient of linear T is Gamma grad T, Gamma = sum_j F_j d_j d_j^T (F in
 * m^-2): STATUS_NUMERICAL as correction_create where along some direction there is none. */
int correction_spans(const struct neighbourhood *nb, const double *F, struct failure *why);

#endif
