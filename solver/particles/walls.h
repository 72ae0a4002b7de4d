/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_WALLS_H
#define HEATLADDER_SOLVER_PARTICLES_WALLS_H

/* Values of the dummies of a lattice that walls cut anywhere: linear combinations of particles and a constant. */

#include "solver/particles/ssph.h"
#include "solver/shape.h"
#include "solver/space/neighbours.h"

#define WALLS_WIDEST 3.0 /* h: as far as a search grows */

struct wall_site {  /* the wall at a dummy: two walls at the corner of a rectangle */
    double x[2];    /* m, the dummy */
    double foot[2]; /* m, the nearest point of the body */
    int walls;      /* 1 or 2 */
    enum side side[2];
    double normal[2][2]; /* outward, of each */
    double away[2];      /* m, distance of the dummy from each */
    double value[2];     /* as of problem.wall at the foot */
    double k[2];         /* W m^-1 K^-1, along each normal */
};

struct wall_near { /* particles around a place, as a least-squares fit sees them */
    struct neighbourhood nb;
    uint32_t from[NEIGHBOURS_MAX];
    double d[NEIGHBOURS_MAX][2]; /* m */
};

struct walls_fill { /* the input of treatments */
    const struct problem *p;
    const struct options *o;
    const struct cloud *c;
    double spacing;      /* m, what the h of the options counts in */
    struct cloud *probe; /* the particles and after them one place for each dummy: feet, or images */
    struct neighbours cells;
};

struct wall_sum { /* T of a dummy */
    size_t n;
    uint32_t from[NEIGHBOURS_MAX];
    double share[NEIGHBOURS_MAX];
    double offset; /* K */
};

struct wall_treatment {
    unsigned kinds; /* bits of enum side_kind that it takes */
    int pairs;      /* 1: T differs from pair to pair (struct cloud, `away`) */
    /* The place around which dummy d needs particles, m; NULL for a treatment that needs none. */
    void (*place)(const struct wall_site *site, double x[2]);
    /* STATUS_NUMERICAL where the particles around do not suffice. */
    int (*fill)(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why);
};

extern const struct wall_treatment walls_fixed, walls_distance, walls_average, walls_image, walls_fit;

/* Bits of enum side_kind: the kinds of walls that these can be. */
unsigned walls_kinds(enum walls walls);

/* Fills what the dummies of *c hold, by the treatment of the options. */
int walls_fill(const struct problem *p, const struct options *o, struct cloud *c, double spacing,
               struct failure *why);

/* The scheme's `at_wall` (operator.h) of SSPH, by its own least squares. */
int walls_one_sided(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                    struct wall_row *out, struct failure *why);

/* The particles around the place of dummy d within 2 H, H = h grown by tenths until there are `least` and `try` takes
 * them: STATUS_OK from it ends the search, and its last failure is that of the search. */
int walls_near(const struct walls_fill *w, size_t d, size_t least,
               int (*attempt)(const struct walls_fill *w, const struct wall_near *near, void *with,
                              struct failure *why),
               void *with, struct failure *why);

#endif
