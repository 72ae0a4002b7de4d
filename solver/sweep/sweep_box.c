/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Updates on a box lattice of one material, with walls through ghosts: several updates per sweep over the planes
 * (wavefront.c). */
#include "solver/sweep/sweep.h"
#include "solver/sweep/wavefront.h"

/* For 200^3 particles on an EPYC of 1 MB of L2: 870 million updates per second of 33 points with these values, 700
 * with 2 updates per sweep, 580 with 1. */
enum {
    BAND = 4,        /* planes per front */
    TOGETHER = 8,    /* maximum number of updates per sweep */
    CACHE = 1 << 20, /* doubles of both states between the first and the last of them, in a shared cache of 8 MB */
};

static sweep_planes *planes_of(int lanes) {
    if (lanes == 0) lanes = options_lanes_most();
    return lanes == 8 ? sweep_planes_8 : lanes == 4 ? sweep_planes_4 : sweep_planes_2;
}

/* Largest i i + j j + k k of an offset with a weight. */
static int support_of(const struct heat_operator *a) {
    int q = 0;
    for (int k = 0; k <= a->reach[2]; k++)
        for (int j = 0; j <= a->reach[1]; j++)
            for (int i = 0; i <= a->reach[0]; i++) {
                int square = i * i + j * j + k * k;
                if (a->weight[operator_offset(a->reach, i, j, k)] != 0 && square > q) q = square;
            }
    return q;
}

/* Homogeneous ghosts beyond side s of `width` adjacent lines along its axis; unknown 0 of the first is at `first`,
 * the next one `step` further. */
static void refresh(const struct heat_operator *a, int s, double *first, ptrdiff_t step, ptrdiff_t width) {
    const struct lattice *l = &a->lattice;
    double *last = s % 2 ? first + (l->n[s / 2] - 1) * step : first, f = l->robin[s];
    if (s % 2 == 0) step = -step; /* outward */
    for (ptrdiff_t k = 1; k <= a->reach[s / 2]; k++) {
        ptrdiff_t from = k - 1 + l->shift[s];
        double *to = last + k * step;
        const double *source = last - from * step;
        if (l->sign[s] == LAYOUT_ROBIN && k > 1)
            for (ptrdiff_t i = 0; i < width; i++) to[i] = f * (to[i - step] + source[i]) - source[i + step];
        else if (l->sign[s] == LAYOUT_ROBIN)
            for (ptrdiff_t i = 0; i < width; i++) to[i] = f * source[i];
        else if (from < 0 || l->sign[s] == 0)
            for (ptrdiff_t i = 0; i < width; i++) to[i] = 0;
        else
            for (ptrdiff_t i = 0; i < width; i++) to[i] = l->sign[s] * source[i];
    }
}

/* The ghosts of planes [plane, end) along x, then along y with their edges. */
static void refresh_planes(const struct heat_operator *a, double *x, ptrdiff_t plane, ptrdiff_t end) {
    ptrdiff_t width = a->lattice.n[0] + 2 * a->reach[0];
    for (ptrdiff_t k = plane; k < end; k++) {
        for (ptrdiff_t j = 0; j < a->lattice.n[1]; j++)
            for (int s = X_LO; s <= X_HI; s++) refresh(a, s, x + operator_place(a, j, k), 1, 1);
        for (int s = Y_LO; s <= Y_HI; s++) refresh(a, s, x + operator_place(a, 0, k) - a->reach[0], a->stride, width);
    }
}

/* The ghosts beyond a side of z, with edges and corners. */
static void refresh_side(const struct heat_operator *a, int s, double *x) {
    refresh(a, s, x + a->reach[2] * a->plane, a->plane, a->plane);
}

struct sweep {
    const struct heat_operator *a;
    const struct update *u;
    int count, support;
    sweep_planes *planes;
    double *const *Y;
};

/* Update k of planes [plane, end), and their ghosts for the next update. */
static void advance(const void *what, int k, ptrdiff_t plane, ptrdiff_t end) {
    const struct sweep *s = what;
    const struct heat_operator *a = s->a;
    ptrdiff_t nz = a->lattice.n[2], lowest = a->reach[2] < nz ? a->reach[2] : nz - 1;
    double *y = s->Y[1 - k % 2];
    s->planes(a, s->support, &s->u[k], s->Y[k % 2], y, plane, end);
    if (k + 1 == s->count) return;
    refresh_planes(a, y, plane, end);
    if (plane <= lowest && lowest < end) refresh_side(a, Z_LO, y); /* mirrors the planes up to `lowest` */
    if (end == nz) refresh_side(a, Z_HI, y);
}

/* Each slab contains the planes that its side mirrors. */
void sweep_box(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]) {
    struct sweep s = {a, u, count, support_of(a), planes_of(a->lanes), Y};
    ptrdiff_t nz = a->lattice.n[2], lag = a->reach[2], slabs = nz / (2 * lag), fit = CACHE / (2 * lag * a->plane);
    int together = fit < 1 ? 1 : fit < TOGETHER ? (int)fit : TOGETHER;
    struct wavefront w = {advance, &s, nz, lag, BAND, together, a->threads < slabs ? a->threads : (int)slabs};
    refresh_planes(a, Y[0], 0, nz);
    for (int side = Z_LO; side <= Z_HI; side++) refresh_side(a, side, Y[0]);
    wavefront_sweep(&w, count);
}
