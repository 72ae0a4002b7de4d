/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_VORONOI_H
#define HEATLADDER_SOLVER_SPACE_VORONOI_H

#include "solver/space/layout.h"

/* The Voronoi cells of a cloud: what is nearer to a particle than to any other particle or ghost. */

struct voronoi {
    size_t n;        /* cells, one for each particle */
    size_t *begin;   /* n + 1: where each cell's faces begin */
    uint32_t *point; /* begin[n]: the particle or ghost beyond each face */
    double *face;    /* m^(d-1), begin[n]: the same bits from either side of a pair of particles */
    double *volume;  /* m^d, n */
    double *beyond;  /* n: the part of each cell beyond the interface, 0 to 1; NULL with one material */
    size_t bytes;    /* of the arrays above */
};

/* The metric where heat spreads as fast along x as along y: places count scale[a] x_a, scale[0] scale[1] = 1, so that
 * volumes are those in m^2.  scale[0] = (k_y/k_x)^(1/4). */
void voronoi_metric(const struct material *m, int dim, double scale[2]);

/* Cells in that metric of the first material; faces are lengths in it.  STATUS_NUMERICAL names the first particle
 * that has another at its place, or a cell with no end within the reach of the cloud's ghosts.  End with
 * voronoi_free. */
int voronoi_create(struct voronoi *v, const struct problem *p, const struct cloud *c, int threads,
                   struct failure *why);
void voronoi_free(struct voronoi *v);

/* T[i], K: the mean of the initial data over each cell, weighted with the heat capacity; c->n of them. */
int voronoi_average(const struct problem *p, const struct cloud *c, int threads, double *T, struct failure *why);

#endif
