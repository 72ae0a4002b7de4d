/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_ASSEMBLY_H
#define HEATLADDER_SOLVER_SPACE_ASSEMBLY_H

#include "solver/space/neighbours.h"
#include "solver/space/operator.h"
#include "solver/space/voronoi.h"

/* Input of row assembly, and the neighbourhood of one point for a scheme. */

enum { ASSEMBLY_BLOCKS = 64 }; /* each filled by one thread; their number does not depend on it */

/* Calls work(context, b, begin, end, why) for each block b of n points on the given number of threads.  Returns the
 * failure of the first block that fails. */
int assembly_in_blocks(size_t n, int threads,
                       int (*work)(void *context, int b, size_t begin, size_t end, struct failure *why),
                       void *context, struct failure *why);

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

struct assembly_list { /* entries of the points of a block, one point after the other */
    size_t n, room;
    uint32_t *point;
    double *value;
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

/* J m^-3 K^-1, heat capacity of particle i's cell. */
double assembly_rho_c(const struct assembly *m, size_t i);

/* Dummy temperatures of Morris, Fox & Zhu (1997), extrapolated for each pair: T_j = T_w + (1 - stretch) (T_i - T_w),
 * stretch = 1 + d_j/d_i with the distances from the wall, at most 1.5. */
double assembly_stretch(const struct assembly *m, size_t i, uint32_t j);

/* The neighbourhood of point i.  Returns STATUS_NUMERICAL if it has more than NEIGHBOURS_MAX neighbours. */
int assembly_neighbourhood(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why);

/* h: maximum extent of searches beside a wall, for h in dx: 3, and in space at most a ball of 905 particles. */
double assembly_widest(int dim, double h);

/* 1 if --walls one_sided determines the row of particle i: it is within the support of a wall. */
int assembly_at_wall(const struct assembly *m, size_t i);

void assembly_list_grow(struct assembly_list *l); /* doubles the capacity */

/* Appends an entry. */
static inline void assembly_list_add(struct assembly_list *l, uint32_t point, double value) {
    if (l->n == l->room) assembly_list_grow(l);
    l->point[l->n] = point;
    l->value[l->n++] = value;
}

/* Joins the entries of all blocks, in order, into arrays owned by the caller; returns their number.  Each block is
 * freed once copied, to limit peak memory.  On entry
 * begin[i + 1] is the number of entries of point i < n, on return the end of its entries. */
size_t assembly_list_join(struct assembly_list part[ASSEMBLY_BLOCKS], size_t n, size_t *begin, uint32_t **point,
                          double **value);
void assembly_list_free(struct assembly_list part[ASSEMBLY_BLOCKS]);

/* Adds the source to g (one value per particle of the cloud), K s^-1. *a takes g over if any value is not zero. */
void assembly_keep_constants(const struct assembly *m, double *g, struct heat_operator *a);

#endif
