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

#endif
