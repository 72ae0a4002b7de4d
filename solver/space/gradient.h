/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_GRADIENT_H
#define HEATLADDER_SOLVER_SPACE_GRADIENT_H

#include "solver/space/csr.h"

/* The first derivatives of a scheme of two sweeps, kappa (D T)_i = kappa C_i sum_j F_ij d_ij (T_j - T_i): F_ij = F_ji
 * of each pair once, d from the places.  Points are the particles, in their order, and after them their ghosts; the
 * state of such an operator holds both. */
struct gradient {
    size_t total;          /* points: n particles and their ghosts */
    double *place;         /* m, 2 total: x, y */
    double *sum;           /* m^-1, 2 n: 2 C_i sum_j F_ij d_ij of an adjoint scheme, times q_i more; else NULL */
    double *C;             /* 3 total: xx, xy, yy; zero at ghosts whose derivatives nothing needs */
    uint32_t *kept, *lent; /* total + 1 each: where the pairs that a point keeps begin, and those that others keep */
    uint32_t *other;       /* kept[total]: of each pair that is kept, the other point */
    double *F;             /* kept[total]: of these pairs */
    uint32_t *keeper, *pair; /* lent[total]: of each pair that another point keeps, that point, and its place in F */
    uint32_t *source;        /* total - n: of each ghost, its particle */
    double *factor, *offset; /* total - n each: T_ghost = factor T_source + offset */
    double kappa[2];         /* m^2 s^-1 */
    double *flux;            /* 2 total: kappa D T, between the sweeps */
    size_t reach;            /* the largest |i - j| of two particles that are a pair */
};

/* Fills *a with the gradient of scheme s on cloud c; arguments and failures as of csr_assemble. */
int gradient_assemble(struct heat_operator *a, const struct problem *p, const struct options *o,
                      const struct scheme *s, const struct cloud *c, double spacing, struct failure *why);
void gradient_free(struct gradient *g);

/* Adds row i of the operator, D_x kappa_x D_x + D_y kappa_y D_y, to *row; n: particles. */
void gradient_compose(const struct gradient *g, size_t n, size_t i, struct row *row);

#endif
