#ifndef HEATLADDER_SOLVER_SPACE_ASSEMBLY_H
#define HEATLADDER_SOLVER_SPACE_ASSEMBLY_H

#include "solver/space/neighbours.h"
#include "solver/space/operator.h"

/* What rows and gradients are assembled from, and what a scheme sees of one point of it. */

enum { ASSEMBLY_BLOCKS = 64 }; /* of points, each filled by one thread: the same for any number of threads */

struct assembly {
    const struct problem *p;
    const struct options *o;
    const struct scheme *s;
    const struct cloud *c;
    struct neighbours cells;
    double h, support; /* m */
    double volume;     /* m^d */
    double cell;       /* m, as layout_cell */
};

struct surroundings {
    struct neighbourhood nb;
    uint32_t near[NEIGHBOURS_MAX]; /* the points of its neighbours */
    double d[NEIGHBOURS_MAX][2], V[NEIGHBOURS_MAX], H[NEIGHBOURS_MAX];
};

/* spacing, m: what the h of the options counts in. */
void assembly_create(struct assembly *m, const struct problem *p, const struct options *o, const struct scheme *s,
                     const struct cloud *c, double spacing);
void assembly_free(struct assembly *m);

/* The neighbourhood of point i.  STATUS_NUMERICAL where it has more neighbours than are held. */
int assembly_look(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why);

/* g (n of the cloud's particles) += the source's part, K s^-1; it becomes *a's where any of it is not zero. */
void assembly_keep_constants(const struct assembly *m, double *g, struct heat_operator *a);

#endif
