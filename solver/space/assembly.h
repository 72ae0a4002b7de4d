/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_ASSEMBLY_H
#define HEATLADDER_SOLVER_SPACE_ASSEMBLY_H

#include "solver/space/neighbours.h"
#include "solver/space/operator.h"
#include "solver/space/voronoi.h"

/* The neighbourhood of one point of a cloud for a scheme, and the operator with a row for each particle. */

struct assembly {
    const struct problem *p;
    const struct options *o;
    const struct scheme *s;
    const struct cloud *c;
    struct neighbours cells; /* empty if there is a mesh */
    struct neighbours wide;  /* within assembly_widest, for --walls one_sided; else empty */
    struct voronoi mesh;     /* for schemes with cells */
    double h, support;       /* m */
    double volume;           /* m^dim */
    double cell;             /* m, see layout_cell */
};

struct surroundings {
    struct neighbourhood nb;
    uint32_t near[NEIGHBOURS_MAX]; /* indices of its neighbours */
    double d[NEIGHBOURS_MAX][DIM_MAX], X[NEIGHBOURS_MAX];
};

/* spacing, m: unit of the option h.  Returns STATUS_NUMERICAL if a scheme with cells has none on this cloud; nothing
 * is allocated then. */
int assembly_create(struct assembly *m, const struct problem *p, const struct options *o, const struct scheme *s,
                    const struct cloud *c, double spacing, struct failure *why);
void assembly_free(struct assembly *m);

/* The neighbourhood of point i.  Returns STATUS_NUMERICAL if it has more than NEIGHBOURS_MAX neighbours. */
int assembly_neighbourhood(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why);

/* h: maximum extent of searches beside a wall, for h in dx: 3, and in space at most a ball of 905 particles. */
double assembly_widest(int dim, double h);

/* The operator for the particles of c; spacing (m) is the unit of the option h.  Ghosts enter the columns of their
 * sources.  Returns STATUS_NUMERICAL for the first particle without weights. */
int assembly_operator(struct heat_operator *a, const struct problem *p, const struct options *o,
                      const struct scheme *s, const struct cloud *c, double spacing, struct failure *why);

/* g (one value per particle) of that operator at the time t, s: the source and a->images. */
void assembly_constants(const struct heat_operator *a, const struct problem *p, const struct options *o, double t,
                        double *g);

#endif
