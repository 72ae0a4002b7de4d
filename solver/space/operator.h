/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_OPERATOR_H
#define HEATLADDER_SOLVER_SPACE_OPERATOR_H

#include "solver/space/layout.h"

#include <stddef.h>
#include <stdint.h>

/* The discrete operator of dT/dt = A T + g: one shared stencil on a lattice of one material; elsewhere rows (CSR). */

enum {
    NEIGHBOURS_MAX = 1024,
    LANES_MAX = 8 /* doubles in the widest vector of any machine */
};

struct neighbourhood { /* what a scheme sees of one particle */
    int dim;
    size_t i;        /* the particle, for messages */
    double x[2];     /* m, where it is */
    size_t n;        /* neighbours, itself left out */
    double (*d)[2];  /* m, x_j - x_i */
    double h;        /* m */
    double volume;   /* m^d, of the particle, as the scheme's `volume` has it */
    double rho_c;    /* J m^-3 K^-1, of its cell */
    double kappa[2]; /* m^2 s^-1, at the particle, along each axis */
    /* of schemes with cells, on clouds; NULL elsewhere: */
    const double *face; /* m^(d-1), between the particle's cell and each neighbour's, in the metric of voronoi.h */
    const double *X;    /* m, where each neighbour is along x: the same bits for all that it neighbours */
};

struct wall_row {             /* dT_i/dt = sum_j w[j] T_j + own T_i + g */
    double w[NEIGHBOURS_MAX]; /* s^-1, of the neighbours */
    double own, g;            /* s^-1, K s^-1 */
};

struct scheme {                   /* how a particle method weights neighbours; options are resolved */
    const char *name;             /* the method's, for messages */
    int two_materials, isotropic; /* 1: it takes two materials; it takes k_x = k_y alone */
    int tuned;                    /* 1: it takes --volume tuned */
    /* 1: dT_i/dt = sum_j w[0][j] (T_j - T_i).  2: w[0], w[1] give the two first derivatives, which are applied twice:
     * dT/dt = d/dx(kappa_x dT/dx) + d/dy(kappa_y dT/dy) */
    int sweeps;
    /* 2 sweeps only.  1: the second takes sum_j w . (q_j + q_i), the adjoint of the first, in place of q_j - q_i */
    int adjoint;
    /* 1: of averages over cells a rod of two materials starts with what start_keep_heat makes of them */
    int keeps_start;
    /* 1: on clouds the neighbours are those whose Voronoi cells touch the particle's, and volumes are their cells' */
    int cells;
    /* h/dx where --h is not given; NULL: 1.1 max(order, 2)/2 */
    double (*h)(const struct problem *p);
    /* STATUS_OK, or what else this method has no answer to; NULL: nothing.  Asked by compatibility_check */
    int (*check)(const struct problem *p, const struct options *o, struct failure *why);
    /* m^d: what a particle's volume dV = dx^d counts for, on a lattice of that volume and smoothing length h (m);
     * NULL where weights do not depend on it */
    double (*volume)(const struct problem *p, const struct options *o, double h, double dV);
    /* 1 sweep: fills w[0] (s^-1), of nb->n.  STATUS_NUMERICAL names the particle, its neighbour count and the reason
     */
    int (*weights)(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why);
    /* 2 sweeps: the weights of both derivatives, w[a][j] = F[j] (C d_j)_a in m^-1: F symmetric in the pair, C
     * symmetric (xx, xy, yy), F C d^2 in units of 1 */
    int (*pairs)(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                 double C[3], struct failure *why);
    /* --walls one_sided: the row of a particle within a kernel of a wall.  nb: the particles within 3 h, itself left
     * out.  NULL where the method has none */
    int (*at_wall)(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                   struct wall_row *out, struct failure *why);
};

struct heat_operator {
    size_t n; /* particles */
    struct lattice lattice;
    int reach[2];     /* stencil radius along each axis, in particles */
    ptrdiff_t stride; /* doubles from row to row of a state: ghosts and room for whole vectors */
    double *weight;   /* s^-1, quadrant w[j * (reach[0] + 1) + i], the rest by symmetry; NULL off the lattice */
    size_t *row;      /* n + 1 */
    uint32_t *column; /* row[n] */
    double *value;    /* s^-1, row[n] */
    double *diagonal; /* s^-1, n */
    double *volume;   /* m^d, n, of the cells, for who sets the operator up; NULL where the scheme has none */
    double *rho_c;    /* J m^-3 K^-1, n, of the cells; NULL where the scheme has none, and with one material */
    int band;         /* the largest |column - row| of an entry */
    double *banded;   /* A_(i, i + d) once more at banded[(d + band) * n + i], s^-1; NULL where rows are sparse */
    int constant;     /* 1: walls or a source add to dT/dt, and there is a g */
    double *g;        /* K s^-1, what they add, in the shape of a state; NULL where it is zero */
    size_t state;     /* doubles in a state: n, and ghosts on a lattice */
    size_t pairs;     /* neighbours of all particles together, in rows of two sweeps those of neighbours too */
    size_t bytes;     /* of the arrays above */
    int threads;
    int lanes; /* as of the options */
};

/* Where row j of the particles begins in a state; a cloud has one row. */
static inline ptrdiff_t operator_row(const struct heat_operator *a, ptrdiff_t j) {
    return (j + a->reach[1]) * a->stride + a->reach[0];
}

/* On a lattice of one material. */
int operator_create_lattice(struct heat_operator *a, const struct problem *p, const struct options *o,
                            const struct scheme *s, const struct lattice *l, struct failure *why);
/* For particles anywhere; spacing (m) is what the h of the options counts in. */
int operator_create_csr(struct heat_operator *a, const struct problem *p, const struct options *o,
                        const struct scheme *s, const struct cloud *c, double spacing, struct failure *why);
void operator_free(struct heat_operator *a);

/* The weights of a scheme of one or two sweeps: w[0], and for two on a rectangle w[1], of nb->n each. */
int operator_weights(const struct scheme *s, const struct problem *p, const struct options *o,
                     const struct neighbourhood *nb, double *w[2], struct failure *why);

/* The neighbours within 2 h of a particle of an unbounded lattice of spacing dx (m) along every axis, h in dx, into
 * d; dim, n, d, h and volume of *nb.  STATUS_INPUT where there are more than d has room for. */
int operator_neighbourhood(int dim, double dx, double h, double d[NEIGHBOURS_MAX][2], struct neighbourhood *nb,
                           struct failure *why);

/* The stencil of a scheme on an unbounded lattice of spacing dx (m) along x and y and diffusivity kappa
 * (m^2 s^-1): *weight is a quadrant as in struct heat_operator, to be freed. */
int operator_stencil(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                     const double kappa[2], int *reach, double **weight, struct failure *why);

struct row; /* csr.h */
/* Row i of an operator off the lattice, in place of what *r held. */
void operator_row_take(const struct heat_operator *a, size_t i, struct row *r);

/* An upper bound of |lambda| over the spectrum of A, s^-1 (Gershgorin). */
double operator_bound(const struct heat_operator *a);

#endif
