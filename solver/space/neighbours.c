/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cell-linked list.  Points are sorted into square or cubic cells at least as wide as the radius, so all neighbours
 * of a point are in its own cell and the adjacent ones. */
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>

/* Cell of point i, by axis. */
static void cell_coordinates(const struct neighbours *nb, size_t i, int at[DIM_MAX]) {
    double x[DIM_MAX];
    layout_cloud_place(nb->cloud, i, x);
    for (int a = 0; a < DIM_MAX; a++) at[a] = (int)((x[a] - nb->lo[a]) / nb->cell);
}

static size_t cell_of(const struct neighbours *nb, size_t i) {
    int at[DIM_MAX];
    cell_coordinates(nb, i, at);
    return ((size_t)at[2] * (size_t)nb->cells[1] + (size_t)at[1]) * (size_t)nb->cells[0] + (size_t)at[0];
}

/* A width of at most 7 n + 1 cells (3 n + 1 in the plane): with n points, none of the extents, areas and the volume
 * of the box about them has more than n of its powers. */
static double least_cell(const double extent[DIM_MAX], double n) {
    double cell = 0;
    for (int a = 0; a < DIM_MAX; a++)
        cell = fmax(cell, fmax(extent[a] / n, sqrt(extent[a] * extent[(a + 1) % DIM_MAX] / n)));
    return fmax(cell, cbrt(extent[0] * extent[1] * extent[2] / n));
}

/* Coordinates by cells: the points of a run then follow each other in memory, and distances are computed several at a
 * time. */
static void copy_places(struct neighbours *nb) {
    const size_t n = nb->cloud->total;
    double x[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) nb->x[a] = xcalloc(n, sizeof *nb->x[a]);
    for (size_t k = 0; k < n; k++) {
        layout_cloud_place(nb->cloud, nb->point[k], x);
        for (int a = 0; a < DIM_MAX; a++) nb->x[a][k] = x[a];
    }
}

void neighbours_create(struct neighbours *nb, const struct cloud *c, double radius) {
    double lo[DIM_MAX], hi[DIM_MAX], extent[DIM_MAX], x[DIM_MAX];
    layout_cloud_place(c, 0, lo);
    layout_cloud_place(c, 0, hi);
    for (size_t i = 1; i < c->total; i++) {
        layout_cloud_place(c, i, x);
        for (int a = 0; a < DIM_MAX; a++) lo[a] = fmin(lo[a], x[a]), hi[a] = fmax(hi[a], x[a]);
    }
    for (int a = 0; a < DIM_MAX; a++) extent[a] = hi[a] - lo[a];
    *nb =
        (struct neighbours){.cloud = c, .radius = radius, .cell = fmax(radius, least_cell(extent, (double)c->total))};
    for (int a = 0; a < DIM_MAX; a++) nb->lo[a] = lo[a], nb->cells[a] = (int)(extent[a] / nb->cell) + 1;
    size_t cells = (size_t)nb->cells[0] * (size_t)nb->cells[1] * (size_t)nb->cells[2];
    nb->start = xcalloc(cells + 2, sizeof *nb->start);
    nb->point = xcalloc(c->total, sizeof *nb->point);
    /* counting sort: while cell k fills, start[k + 1] moves from its beginning to its end */
    for (size_t i = 0; i < c->total; i++) nb->start[cell_of(nb, i) + 2]++;
    for (size_t k = 2; k < cells + 2; k++) nb->start[k] += nb->start[k - 1];
    for (size_t i = 0; i < c->total; i++) nb->point[nb->start[cell_of(nb, i) + 1]++] = (uint32_t)i;
    copy_places(nb);
}

void neighbours_free(struct neighbours *nb) {
    free(nb->start);
    free(nb->point);
    for (int a = 0; a < DIM_MAX; a++) free(nb->x[a]);
    *nb = (struct neighbours){0};
}

int neighbours_runs(const struct neighbours *nb, size_t i, uint32_t begin[NEIGHBOURS_RUNS],
                    uint32_t end[NEIGHBOURS_RUNS]) {
    int at[DIM_MAX], from[DIM_MAX], to[DIM_MAX], runs = 0;
    cell_coordinates(nb, i, at);
    for (int a = 0; a < DIM_MAX; a++) {
        from[a] = at[a] > 0 ? at[a] - 1 : 0;
        to[a] = at[a] + 1 < nb->cells[a] ? at[a] + 1 : nb->cells[a] - 1;
    }
    for (int k = from[2]; k <= to[2]; k++)
        for (int j = from[1]; j <= to[1]; j++) {
            const uint32_t *row = nb->start + ((size_t)k * (size_t)nb->cells[1] + (size_t)j) * (size_t)nb->cells[0];
            begin[runs] = row[from[0]], end[runs++] = row[to[0] + 1];
        }
    return runs;
}

/* m^2, squares of the distances of the points begin to begin + n - 1 from x. */
static void squares(const struct neighbours *nb, const double x[DIM_MAX], uint32_t begin, uint32_t n,
                    double *square) {
    const double *X = nb->x[0] + begin, *Y = nb->x[1] + begin, *Z = nb->x[2] + begin;
    for (uint32_t k = 0; k < n; k++) {
        double dx = X[k] - x[0], dy = Y[k] - x[1], dz = Z[k] - x[2];
        square[k] = dx * dx + dy * dy + dz * dz;
    }
}

size_t neighbours_find(const struct neighbours *nb, size_t i, uint32_t *out, size_t most) {
    enum { CHUNK = 64 };
    double x[DIM_MAX], square[CHUNK];
    /* Lattice neighbours at exactly the radius must not depend on round-off; they are excluded, since the kernel is
     * zero. */
    const double radius2 = nb->radius * nb->radius * (1 - 1e-12);
    uint32_t begin[NEIGHBOURS_RUNS], end[NEIGHBOURS_RUNS];
    const int runs = neighbours_runs(nb, i, begin, end);
    size_t found = 0;
    layout_cloud_place(nb->cloud, i, x);
    for (int r = 0; r < runs; r++)
        for (uint32_t at = begin[r]; at < end[r]; at += CHUNK) {
            const uint32_t n = end[r] - at < CHUNK ? end[r] - at : CHUNK, *point = nb->point + at;
            squares(nb, x, at, n, square);
            /* One in seven points is within the radius: counting without a branch is faster than a branch that is
             * often predicted wrongly. */
            for (uint32_t k = 0; k < n; k++) {
                if (found < most) out[found] = point[k];
                found += (square[k] < radius2) & (point[k] != i);
            }
        }
    return found;
}
