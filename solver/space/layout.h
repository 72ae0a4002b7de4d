/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_LAYOUT_H
#define HEATLADDER_SOLVER_SPACE_LAYOUT_H

#include "solver/method.h"
#include "solver/problem.h"

#include <stdint.h>

/* Positions of the particles, and their ghosts beyond the walls: T_ghost = factor T_source + offset. */

struct lattice {
    int dim;
    int n[DIM_MAX];        /* number of unknowns by axis; 1 past dim */
    double dx[DIM_MAX];    /* m; 1 past dim */
    double first[DIM_MAX]; /* m, position of unknown 0 */
    /* Ghosts k = 1, 2, ... beyond side s: */
    int shift[SIDES];     /* ghost k mirrors unknown k - 1 + shift[s], counted from that side; a negative index is the
                             wall itself */
    int sign[SIDES];      /* -1: odd; 1: even; 0: ghosts have the wall's value; LAYOUT_RECURRENCE: see `factor` */
    double factor[SIDES]; /* T_-1 = factor T_0 and T_-k-1 = factor (T_-k + T_k) - T_k-1, plus offsets */
};

enum { LAYOUT_RECURRENCE = 2 };

/* m: the spacing that the options ask for along an axis: dx, for the matched run times sqrt(k_a / k_x). */
double layout_spacing(const struct problem *p, const struct options *o, int axis);

/* The lattice for the options dx and layout (LAYOUT_JITTER: before the displacement).  Refuses a dx that does not
 * divide the domain, and names the nearest that do. */
int layout_lattice(const struct problem *p, const struct options *o, struct lattice *l, struct failure *why);

/* Number of rows along y of a hexagonal cloud of spacing dx (m) in a height (m). */
double layout_hexagonal_rows(double height, double dx);

/* Position of unknown (i, j, k), m, 0 past dim; the indices may be outside. */
void layout_position(const struct lattice *l, int i, int j, int k, double x[DIM_MAX]);

/* Volume of a cell, m^dim. */
double layout_volume(const struct lattice *l);

/* The material at x (m).  A point within round-off of the interface belongs to the second one. */
int layout_material(const struct problem *p, double x);

/* Fraction of a cell of this width (m) about x beyond the interface, 0 to 1.  It is 0 or 1 if the interface misses
 * the cell within round-off, or if the width is 0. */
double layout_beyond(const struct problem *p, double width, double x);

/* m: with a contact resistance, the width of its own material that a particle on a rod has (at x, in cells of this
 * width): its cell, or up to the interface if it is the first one on its side, since T jumps there; *middle, m. */
double layout_part(const struct problem *p, double width, double x, double *middle);

/* J m^-3 K^-1: average heat capacity of such a cell, or of such a part, over the width of the cell. */
double layout_rho_c(const struct problem *p, double width, double x);

/* m: cell width of the particles on a lattice; 0 on clouds, in which each particle has one material. */
double layout_cell(const struct options *o, double spacing);

/* Factor of the source in its mirror image at the distance d (m) beyond a wall: -1 for a given temperature, 1 for a
 * given flux, (k - b d)/(k + b d) for an exchange b (T_a - T), without overflow for large b. */
double layout_image_factor(const struct problem *p, int side, double k, double d);

/* Offset of the ghost at `ghost`, K, with T_ghost = sign T_source + offset, for the source at `source` (m). side[a]
 * is the side beyond which it is along axis a, or -1.  At edges and corners the result is the mean over all orders of
 * reflection, which differ if the sides do. l: the lattice of the ghost; NULL in a cloud. */
double layout_ghost_offset(const struct problem *p, enum walls walls, const struct lattice *l, const int *side,
                           const double *ghost, const double *source);

/* Particles off the lattice, ordered by cells of side `reach`, followed by their ghosts. */
struct cloud {
    int dim;
    size_t n, total;   /* number of particles; of particles and ghosts */
    double *x, *y, *z; /* m, total each; y is all zero for a rod, z is NULL but in space */
    uint32_t *source;  /* total; i for particle i */
    double *factor;    /* total */
    double *offset;    /* K, total */
    double volume;     /* m^dim, volume of each particle; their mean if they differ */
    double reach;      /* m, distance from the domain up to which there are ghosts */
    /* For a lattice cut by the walls, else NULL: */
    double *cell;        /* m^dim, n: volume of each particle's cell inside the body */
    unsigned char *held; /* n: 1 for a particle on a Dirichlet wall, which keeps the wall's value */
    /* Points j >= n are then dummies: T_j = sum share[k] T_from[k] + offset[j], k = begin[j - n] to begin[j - n + 1]
     * - 1.  If `away`, their distance from the wall in m, is set, T_j differs from pair to pair (--walls
     * distance). */
    size_t *begin;
    uint32_t *from;
    double *share, *away;
};

/* Position of point i of a cloud, m; 0 past dim. */
static inline void layout_cloud_place(const struct cloud *c, size_t i, double x[DIM_MAX]) {
    x[0] = c->x[i], x[1] = c->y[i], x[2] = c->z ? c->z[i] : 0;
}
static inline void layout_cloud_put(struct cloud *c, size_t i, const double x[DIM_MAX]) {
    c->x[i] = x[0], c->y[i] = x[1];
    if (c->z) c->z[i] = x[2];
}

/* Allocates the first six arrays for this many points. */
void layout_cloud_alloc(struct cloud *c, size_t points);

/* The particles of a layout and every ghost within `reach` (m) of the domain.  Returns STATUS_INPUT if the domain is
 * narrower than `reach`, STATUS_NUMERICAL if a relaxation does not converge. */
int layout_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                 struct cloud *c, struct failure *why);
void layout_cloud_free(struct cloud *c);

/* 1 if walls cut the lattice at any position: its particles are then the lattice points inside the body. */
#define LAYOUT_ON_WALL 1e-6 /* dx: a point closer to a wall is on it */
int layout_is_cut(const struct problem *p, const struct options *o);

/* The offset of the image j >= c->n beyond plane walls, K. */
double layout_image_offset(const struct problem *p, const struct options *o, const struct cloud *c, size_t j);

/* Moves the n particles of *c apart until they settle; ignores ghosts. spacing, m: V^(1/dim).  Returns
 * STATUS_NUMERICAL with the last displacement if o->sweeps do not suffice.  The result does not depend on the number
 * of threads. */
int relax_cloud(const struct problem *p, const struct options *o, double spacing, struct cloud *c,
                struct failure *why);

#endif
