/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_VORONOI_H
#define HEATLADDER_SOLVER_SPACE_VORONOI_H

#include "solver/space/layout.h"

/* The Voronoi cells of a cloud: the points closer to a particle than to any other particle or ghost. */

struct voronoi {
    size_t n;        /* number of cells, one per particle */
    size_t *begin;   /* n + 1: start of each cell's faces */
    uint32_t *point; /* begin[n]: the particle or ghost across each face */
    double *face;    /* m^(dim-1), begin[n]: the same bits from both particles of a pair */
    double *volume;  /* m^dim, n */
    double *beyond;  /* n: fraction of each cell beyond the interface, 0 to 1; NULL with one material */
    size_t bytes;    /* size of the arrays above */
};

/* The metric in which heat spreads isotropically: positions are scale[a] x_a with scale[0] scale[1] = 1, so that
 * volumes are those in m^2. scale[0] = (k_y/k_x)^(1/4). */
void voronoi_metric(const struct material *m, int dim, double scale[2]);

/* Cells in the metric of the first material; faces are lengths in it.  STATUS_NUMERICAL names the first particle
 * that coincides with another, or has an open cell within the reach of the cloud's ghosts.  Release with
 * voronoi_free. */
int voronoi_create(struct voronoi *v, const struct problem *p, const struct cloud *c, int threads,
                   struct failure *why);
void voronoi_free(struct voronoi *v);

/* T[i], K: average of the initial data over each of the c->n cells, weighted with the heat capacity. */
int voronoi_average(const struct problem *p, const struct cloud *c, int threads, double *T, struct failure *why);

/* ---- Parts ---- */

/* A cell: a polygon about the origin, cut by the bisectors of the points around it. */

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

/* The part of a cell between two circles about 0. */
struct voronoi_round {
    double face[VORONOI_CORNERS]; /* m, by edge */
    double wall[2];               /* m, arc length of the inner and the outer circle inside the cell */
    double area;                  /* m^2 */
    double farthest;              /* m^2, largest squared distance of an end of a face from the particle */
};

/* The cell of a particle at `at`; radius[0] may be 0. */
struct voronoi_round voronoi_round(const struct voronoi_polygon *cell, const double at[2], const double radius[2]);

#endif
