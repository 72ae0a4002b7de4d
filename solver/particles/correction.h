/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_CORRECTION_H
#define HEATLADDER_SOLVER_PARTICLES_CORRECTION_H

/* Kernel-gradient sums of one neighbourhood and the small matrices that correct them, in units of h.  With
 * s_j = (x_j - x_i)/h and F_j = -V_j w'(s_j)/(s_j h^d) the gradient of the kernel is V_j grad W = F_j s_j / h, and
 *   Gamma = sum_j F_j s_j s_j^T,   h <grad T> = Gamma^-1 sum_j F_j s_j (T_j - T_i)   (Randles & Libersky 1996)
 * is exact for linear T on any cloud with a regular Gamma. */

#include "solver/space/operator.h"

struct correction {
    size_t n;
    double s[NEIGHBOURS_MAX][DIM_MAX], F[NEIGHBOURS_MAX];
    double inverse[DIM_MAX][DIM_MAX]; /* Gamma^-1 */
};

enum { CORRECTION_TERMS = 6 }; /* second derivatives: xx, xy, yy, xz, yz, zz; on a rod xx, in the plane three */

/* Maximum condition number (1-norm); above it fewer than six digits remain. */
#define CORRECTION_CONDITION_MAX 1e10

/* Computes F_j, s_j and Gamma^-1 with the h of the particle.  STATUS_NUMERICAL names the particle, its neighbour
 * count and the condition number of Gamma. */
int correction_create(const struct neighbourhood *nb, enum kernel_name kernel, struct correction *c,
                      struct failure *why);

/* Gamma^-1 s_j */
static inline void correction_apply(const struct correction *c, size_t j, double out[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++)
        out[a] = c->inverse[a][0] * c->s[j][0] + c->inverse[a][1] * c->s[j][1] + c->inverse[a][2] * c->s[j][2];
}

/* Coefficients of the second derivatives, (kappa_x, 0, kappa_y, 0, 0, kappa_z) / h^2; returns their number. */
int correction_target(const struct neighbourhood *nb, double target[CORRECTION_TERMS]);

/* x^2/2, x y, y^2/2, x z, y z, z^2/2 at s; returns their number. */
static inline int correction_quadratics(int dim, const double *s, double q[CORRECTION_TERMS]) {
    int n = 0;
    for (int b = 0; b < dim; b++)
        for (int a = 0; a <= b; a++) q[n++] = s[a] * s[b] * (a == b ? 0.5 : 1);
    return n;
}

/* Solves K^T z = target for the given number of terms.  STATUS_NUMERICAL as for correction_create; `what` names the
 * matrix. */
int correction_solve(const struct neighbourhood *nb, const char *what, int terms,
                     double K[CORRECTION_TERMS][CORRECTION_TERMS], const double *target, double *z,
                     struct failure *why);

/* For operators without a correction, with the gradient Gamma grad T of linear T, Gamma = sum_j F_j d_j d_j^T (F in
 * m^-2): STATUS_NUMERICAL as for correction_create if Gamma is singular. */
int correction_spans(const struct neighbourhood *nb, const double *F, struct failure *why);

/* Sum of weight(r) factor x^2 over a lattice of spacing 1 about a particle, r = distance x spacing (m): twice the
 * response of pair weights to x^2/2. */
double correction_lattice_sum(enum kernel_name kernel, int dim, double h, double spacing, double factor,
                              double (*weight)(enum kernel_name kernel, int dim, double h, double r));

#endif
