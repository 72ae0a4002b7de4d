/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_NEIGHBOURS_H
#define HEATLADDER_SOLVER_SPACE_NEIGHBOURS_H

#include "solver/space/layout.h"

/* Cell-linked list: all points within a radius, in O(1) a point after O(N) once (Hockney & Eastwood 1981). */

struct neighbours {
    const struct cloud *cloud; /* borrowed */
    double radius;             /* m */
    double cell;  /* m, the side of a cell: the radius, or more where that makes many more cells than points */
    double lo[2]; /* m */
    int cells[2];
    uint32_t *start; /* cells + 1: where each cell's points begin in `point` */
    uint32_t *point; /* cloud->total */
};

/* Sorts the points of *c, ghosts among them, into cells; radius in m.  End with neighbours_free. */
void neighbours_create(struct neighbours *nb, const struct cloud *c, double radius);
void neighbours_free(struct neighbours *nb);

/* The points of the cells around point i, itself among them: nb->point[k] for begin[r] <= k < end[r], r below the
 * count returned, at most 3. */
int neighbours_runs(const struct neighbours *nb, size_t i, uint32_t begin[3], uint32_t end[3]);

/* Indices of the points nearer than the radius to point i, i itself left out, into out[most].  Returns how many there
 * are, which may be more than `most`. */
size_t neighbours_find(const struct neighbours *nb, size_t i, uint32_t *out, size_t most);

#endif
