/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_OPERATOR_H
#define HEATLADDER_SOLVER_SPACE_OPERATOR_H

#include "solver/space/layout.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* The discrete operator of dT/dt = A T + g: one shared stencil on a lattice of one material, otherwise sparse rows
 * (CSR). */

enum {
    NEIGHBOURS_MAX = 1024,
    LANES_MAX = 8 /* doubles in the widest vector of any machine */
};

struct neighbourhood { /* one particle and its neighbours, input of a scheme */
    int dim;
    size_t i;              /* index of the particle, for messages */
    double x[DIM_MAX];     /* m, its position */
    size_t n;              /* number of neighbours, excluding itself */
    double (*d)[DIM_MAX];  /* m, x_j - x_i; 0 along axes past dim */
    double h;              /* m */
    double volume;         /* m^dim, of the particle, from the scheme's `volume` */
    double rho_c;          /* J m^-3 K^-1, of its cell */
    double kappa[DIM_MAX]; /* m^2 s^-1, at the particle, along each axis */
    double cross[DIM_MAX]; /* m^2 s^-1: kappa_xy, kappa_xz, kappa_yz; 0 for schemes of a diagonal tensor */
    /* for schemes with cells on clouds; else NULL: */
    const double *face; /* m^(dim-1), between the particle's cell and each neighbour's, in the metric of voronoi.h */
    const double *X;    /* m, x coordinate of each neighbour, the same bits in every neighbourhood */
};

/* m, of neighbour j from the particle; branches, since hypot is slow. */
static inline double neighbourhood_distance(const struct neighbourhood *nb, size_t j) {
    const double *d = nb->d[j];
    return nb->dim < 3 ? hypot(d[0], d[1]) : sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

struct wall_row {             /* dT_i/dt = sum_j w[j] T_j + own T_i + g */
    double w[NEIGHBOURS_MAX]; /* s^-1, for the neighbours */
    double own, g;            /* s^-1, K s^-1 */
};

struct scheme {                   /* neighbour weights of a particle method; the options are complete */
    const char *name;             /* name of the method, for messages */
    int two_materials, isotropic; /* 1: supports two materials; requires k_x = k_y */
    int tensor;                   /* 1: supports k_xy, k_xz and k_yz */
    int tuned;                    /* 1: supports --volume tuned */
    /* 1: dT_i/dt = sum_j w[0][j] (T_j - T_i). 2: w[a] are the weights of the first derivatives, a < dim, which are
     * applied twice: dT/dt = sum_a d/dx_a(kappa_a dT/dx_a). */
    int sweeps;
    /* Two sweeps only. 1: the second sweep is sum_j w . (q_j + q_i), the adjoint of the first, instead of q_j -
     * q_i. */
    int adjoint;
    /* 1: on a rod of two materials start_keep_heat corrects averaged initial data. */
    int keeps_start;
    /* 1: on clouds the neighbours are those with adjacent Voronoi cells, and volumes are those of the cells. */
    int cells;
    /* Default h/dx; NULL: 1.1 max(order, 2)/2. */
    double (*h)(const struct problem *p);
    /* Further refusals of the method, called by particles_check; NULL: none. */
    int (*check)(const struct problem *p, const struct options *o, struct failure *why);
    /* m^dim: effective volume of a particle on a lattice of volume dV = dx^dim and smoothing length h (m); NULL if
     * the weights do not depend on it. */
    double (*volume)(const struct problem *p, const struct options *o, double h, double dV);
    /* One sweep: fills w[0] (s^-1, nb->n values).  STATUS_NUMERICAL names the particle, its neighbour count and the
     * reason. */
    int (*weights)(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why);
    /* Two sweeps: weights of the derivatives, w[a][j] = F[j] (C d_j)_a in m^-1.  F is symmetric in the pair, C a
     * symmetric tensor, set for a, b < dim; F C d^2 is dimensionless. */
    int (*pairs)(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                 double C[DIM_MAX][DIM_MAX], struct failure *why);
    /* --walls one_sided: the row of a particle within a kernel of a wall. nb: the particles within assembly_widest,
     * excluding itself.  NULL if not supported. */
    int (*at_wall)(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                   struct wall_row *out, struct failure *why);
};

struct images {          /* weights of the ghosts of a cloud in each row, if the data change */
    size_t *row;         /* n + 1 */
    uint32_t *point;     /* row[n] */
    double *weight;      /* s^-1, row[n] */
    struct cloud *cloud; /* owned */
};

struct heat_operator {
    size_t n; /* number of particles */
    struct lattice lattice;
    int reach[DIM_MAX]; /* stencil radius along each axis, in particles; 0 past dim */
    ptrdiff_t stride;   /* doubles from row to row of a state, with ghosts and padding for whole vectors */
    ptrdiff_t plane;    /* doubles from plane to plane */
    double *weight; /* s^-1, octant at operator_offset(reach, i, j, k), the rest by symmetry; NULL off the lattice */
    size_t *row;    /* n + 1 */
    uint32_t *column; /* row[n] */
    double *value;    /* s^-1, row[n] */
    double *diagonal; /* s^-1, n */
    double *volume;   /* m^dim, n, of the cells; the creator of the operator takes it; NULL without cells */
    double *rho_c;    /* J m^-3 K^-1, n, of the cells; NULL without cells or with one material */
    int band;         /* maximum |column - row| */
    double *banded;   /* A_(i, i + d) also at banded[(d + band) * n + i], s^-1; NULL if the rows are sparse */
    int constant;     /* 1: walls or a source contribute to dT/dt, through g */
    double *g;        /* K s^-1, their contribution, in the shape of a state; NULL if it is zero */
    size_t state;     /* doubles in a state: n, plus ghosts on a lattice */
    size_t pairs; /* sum over particles of the number of neighbours; with two sweeps including those of neighbours */
    size_t bytes; /* size of the arrays above */
    int threads;
    int lanes;             /* see options.h */
    struct images *images; /* NULL on a lattice, and for steady data */
};

/* Start of row j of the particles in a state; a cloud has one row. */
static inline ptrdiff_t operator_row(const struct heat_operator *a, ptrdiff_t j) {
    return (j + a->reach[1]) * a->stride + a->reach[0];
}

/* The same in plane k of a box. */
static inline ptrdiff_t operator_place(const struct heat_operator *a, ptrdiff_t j, ptrdiff_t k) {
    return (k + a->reach[2]) * a->plane + operator_row(a, j);
}

/* Index of the weight of the offset (i, j, k) >= 0, and the number of offsets (+-i, +-j, +-k). */
static inline size_t operator_offset(const int reach[DIM_MAX], int i, int j, int k) {
    return (size_t)((k * (reach[1] + 1) + j) * (reach[0] + 1) + i);
}
static inline int operator_images(int i, int j, int k) {
    return (i ? 2 : 1) * (j ? 2 : 1) * (k ? 2 : 1);
}

/* For a lattice of one material. */
int operator_create_lattice(struct heat_operator *a, const struct problem *p, const struct options *o,
                            const struct scheme *s, const struct lattice *l, struct failure *why);
/* g (one state) of that operator at the time t, s. */
void operator_constants(const struct heat_operator *a, const struct problem *p, const struct options *o, double t,
                        double *g);
void operator_free(struct heat_operator *a);

/* The weights of a scheme: w[0], or for two sweeps w[a], a < dim; nb->n values each. */
int operator_weights(const struct scheme *s, const struct problem *p, const struct options *o,
                     const struct neighbourhood *nb, double *w[], struct failure *why);

/* The neighbours within 2 h of a particle on an unbounded lattice of spacing dx (m), h in dx, in d; sets dim, n, d,
 * h and volume of *nb.  Returns STATUS_INPUT if there are more than NEIGHBOURS_MAX. */
int operator_neighbourhood(int dim, double dx, double h, double d[NEIGHBOURS_MAX][DIM_MAX], struct neighbourhood *nb,
                           struct failure *why);

/* The stencil of a scheme on an unbounded cubic lattice of spacing dx (m) with diffusivity kappa (m^2 s^-1, dim
 * values).  *weight is an octant as in struct heat_operator; the caller frees it. */
int operator_stencil(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                     const double *kappa, int reach[DIM_MAX], double **weight, struct failure *why);

/* A (n x n, row by row) of an operator with rows (assembly.h). */
void operator_dense(const struct heat_operator *a, double *A);

/* Upper bound of |lambda| over the spectrum of A, s^-1 (Gershgorin). */
double operator_bound(const struct heat_operator *a);

#endif
