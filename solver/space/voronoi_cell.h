/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_VORONOI_CELL_H
#define HEATLADDER_SOLVER_SPACE_VORONOI_CELL_H

#include <stddef.h>
#include <stdint.h>

/* One cell: a polygon about the origin, cut by the bisectors of the points around it. */

enum { VORONOI_CORNERS = 64 }; /* per cell: about 6 on average, rarely 20 */
#define VORONOI_NONE UINT32_MAX

struct voronoi_polygon { /* convex, counterclockwise about the particle; edge k leads from corner k to the next */
    int n;
    double x[VORONOI_CORNERS], y[VORONOI_CORNERS];
    uint32_t edge[VORONOI_CORNERS]; /* the point of its bisector */
    double farthest;                /* m^2, squared distance of the farthest corner */
};

struct voronoi_candidate {
    double d[2], r2; /* m, m^2 */
    uint32_t point;
};

struct voronoi_candidates {
    size_t n, room;
    struct voronoi_candidate *at; /* the caller frees it */
};

/* Adds the point at d. */
void voronoi_cell_offer(struct voronoi_candidates *c, const double d[2], uint32_t point);

/* The cell among these points, which are reordered, inside a square of half width `half`; on a rod a polygon of
 * height 1.  Returns 0, or -1 if a point is at the origin or there are more than VORONOI_CORNERS corners. */
int voronoi_cell_make(int dim, struct voronoi_candidates *c, double half, struct voronoi_polygon *cell);

/* Removes the part beyond a x + b y = c if it extends by more than `touch` (in the unit of c).  Returns 0, or -1
 * above VORONOI_CORNERS. */
int voronoi_cell_cut(struct voronoi_polygon *p, double a, double b, double c, double touch, uint32_t edge);

double voronoi_cell_area(const struct voronoi_polygon *p);
int voronoi_cell_closes(const struct voronoi_polygon *p); /* 1 if each edge is a bisector */

/* The cell about the origin among n points at d (m, in the metric): face[n], m^(dim-1), and *volume, m^dim.  Returns
 * 0, or -1 if the points do not close it. */
int voronoi_cell(int dim, size_t n, double (*d)[2], double *face, double *volume);

#endif
