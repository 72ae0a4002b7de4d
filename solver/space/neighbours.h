/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_NEIGHBOURS_H
#define HEATLADDER_SOLVER_SPACE_NEIGHBOURS_H

#include "solver/space/layout.h"

/* Cell-linked list: all points within a radius in O(1) per point, after O(N) set-up (Hockney & Eastwood 1981). */

enum { NEIGHBOURS_RUNS = 9 }; /* rows of cells around a cell, in space; 3 in the plane */

struct neighbours {
    const struct cloud *cloud; /* borrowed */
    double radius;             /* m */
    double cell;        /* m, width of a cell: the radius, or more if that would give many more cells than points */
    double lo[DIM_MAX]; /* m */
    int cells[DIM_MAX]; /* 1 past dim */
    uint32_t *start;    /* cells + 1: start of each cell in `point` */
    uint32_t *point;    /* cloud->total */
    double *x[DIM_MAX]; /* m, cloud->total each: coordinates of `point` */
};

/* Sorts the points of *c, including ghosts, into cells; radius in m.  Release with neighbours_free. */
void neighbours_create(struct neighbours *nb, const struct cloud *c, double radius);
void neighbours_free(struct neighbours *nb);

/* The points in the cells around point i, including itself: nb->point[k] for begin[r] <= k < end[r], for r below the
 * returned count. */
int neighbours_runs(const struct neighbours *nb, size_t i, uint32_t begin[NEIGHBOURS_RUNS],
                    uint32_t end[NEIGHBOURS_RUNS]);

/* Writes the indices of the points within the radius of point i, excluding i, to out[most]; entries past the
 * last may be overwritten.  Returns their number, which may exceed `most`. */
size_t neighbours_find(const struct neighbours *nb, size_t i, uint32_t *out, size_t most);

#endif
