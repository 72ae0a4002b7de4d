/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operator on a lattice of one material: one stencil for all particles, with walls through ghosts.
 *
 * The state has a frame of ghosts; A is the homogeneous part (ghost = sign x source), and g contains the wall values
 * and the source. */
#include "solver/space/operator.h"
#include "solver/space/csr.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The unknown mirrored by ghost k = 1, 2, ... beyond side s, or -1 for the wall itself. */
static int ghost_source(const struct lattice *l, int s, int k) {
    int from_side = k - 1 + l->shift[s];
    return from_side < 0 ? -1 : s % 2 ? l->n[s / 2] - 1 - from_side : from_side;
}

/* The side beyond which index i is along an axis (-1: none), and its source. */
static int ghost_side(const struct lattice *l, int axis, int i, int *source) {
    int side = i < 0 ? 2 * axis : i >= l->n[axis] ? 2 * axis + 1 : -1;
    *source = side < 0 ? i : ghost_source(l, side, side % 2 ? i - l->n[axis] + 1 : -i);
    return side;
}

/* Adds w x offset of the ghost at `at` to g of its neighbours. */
static void add_ghost(const struct heat_operator *a, const int at[DIM_MAX], double offset, double *g) {
    int lo[DIM_MAX], end[DIM_MAX];
    for (int d = 0; d < DIM_MAX; d++) {
        int r = a->reach[d], n = a->lattice.n[d];
        lo[d] = at[d] > r ? at[d] - r : 0, end[d] = at[d] + r < n ? at[d] + r + 1 : n;
    }
    for (int k = lo[2]; k < end[2]; k++)
        for (int j = lo[1]; j < end[1]; j++)
            for (int i = lo[0]; i < end[0]; i++)
                g[operator_place(a, j, k) + i] +=
                    a->weight[operator_offset(a->reach, abs(i - at[0]), abs(j - at[1]), abs(k - at[2]))] * offset;
}

/* 1 if the wall values on a side, at the foot of any ghost, are not all zero. */
static int side_has_values(const struct heat_operator *a, const struct problem *p, int s) {
    const struct lattice *l = &a->lattice;
    int axis = s / 2, from[DIM_MAX], end[DIM_MAX];
    for (int d = 0; d < DIM_MAX; d++) {
        from[d] = d == axis ? 0 : -a->reach[d];
        end[d] = d == axis ? 1 : l->n[d] + a->reach[d];
    }
    double x[DIM_MAX];
    for (int k = from[2]; k < end[2]; k++)
        for (int j = from[1]; j < end[1]; j++)
            for (int i = from[0]; i < end[0]; i++) {
                layout_position(l, i, j, k, x);
                x[axis] = s % 2 ? p->hi[axis] : p->lo[axis];
                if (p->wall(p, (enum side)s, x, 0) != 0) return 1;
            }
    return 0;
}

/* 1 if a source or a wall value is not zero, or may change. */
static int has_constants(const struct heat_operator *a, const struct problem *p) {
    const struct lattice *l = &a->lattice;
    double x[DIM_MAX];
    if (problem_changes(p)) return 1;
    for (int k = 0; k < l->n[2] && p->source; k++)
        for (int j = 0; j < l->n[1]; j++)
            for (int i = 0; i < l->n[0]; i++) {
                layout_position(l, i, j, k, x);
                if (p->source(p, x) != 0) return 1;
            }
    for (int s = 0; s < 2 * l->dim; s++)
        if (side_has_values(a, p, s)) return 1;
    return 0;
}

/* Adds w x offset of the ghosts of row (j, k). */
static void add_ghosts(const struct heat_operator *a, const struct problem *p, const struct options *o, int j, int k,
                       double *g) {
    const struct lattice *l = &a->lattice;
    int inside = j >= 0 && j < l->n[1] && k >= 0 && k < l->n[2];
    int past = inside ? l->n[0] : 0; /* the particles between the ghosts of this row */
    for (int i = -a->reach[0]; i < l->n[0] + a->reach[0]; i += i == -1 ? 1 + past : 1) {
        int at[DIM_MAX] = {i, j, k}, from[DIM_MAX], side[DIM_MAX];
        double ghost[DIM_MAX], source[DIM_MAX];
        for (int d = 0; d < DIM_MAX; d++) side[d] = ghost_side(l, d, at[d], &from[d]);
        layout_position(l, i, j, k, ghost);
        layout_position(l, from[0], from[1], from[2], source);
        double offset = layout_ghost_offset(p, o->walls, l, side, ghost, source);
        if (offset != 0) add_ghost(a, at, offset, g);
    }
}

/* g_i = G / rho_c + sum over ghosts of w x offset. */
static void add_constants(const struct heat_operator *a, const struct problem *p, const struct options *o,
                          double *g) {
    const struct lattice *l = &a->lattice;
    for (int k = 0; k < l->n[2] && p->source; k++)
        for (int j = 0; j < l->n[1]; j++)
            for (int i = 0; i < l->n[0]; i++) {
                double x[DIM_MAX];
                layout_position(l, i, j, k, x);
                g[operator_place(a, j, k) + i] = p->source(p, x) / p->material[0].rho_c;
            }
    for (int k = -a->reach[2]; k < l->n[2] + a->reach[2]; k++)
        for (int j = -a->reach[1]; j < l->n[1] + a->reach[1]; j++) add_ghosts(a, p, o, j, k, g);
}

void operator_constants(const struct heat_operator *a, const struct problem *p, const struct options *o, double t,
                        double *g) {
    struct later now;
    if (!a->weight) {
        csr_constants(a, p, o, t, g);
        return;
    }
    problem_later(p, t, &now);
    memset(g, 0, a->state * sizeof *g);
    add_constants(a, &now.problem, o, g);
}

static void count_pairs(struct heat_operator *a) {
    size_t pairs = 0;
    for (int k = 0; k <= a->reach[2]; k++)
        for (int j = 0; j <= a->reach[1]; j++)
            for (int i = 0; i <= a->reach[0]; i++)
                if ((i || j || k) && a->weight[operator_offset(a->reach, i, j, k)] != 0)
                    pairs += (size_t)operator_images(i, j, k);
    a->pairs = pairs * a->n;
}

/* Rows separated by about a multiple of 4096 bytes would compete for the same cache sets. */
static ptrdiff_t stride_of(int n, int reach) {
    enum { ALIASED = 256, APART = 24 }; /* doubles */
    ptrdiff_t stride = (n + LANES_MAX - 1) / LANES_MAX * LANES_MAX + 2 * reach;
    while (stride >= ALIASED && stride % ALIASED < APART) stride += LANES_MAX;
    return stride;
}

static int take_stencil(struct heat_operator *a, const struct problem *p, const struct options *o,
                        const struct scheme *s, struct failure *why) {
    const struct lattice *l = &a->lattice;
    double kappa[DIM_MAX];
    for (int d = 0; d < l->dim; d++) {
        double stretch = l->dx[0] / l->dx[d]; /* as on a cubic lattice */
        kappa[d] = p->material[0].k[d] / p->material[0].rho_c * stretch * stretch;
    }
    if (operator_stencil(p, o, s, l->dx[0], kappa, a->reach, &a->weight, why)) return why->status;
    for (int d = 0; d < l->dim; d++)
        if (l->n[d] < a->reach[d] + 2)
            return refuse(why, STATUS_INPUT,
                          "--dx %g: %d particles along an axis, the stencil reaches %d; use a smaller "
                          "--dx or --h",
                          o->dx, l->n[d], a->reach[d]);
    a->stride = stride_of(l->n[0], a->reach[0]);
    a->plane = a->stride * (l->n[1] + 2 * a->reach[1]);
    a->state = (size_t)a->plane * (size_t)(l->n[2] + 2 * a->reach[2]);
    a->bytes = sizeof(double) * (operator_offset(a->reach, a->reach[0], a->reach[1], a->reach[2]) + 1);
    count_pairs(a);
    a->constant = has_constants(a, p);
    if (a->constant) a->bytes += a->state * sizeof *a->g;
    return STATUS_OK;
}

int operator_create_lattice(struct heat_operator *a, const struct problem *p, const struct options *o,
                            const struct scheme *s, const struct lattice *l, struct failure *why) {
    *a = (struct heat_operator){.n = (size_t)l->n[0] * (size_t)l->n[1] * (size_t)l->n[2],
                                .lattice = *l,
                                .threads = o->threads,
                                .lanes = o->lanes};
    int status = take_stencil(a, p, o, s, why);
    if (status) {
        operator_free(a);
        return status;
    }
    if (a->constant) {
        a->g = xcalloc(a->state, sizeof *a->g);
        add_constants(a, p, o, a->g);
    }
    return STATUS_OK;
}

int operator_create_csr(struct heat_operator *a, const struct problem *p, const struct options *o,
                        const struct scheme *s, const struct cloud *c, double spacing, struct failure *why) {
    *a = (struct heat_operator){.n = c->n, .state = c->n, .threads = o->threads, .lanes = o->lanes};
    int status = csr_assemble(a, p, o, s, c, spacing, why);
    if (status) operator_free(a);
    return status;
}

void operator_free(struct heat_operator *a) {
    free(a->weight);
    free(a->row);
    free(a->column);
    free(a->value);
    free(a->diagonal);
    free(a->banded);
    free(a->volume);
    free(a->rho_c);
    free(a->g);
    if (a->images) {
        if (a->images->cloud) layout_cloud_free(a->images->cloud);
        free(a->images->cloud);
        free(a->images->row);
        free(a->images->point);
        free(a->images->weight);
        free(a->images);
    }
    *a = (struct heat_operator){0};
}

void operator_row_take(const struct heat_operator *a, size_t i, struct row *r) {
    csr_row_clear(r);
    csr_row_add(r, (uint32_t)i, a->diagonal[i]);
    for (size_t k = a->row[i]; k < a->row[i + 1]; k++) csr_row_add(r, a->column[k], a->value[k]);
}

double operator_bound(const struct heat_operator *a) {
    double most = 0;
    if (a->weight) {
        for (int k = 0; k <= a->reach[2]; k++)
            for (int j = 0; j <= a->reach[1]; j++)
                for (int i = 0; i <= a->reach[0]; i++)
                    most += fabs(a->weight[operator_offset(a->reach, i, j, k)]) * operator_images(i, j, k);
        return most;
    }
    for (size_t i = 0; i < a->n; i++) {
        double sum = fabs(a->diagonal[i]);
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) sum += fabs(a->value[k]);
        most = fmax(most, sum);
    }
    return most;
}
