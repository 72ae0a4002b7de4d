/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_WALLS_H
#define HEATLADDER_SOLVER_PARTICLES_WALLS_H

/* Values of the dummies of a cut lattice: linear combinations of particles plus a constant. */

#include "solver/particles/ssph.h"
#include "solver/shape.h"
#include "solver/space/assembly.h"

/* Particles that a quadratic at a wall requires, by dim (walls_fit.c). */
static const size_t walls_least[] = {0, 4, 15, 60};

struct wall_site {        /* the wall at a dummy; several at an edge or a corner */
    double x[DIM_MAX];    /* m, the dummy */
    double foot[DIM_MAX]; /* m, nearest point of the body */
    int walls;            /* 1 to dim */
    enum side side[DIM_MAX];
    double normal[DIM_MAX][DIM_MAX]; /* outward, of each wall */
    double away[DIM_MAX];            /* m, distance of the dummy from each wall */
    double value[DIM_MAX];           /* problem.wall at the foot */
    double k[DIM_MAX];               /* W m^-1 K^-1, along each normal */
};

/* The axis along which a normal points, or nearly so. */
static inline int walls_axis(const double normal[DIM_MAX]) {
    int axis = 0;
    for (int a = 1; a < DIM_MAX; a++)
        if (normal[a] * normal[a] > 0.5) axis = a;
    return axis;
}

struct wall_near { /* particles near a point, for a least-squares fit */
    struct neighbourhood nb;
    uint32_t from[NEIGHBOURS_MAX];
    double d[NEIGHBOURS_MAX][DIM_MAX]; /* m */
};

struct walls_fill { /* input of the treatments */
    const struct problem *p;
    const struct options *o;
    const struct cloud *c;
    double spacing;      /* m, unit of the option h */
    double widest;       /* h, maximum extent of a search */
    struct cloud *probe; /* the particles, followed by one point for each dummy: a foot or an image */
    struct neighbours cells;
};

struct wall_sum { /* T of a dummy, sum share[k] T_from[k] + offset */
    size_t n;
    uint32_t from[NEIGHBOURS_MAX];
    double share[NEIGHBOURS_MAX];
    double offset; /* K */
};

struct wall_treatment {
    unsigned kinds; /* bits of enum side_kind: supported boundary conditions */
    int pairs;      /* 1: T differs from pair to pair (struct cloud, `away`) */
    /* The point near which particles are required for dummy d, m; NULL if none are required. */
    void (*place)(const struct wall_site *site, double x[DIM_MAX]);
    /* STATUS_NUMERICAL if there are too few particles nearby. */
    int (*fill)(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why);
};

extern const struct wall_treatment walls_fixed, walls_distance, walls_average, walls_image, walls_fit;

/* Bits of enum side_kind: the boundary conditions supported by these walls. */
unsigned walls_kinds(enum walls walls);

/* Sets the values of the dummies of *c by the treatment of the options. */
int walls_fill(const struct problem *p, const struct options *o, struct cloud *c, double spacing,
               struct failure *why);

/* `at_wall` (operator.h) of SSPH, by its own least squares. */
int walls_one_sided(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                    struct wall_row *out, struct failure *why);

/* Searches the particles within 2 H of the point of dummy d.  H starts at h and grows by tenths until there are at
 * least `least` particles and `attempt` succeeds.  Returns STATUS_OK or the last failure of `attempt`. */
int walls_near(const struct walls_fill *w, size_t d, size_t least,
               int (*attempt)(const struct walls_fill *w, const struct wall_near *near, void *with,
                              struct failure *why),
               void *with, struct failure *why);

#endif
