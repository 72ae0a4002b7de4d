/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_LAYOUT_H
#define HEATLADDER_SOLVER_SPACE_LAYOUT_H

#include "solver/method.h"
#include "solver/problem.h"

#include <stdint.h>

/* Where the particles are, and what their ghosts beyond the walls hold: T_ghost = factor T_source + offset. */

struct lattice {
    int dim;
    int n[2];        /* unknowns along x and y; n[1] = 1 for a rod */
    double dx[2];    /* m; dx[1] = 1 for a rod */
    double first[2]; /* m, position of unknown 0 */
    /* Ghosts k = 1, 2, ... beyond side s: */
    int shift[4];    /* mirror unknown k - 1 + shift[s], counted from that side; below 0 it is the wall itself */
    int sign[4];     /* -1: odd; 1: even; 0: they hold the wall's value; LAYOUT_ROBIN: as `robin` says */
    double robin[4]; /* T_-1 = robin T_0 and T_-k-1 = robin (T_-k + T_k) - T_k-1, and offsets */
};

enum { LAYOUT_ROBIN = 2 };

/* The lattice of the options dx and layout (the lattice under the jitter for LAYOUT_JITTER).  ratio = dy / dx.
 * STATUS_INPUT where dx does not divide the domain, naming the nearest that do. */
int layout_lattice(const struct problem *p, const struct options *o, double ratio, struct lattice *l,
                   struct failure *why);

/* Rows along y of a hexagonal cloud of spacing dx (m) in a height (m). */
double layout_hexagonal_rows(double height, double dx);

/* Position of unknown (i, j), which may lie outside; m. */
void layout_position(const struct lattice *l, int i, int j, double x[2]);

/* The material at x (m); at the interface, to rounding, the one beyond it. */
int layout_material(const struct problem *p, double x);

/* The part of a cell of this width (m) about x that lies beyond the interface: 0 to 1, and 0 or 1 where the interface
 * misses the cell to rounding, or where the width is 0. */
double layout_beyond(const struct problem *p, double width, double x);

/* J m^-3 K^-1: heat capacity of such a cell, averaged over its parts. */
double layout_rho_c(const struct problem *p, double width, double x);

/* m: the width of the particles' cells on a lattice; 0 on clouds, where a particle is of one material. */
double layout_cell(const struct options *o, double spacing);

/* (k - b d)/(k + b d), with no overflow where b is huge: what a ghost at the distance d (m) beyond a Robin side takes
 * of its source; 1 for another side. */
double layout_robin_factor(const struct problem *p, int side, double k, double d);

/* What the ghost at `ghost` adds to sign T_source, K, for the source at `source` (m).  side[a] is the side that it
 * lies beyond along axis a, or -1.  At a corner the two orders of reflection differ where the sides disagree: their
 * mean is taken.  l: the lattice that the ghost belongs to; NULL in a cloud. */
double layout_ghost_offset(const struct problem *p, enum walls walls, const struct lattice *l, const int side[2],
                           const double ghost[2], const double source[2]);

/* Particles off the lattice, in the order of cells of side `reach`, followed by their ghosts. */
struct cloud {
    int dim;
    size_t n, total;  /* particles; particles and ghosts */
    double *x, *y;    /* m, total each; y is all zero for a rod */
    uint32_t *source; /* total; of particle i: i */
    double *factor;   /* total */
    double *offset;   /* K, total */
    double volume;    /* m^d, of every particle; their mean where they differ */
    double reach;     /* m, ghosts fill the domain's surroundings this far */
    /* Of a lattice that walls cut anywhere, else NULL: */
    double *cell;        /* m^d, n: the part of each particle's cell inside the body */
    unsigned char *held; /* n: 1 for a particle on a Dirichlet wall, which holds the wall's value */
    /* Points from n on are then dummies, of k = begin[j - n] to begin[j - n + 1] - 1: T_j = sum share[k] T_from[k] +
     * offset[j].  With `away`, m, their distance from the wall, T_j differs from pair to pair (--walls distance). */
    size_t *begin;
    uint32_t *from;
    double *share, *away;
};

/* The particles of a layout (of a lattice: its own) and every ghost within `reach` (m) of the domain.
 * STATUS_INPUT where the domain is narrower than `reach`, STATUS_NUMERICAL where a relaxation does not settle. */
int layout_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                 struct cloud *c, struct failure *why);
void layout_cloud_free(struct cloud *c);

/* Whether walls cut the lattice anywhere: its particles are the lattice's points inside the body. */
#define LAYOUT_ON_WALL 1e-6 /* dx: a point nearer to a wall lies on it */
int layout_is_cut(const struct problem *p, const struct options *o);
/* The particles of such a lattice, and as dummies its points within `reach` (m) beyond the walls, which hold nothing
 * yet. STATUS_INPUT where no point is inside. */
int layout_cut(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
               struct cloud *c, struct failure *why);
/* Adds the images of particle i beyond plane walls, up to three, to the cloud, whose arrays have room for them. */
void layout_mirror(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                   struct cloud *c);

/* Moves the particles of *c (n of them; ghosts are not looked at) apart until they have settled.
 * spacing, m: V^(1/d).  STATUS_NUMERICAL, with how far it came, where o->sweeps do not suffice.
 * The same for any number of threads. */
int relax_cloud(const struct problem *p, const struct options *o, double spacing, struct cloud *c,
                struct failure *why);

#endif
