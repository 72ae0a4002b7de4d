/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cell-linked list.  Points are sorted into square cells at least as wide as the radius, so all neighbours of a
 * point are in its own cell and the adjacent ones. */
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>

static size_t cell_of(const struct neighbours *nb, double x, double y) {
    size_t i = (size_t)((x - nb->lo[0]) / nb->cell), j = (size_t)((y - nb->lo[1]) / nb->cell);
    return j * (size_t)nb->cells[0] + i;
}

void neighbours_create(struct neighbours *nb, const struct cloud *c, double radius) {
    double lo[2] = {c->x[0], c->y[0]}, hi[2] = {c->x[0], c->y[0]};
    for (size_t i = 1; i < c->total; i++) {
        lo[0] = fmin(lo[0], c->x[i]), hi[0] = fmax(hi[0], c->x[i]);
        lo[1] = fmin(lo[1], c->y[i]), hi[1] = fmax(hi[1], c->y[i]);
    }
    double width = hi[0] - lo[0], height = hi[1] - lo[1], n = (double)c->total;
    double cell = fmax(sqrt(width * height / n), fmax(width, height) / n); /* at most 3 n + 1 cells */
    *nb = (struct neighbours){.cloud = c, .radius = radius, .cell = fmax(radius, cell), .lo = {lo[0], lo[1]}};
    for (int a = 0; a < 2; a++) nb->cells[a] = (int)((hi[a] - lo[a]) / nb->cell) + 1;
    size_t cells = (size_t)nb->cells[0] * (size_t)nb->cells[1];
    nb->start = xcalloc(cells + 2, sizeof *nb->start);
    nb->point = xcalloc(c->total, sizeof *nb->point);
    /* counting sort: while cell k fills, start[k + 1] moves from its beginning to its end */
    for (size_t i = 0; i < c->total; i++) nb->start[cell_of(nb, c->x[i], c->y[i]) + 2]++;
    for (size_t k = 2; k < cells + 2; k++) nb->start[k] += nb->start[k - 1];
    for (size_t i = 0; i < c->total; i++) nb->point[nb->start[cell_of(nb, c->x[i], c->y[i]) + 1]++] = (uint32_t)i;
}

void neighbours_free(struct neighbours *nb) {
    free(nb->start);
    free(nb->point);
    *nb = (struct neighbours){0};
}

int neighbours_runs(const struct neighbours *nb, size_t i, uint32_t begin[3], uint32_t end[3]) {
    const struct cloud *c = nb->cloud;
    int at[2] = {(int)((c->x[i] - nb->lo[0]) / nb->cell), (int)((c->y[i] - nb->lo[1]) / nb->cell)}, runs = 0;
    int first = at[0] > 0 ? at[0] - 1 : 0, last = at[0] + 1 < nb->cells[0] ? at[0] + 1 : nb->cells[0] - 1;
    for (int j = at[1] > 0 ? at[1] - 1 : 0; j <= at[1] + 1 && j < nb->cells[1]; j++) {
        const uint32_t *row = nb->start + (size_t)j * (size_t)nb->cells[0];
        begin[runs] = row[first], end[runs++] = row[last + 1];
    }
    return runs;
}

size_t neighbours_find(const struct neighbours *nb, size_t i, uint32_t *out, size_t most) {
    const struct cloud *c = nb->cloud;
    /* Lattice neighbours at exactly the radius must not depend on round-off; they are excluded, since the kernel is
     * zero. */
    double radius2 = nb->radius * nb->radius * (1 - 1e-12);
    uint32_t begin[3], end[3];
    int runs = neighbours_runs(nb, i, begin, end);
    size_t found = 0;
    for (int r = 0; r < runs; r++)
        for (uint32_t k = begin[r]; k < end[r]; k++) {
            uint32_t j = nb->point[k];
            double dx = c->x[j] - c->x[i], dy = c->y[j] - c->y[i];
            if (j == i || dx * dx + dy * dy >= radius2) continue;
            if (found < most) out[found] = j;
            found++;
        }
    return found;
}
