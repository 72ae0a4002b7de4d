#ifndef HEATLADDER_SOLVER_SPACE_GRADIENT_H
#define HEATLADDER_SOLVER_SPACE_GRADIENT_H

#include "solver/space/csr.h"

/* The first derivatives of a scheme of two sweeps, kappa (D T)_i = kappa C_i sum_j F_ij d_ij (T_j - T_i): F_ij = F_ji
 * of each pair once, d from the places.  Points are the particles, in their order, and after them their ghosts; the
 * state of such an operator holds both. */
struct gradient {
    size_t total;          /* points */
    double *place;         /* m, 2 total: x, y */
    double *C;             /* 3 total: xx, xy, yy; zero at ghosts whose derivatives nothing needs */
    uint32_t *kept, *lent; /* total + 1 each: where the pairs that a point keeps begin, and those that others keep */
    uint32_t *other;       /* kept[total]: the other point of a pair */
    double *F;             /* kept[total] */
    uint32_t *keeper, *pair; /* lent[total]: who keeps the pair, and where */
    uint32_t *source;        /* of ghost total - n: a particle, */
    double *factor, *offset; /* and T_ghost = factor T_source + offset */
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

/* The weights of both derivatives, w[a][j] = F_j (C d_j)_a. */
void gradient_weights(const struct neighbourhood *nb, const double *F, const double C[3], double *w[2]);

#endif
