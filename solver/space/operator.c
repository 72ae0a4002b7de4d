/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The weights of a scheme, its stencil, and the operator on a lattice of one material: one stencil for all particles,
 * with walls through ghosts.
 *
 * Every stencil is even along each axis, so an octant of weights represents it (of a plane a quadrant).  A scheme of
 * two sweeps (first derivatives applied twice) becomes one sweep with the convolution of its stencils.
 *
 * The state has a frame of ghosts; A is the homogeneous part (ghost = sign x source), and g contains the wall values
 * and the source. */
#include "solver/space/operator.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Weights and stencil ---- */

/* Weights on a full cube of radius r around the centre; in the plane a square, on a rod a line. */
struct cube {
    int dim, r;
    double *w;
};

static size_t cube_size(const struct cube *s) {
    size_t size = 1;
    for (int a = 0; a < s->dim; a++) size *= (size_t)(2 * s->r + 1);
    return size;
}

static struct cube cube_alloc(int dim, int r) {
    struct cube s = {dim, r, NULL};
    s.w = xcalloc(cube_size(&s), sizeof *s.w);
    return s;
}

static double *cube_at(const struct cube *s, const int *at) {
    int place = 0;
    for (int a = s->dim - 1; a >= 0; a--) place = place * (2 * s->r + 1) + at[a] + s->r;
    return &s->w[place];
}

/* The offset with this index in s->w. */
static void cube_offset(const struct cube *s, size_t index, int *at) {
    for (int a = 0; a < s->dim; a++, index /= (size_t)(2 * s->r + 1))
        at[a] = (int)(index % (size_t)(2 * s->r + 1)) - s->r;
}

/* to += factor a * a */
static void add_convolution(struct cube *to, const struct cube *a, double factor) {
    size_t size = cube_size(a);
    for (size_t m = 0; m < size; m++)
        for (size_t n = 0; n < size; n++) {
            int first[DIM_MAX], second[DIM_MAX];
            if (a->w[m] == 0 || a->w[n] == 0) continue;
            cube_offset(a, m, first);
            cube_offset(a, n, second);
            for (int d = 0; d < a->dim; d++) first[d] += second[d];
            *cube_at(to, first) += factor * a->w[m] * a->w[n];
        }
}

static inline __attribute__((always_inline)) void derivatives(const struct neighbourhood *nb, int dim,
                                                              const double *F, double C[DIM_MAX][DIM_MAX],
                                                              double *const w[]) {
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < dim; a++) {
            double sum = 0;
            for (int b = 0; b < dim; b++) sum += C[a][b] * nb->d[j][b];
            w[a][j] = F[j] * sum;
        }
}

int operator_weights(const struct scheme *s, const struct problem *p, const struct options *o,
                     const struct neighbourhood *nb, double *w[], struct failure *why) {
    double F[NEIGHBOURS_MAX], C[DIM_MAX][DIM_MAX];
    if (s->sweeps == 1) return s->weights(p, o, nb, w, why);
    if (s->pairs(p, o, nb, F, C, why)) return why->status;
    if (nb->dim == 1) derivatives(nb, 1, F, C, w);
    if (nb->dim == 2) derivatives(nb, 2, F, C, w);
    if (nb->dim == 3) derivatives(nb, 3, F, C, w);
    return STATUS_OK;
}

int operator_neighbourhood(int dim, double dx, double h, double d[NEIGHBOURS_MAX][DIM_MAX], struct neighbourhood *nb,
                           struct failure *why) {
    double reach = ceil(KERNEL_SUPPORT * h * (1 - 1e-12)) - 1, most = 1;
    *nb = (struct neighbourhood){.dim = dim, .d = d, .h = h * dx, .volume = 1};
    for (int a = 0; a < dim; a++) nb->volume *= dx, most *= 2 * reach + 1;
    if (!(most <= NEIGHBOURS_MAX))
        return refuse(why, STATUS_INPUT, "--h %g: more than %d neighbours; use a smaller --h", h, NEIGHBOURS_MAX);
    int r = (int)reach, ry = dim > 1 ? r : 0, rz = dim > 2 ? r : 0;
    for (int k = -rz; k <= rz; k++)
        for (int j = -ry; j <= ry; j++)
            for (int i = -r; i <= r; i++) {
                /* Offsets at exactly 2 h must not depend on round-off; they are excluded, since the kernel is 0. */
                int square = i * i + j * j + k * k;
                if (square == 0 || square >= 4 * h * h * (1 - 1e-12)) continue;
                double *to = d[nb->n++];
                to[0] = i * dx, to[1] = j * dx, to[2] = k * dx;
            }
    return STATUS_OK;
}

/* Weights of the scheme on the lattice around the origin, one cube per output; 0 at the origin. */
static int lattice_weights(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                           const double *kappa, struct cube out[DIM_MAX], struct failure *why) {
    double d[NEIGHBOURS_MAX][DIM_MAX], weight[DIM_MAX][NEIGHBOURS_MAX],
        *w[DIM_MAX] = {weight[0], weight[1], weight[2]};
    struct neighbourhood nb;
    if (operator_neighbourhood(p->dim, dx, o->h, d, &nb, why)) return why->status;
    if (s->volume) nb.volume = s->volume(p, o, nb.h, nb.volume);
    nb.rho_c = p->material[0].rho_c;
    for (int a = 0; a < p->dim; a++) nb.x[a] = (p->lo[a] + p->hi[a]) / 2, nb.kappa[a] = kappa[a];
    int status = operator_weights(s, p, o, &nb, w, why), r = (int)ceil(KERNEL_SUPPORT * o->h * (1 - 1e-12)) - 1;
    for (int t = 0; t < (s->sweeps == 1 ? 1 : p->dim) && !status; t++) {
        out[t] = cube_alloc(p->dim, r);
        for (size_t k = 0; k < nb.n; k++) {
            int at[DIM_MAX];
            for (int a = 0; a < p->dim; a++) at[a] = (int)lround(d[k][a] / dx);
            *cube_at(&out[t], at) = w[t][k];
        }
    }
    return status;
}

int operator_stencil(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                     const double *kappa, int reach[DIM_MAX], double **weight, struct failure *why) {
    struct cube part[DIM_MAX], whole;
    if (lattice_weights(p, o, s, dx, kappa, part, why)) return why->status;
    whole = part[0];
    if (s->sweeps == 2) {
        whole = cube_alloc(p->dim, 2 * part[0].r);
        for (int a = 0; a < p->dim; a++) {
            add_convolution(&whole, &part[a], kappa[a]);
            free(part[a].w);
        }
    }
    for (int a = 0; a < DIM_MAX; a++) reach[a] = a < p->dim ? whole.r : 0;
    double sum = 0;
    *weight = xcalloc(operator_offset(reach, reach[0], reach[1], reach[2]) + 1, sizeof **weight);
    for (int k = 0; k <= reach[2]; k++)
        for (int j = 0; j <= reach[1]; j++)
            for (int i = 0; i <= reach[0]; i++) {
                double w = *cube_at(&whole, (const int[]){i, j, k});
                (*weight)[operator_offset(reach, i, j, k)] = w;
                if (i || j || k) sum += w * operator_images(i, j, k);
            }
    (*weight)[0] = -sum; /* a constant temperature is steady */
    free(whole.w);
    return STATUS_OK;
}

/* ---- Wall values and source ---- */

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
    problem_later(p, t, &now);
    memset(g, 0, a->state * sizeof *g);
    add_constants(a, &now.problem, o, g);
}

/* ---- The operator ---- */

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

static int set_stencil(struct heat_operator *a, const struct problem *p, const struct options *o,
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
    int status = set_stencil(a, p, o, s, why);
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

void operator_dense(const struct heat_operator *a, double *A) {
    memset(A, 0, a->n * a->n * sizeof *A);
    for (size_t i = 0; i < a->n; i++) {
        A[i * a->n + i] = a->diagonal[i];
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) A[i * a->n + a->column[k]] = a->value[k];
    }
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
