/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_ASSEMBLY_H
#define HEATLADDER_SOLVER_SPACE_ASSEMBLY_H

#include "solver/space/neighbours.h"
#include "solver/space/operator.h"
#include "solver/space/voronoi.h"

/* What rows are assembled from, and what a scheme sees of one point of it. */

enum { ASSEMBLY_BLOCKS = 64 }; /* of points, each filled by one thread: the same for any number of threads */

/* Calls work(context, b, begin, end, why) for each block b of n points, on so many threads.  The failure of the first
 * block that has one. */
int assembly_in_blocks(size_t n, int threads,
                       int (*work)(void *context, int b, size_t begin, size_t end, struct failure *why),
                       void *context, struct failure *why);

struct assembly {
    const struct problem *p;
    const struct options *o;
    const struct scheme *s;
    const struct cloud *c;
    struct neighbours cells; /* empty where there is a mesh */
    struct neighbours wide;  /* within 3 h, for --walls one_sided; else empty */
    struct voronoi mesh;     /* of a scheme with cells */
    double h, support;       /* m */
    double volume;           /* m^d */
    double cell;             /* m, as layout_cell */
};

struct assembly_list { /* what a block's points keep of their neighbours, one point after the other */
    size_t n, room;
    uint32_t *point;
    double *value;
};

struct surroundings {
    struct neighbourhood nb;
    uint32_t near[NEIGHBOURS_MAX]; /* the points of its neighbours */
    double d[NEIGHBOURS_MAX][2], X[NEIGHBOURS_MAX];
};

/* spacing, m: what the h of the options counts in.  STATUS_NUMERICAL for a cloud without cells, of a scheme that
 * has them; there is nothing to free then. */
int assembly_create(struct assembly *m, const struct problem *p, const struct options *o, const struct scheme *s,
                    const struct cloud *c, double spacing, struct failure *why);
void assembly_free(struct assembly *m);

/* J m^-3 K^-1, of particle i's cell. */
double assembly_rho_c(const struct assembly *m, size_t i);

/* Dummies that Morris, Fox & Zhu extrapolate for each pair (1997): T_j = T_w + (1 - stretch) (T_i - T_w), stretch = 1
 * + d_j/d_i by the distances from the wall, at most 1.5. */
double assembly_stretch(const struct assembly *m, size_t i, uint32_t j);

/* The neighbourhood of point i.  STATUS_NUMERICAL where it has more neighbours than are held. */
int assembly_neighbourhood(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why);

/* Whether --walls one_sided gives particle i its row: within the support of a wall. */
int assembly_at_wall(const struct assembly *m, size_t i);

void assembly_list_grow(struct assembly_list *l); /* to twice the room */

/* One entry more, at the end. */
static inline void assembly_list_add(struct assembly_list *l, uint32_t point, double value) {
    if (l->n == l->room) assembly_list_grow(l);
    l->point[l->n] = point;
    l->value[l->n++] = value;
}

/* The entries of all blocks, in their order, into arrays that the caller owns; returns how many.  begin[i + 1], i <
 * n, goes from the number of entries of point i to where they end. */
size_t assembly_list_join(const struct assembly_list part[ASSEMBLY_BLOCKS], size_t n, size_t *begin, uint32_t **point,
                          double **value);
void assembly_list_free(struct assembly_list part[ASSEMBLY_BLOCKS]);

/* g (n of the cloud's particles) += the source's part, K s^-1; it becomes *a's where any of it is not zero. */
void assembly_keep_constants(const struct assembly *m, double *g, struct heat_operator *a);

#endif
