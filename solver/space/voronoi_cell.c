/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One Voronoi cell by clipping (Rycroft 2009, Chaos 19:041111).  A square about the particle is cut by the bisectors
 * of its neighbours, up to twice the distance of the farthest vertex; no bisector beyond reaches the cell.
 *
 * A bisector that passes a vertex at less than TOUCH d does not cut, so that four particles on a circle (a lattice,
 * or any pair and its images) leave no face of the size of round-off. */
#include "solver/space/voronoi_cell.h"

#include "solver/status.h"

#include <math.h>
#include <stdlib.h>

static const double TOUCH = 1e-13;

static void start_square(struct voronoi_polygon *p, double half) {
    static const double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    p->n = 4, p->farthest = 2 * half * half;
    for (int k = 0; k < 4; k++) p->x[k] = half * x[k], p->y[k] = half * y[k], p->edge[k] = VORONOI_NONE;
}

int voronoi_cell_cut(struct voronoi_polygon *p, double a, double b, double c, double touch, uint32_t edge) {
    double s[VORONOI_CORNERS + 1], most = -HUGE_VAL;
    struct voronoi_polygon q;
    for (int k = 0; k < p->n; k++) {
        s[k] = a * p->x[k] + b * p->y[k] - c;
        most = s[k] > most ? s[k] : most;
    }
    if (most <= touch) return 0;
    s[p->n] = s[0];
    q.n = 0, q.farthest = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        if (q.n + 2 > VORONOI_CORNERS) return -1;
        if (s[k] <= 0) q.x[q.n] = p->x[k], q.y[q.n] = p->y[k], q.edge[q.n++] = p->edge[k];
        if ((s[k] <= 0) == (s[k + 1] <= 0)) continue;
        double t = s[k] / (s[k] - s[k + 1]);
        q.x[q.n] = p->x[k] + t * (p->x[next] - p->x[k]), q.y[q.n] = p->y[k] + t * (p->y[next] - p->y[k]);
        q.edge[q.n++] = s[k] <= 0 ? edge : p->edge[k];
    }
    p->n = q.n, p->farthest = 0;
    for (int k = 0; k < q.n; k++) {
        double r2 = q.x[k] * q.x[k] + q.y[k] * q.y[k];
        p->x[k] = q.x[k], p->y[k] = q.y[k], p->edge[k] = q.edge[k];
        p->farthest = r2 > p->farthest ? r2 : p->farthest;
    }
    return 0;
}

double voronoi_cell_area(const struct voronoi_polygon *p) {
    double twice = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        twice += p->x[k] * p->y[next] - p->x[next] * p->y[k];
    }
    return twice / 2;
}

int voronoi_cell_closes(const struct voronoi_polygon *p) {
    for (int k = 0; k < p->n; k++)
        if (p->edge[k] == VORONOI_NONE) return 0;
    return p->n > 2;
}

void voronoi_cell_offer(struct voronoi_candidates *c, const double d[2], uint32_t point) {
    if (c->n == c->room) {
        c->room = c->room ? 2 * c->room : 256;
        c->at = xcheck(realloc(c->at, c->room * sizeof *c->at), c->room, sizeof *c->at);
    }
    c->at[c->n++] = (struct voronoi_candidate){{d[0], d[1]}, d[0] * d[0] + d[1] * d[1], point};
}

/* Moves the `near` nearest points to the front, in ascending order. */
static void sort_nearest(struct voronoi_candidates *c, size_t near) {
    for (size_t k = 0; k < near && k < c->n; k++) {
        size_t least = k;
        for (size_t j = k + 1; j < c->n; j++)
            if (c->at[j].r2 < c->at[least].r2) least = j;
        struct voronoi_candidate held = c->at[k];
        c->at[k] = c->at[least], c->at[least] = held;
    }
}

enum { SORTED = 6 };

/* Cuts a square of half width `half` by all bisectors; the first ones cut most. */
static int cut_all(struct voronoi_candidates *c, double half, struct voronoi_polygon *cell) {
    sort_nearest(c, SORTED);
    start_square(cell, half);
    for (size_t k = 0; k < c->n; k++) {
        const struct voronoi_candidate *j = &c->at[k];
        if (!(j->r2 > 0)) return -1;
        if (j->r2 >= 4 * cell->farthest) continue;
        if (voronoi_cell_cut(cell, j->d[0], j->d[1], j->r2 / 2, TOUCH * j->r2, j->point)) return -1;
    }
    return 0;
}

/* On a rod: the nearest point on either side, as a polygon of height 1. */
static int cut_rod(const struct voronoi_candidates *c, struct voronoi_polygon *cell) {
    double side[2] = {-HUGE_VAL, HUGE_VAL};
    uint32_t point[2] = {VORONOI_NONE, VORONOI_NONE};
    for (size_t k = 0; k < c->n; k++) {
        double x = c->at[k].d[0];
        int s = x > 0;
        if (!(c->at[k].r2 > 0)) return -1;
        if (fabs(x) < fabs(side[s])) side[s] = x, point[s] = c->at[k].point;
    }
    double lo = side[0] / 2, hi = side[1] / 2;
    *cell = (struct voronoi_polygon){
        4, {lo, hi, hi, lo}, {-0.5, -0.5, 0.5, 0.5}, {VORONOI_NONE, point[1], VORONOI_NONE, point[0]}, 0};
    cell->farthest = fmax(lo * lo, hi * hi);
    return 0;
}

int voronoi_cell_make(int dim, struct voronoi_candidates *c, double half, struct voronoi_polygon *cell) {
    return dim == 1 ? cut_rod(c, cell) : cut_all(c, half, cell);
}

int voronoi_cell(int dim, size_t n, double (*d)[2], double *face, double *volume) {
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell; /* no corners if there is no cell */
    cell.n = 0;
    double farthest = 0; /* m^2 */
    for (size_t j = 0; j < n; j++) {
        voronoi_cell_offer(&c, d[j], (uint32_t)j);
        farthest = fmax(farthest, c.at[j].r2);
        face[j] = 0;
    }
    int status = n ? voronoi_cell_make(dim, &c, sqrt(farthest), &cell) : -1;
    for (int k = 0; k < cell.n && !status; k++) {
        int next = k + 1 < cell.n ? k + 1 : 0;
        if (cell.edge[k] == VORONOI_NONE)
            status = dim == 2 ? -1 : 0;
        else
            face[cell.edge[k]] = hypot(cell.x[next] - cell.x[k], cell.y[next] - cell.y[k]);
    }
    if (dim == 1 && !status) status = isfinite(cell.farthest) ? 0 : -1;
    *volume = status ? 0 : voronoi_cell_area(&cell);
    free(c.at);
    return status;
}
