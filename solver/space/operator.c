/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operator on a lattice of one material: one stencil for all particles, with walls through ghosts.
 *
 * Every stencil is even along each axis, so a quadrant of weights represents it.  A scheme of two sweeps (first
 * derivatives applied twice) becomes one sweep with the convolution of its stencils.  The state has a frame of
 * ghosts; A is the homogeneous part (ghost = sign x source), and g contains the wall values and the source. */
#include "solver/space/operator.h"
#include "solver/space/kernel.h"
#include "solver/space/csr.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Weights on a full square around the centre; on a rod a line. */
struct square {
    int r[2];
    double *w;
};

static struct square square_alloc(int rx, int ry) {
    return (struct square){{rx, ry}, xcalloc((size_t)(2 * rx + 1) * (size_t)(2 * ry + 1), sizeof(double))};
}

static double *square_at(const struct square *s, int i, int j) {
    return &s->w[(j + s->r[1]) * (2 * s->r[0] + 1) + i + s->r[0]];
}

/* to += factor a * a */
static void add_convolution(struct square *to, const struct square *a, double factor) {
    for (int j = -a->r[1]; j <= a->r[1]; j++)
        for (int i = -a->r[0]; i <= a->r[0]; i++)
            for (int l = -a->r[1]; l <= a->r[1]; l++)
                for (int k = -a->r[0]; k <= a->r[0]; k++)
                    *square_at(to, i + k, j + l) += factor * *square_at(a, i, j) * *square_at(a, k, l);
}

int operator_weights(const struct scheme *s, const struct problem *p, const struct options *o,
                     const struct neighbourhood *nb, double *w[], struct failure *why) {
    double F[NEIGHBOURS_MAX], C[DIM_MAX][DIM_MAX];
    if (s->sweeps == 1) return s->weights(p, o, nb, w, why);
    if (s->pairs(p, o, nb, F, C, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        for (int a = 0; a < nb->dim; a++) {
            double sum = 0;
            for (int b = 0; b < nb->dim; b++) sum += C[a][b] * nb->d[j][b];
            w[a][j] = F[j] * sum;
        }
    }
    return STATUS_OK;
}

int operator_neighbourhood(int dim, double dx, double h, double d[NEIGHBOURS_MAX][DIM_MAX], struct neighbourhood *nb,
                           struct failure *why) {
    *nb = (struct neighbourhood){.dim = dim, .d = d, .h = h * dx, .volume = dim == 2 ? dx * dx : dx};
    double reach = ceil(KERNEL_SUPPORT * h * (1 - 1e-12)) - 1, across = 2 * reach + 1;
    if (!((dim == 2 ? across * across : across) <= NEIGHBOURS_MAX))
        return refuse(why, STATUS_INPUT, "--h %g: more than %d neighbours; use a smaller --h", h, NEIGHBOURS_MAX);
    int r = (int)reach, ry = dim == 2 ? r : 0;
    for (int j = -ry; j <= ry; j++)
        for (int i = -r; i <= r; i++) {
            /* Offsets at exactly 2 h must not depend on round-off; they are excluded, since the kernel is zero. */
            if ((i == 0 && j == 0) || i * i + j * j >= 4 * h * h * (1 - 1e-12)) continue;
            d[nb->n][0] = i * dx, d[nb->n][1] = j * dx, d[nb->n++][2] = 0;
        }
    return STATUS_OK;
}

/* Weights of the scheme on the lattice around the origin, one square per output; 0 at the origin. */
static int lattice_weights(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                           const double kappa[2], struct square out[2], struct failure *why) {
    double d[NEIGHBOURS_MAX][DIM_MAX], weight[2][NEIGHBOURS_MAX], *w[2] = {weight[0], weight[1]};
    struct neighbourhood nb;
    if (operator_neighbourhood(p->dim, dx, o->h, d, &nb, why)) return why->status;
    if (s->volume) nb.volume = s->volume(p, o, nb.h, nb.volume);
    nb.rho_c = p->material[0].rho_c;
    nb.x[0] = (p->lo[0] + p->hi[0]) / 2, nb.x[1] = (p->lo[1] + p->hi[1]) / 2;
    for (int a = 0; a < 2; a++) nb.kappa[a] = kappa[a];
    int status = operator_weights(s, p, o, &nb, w, why), r = (int)ceil(KERNEL_SUPPORT * o->h * (1 - 1e-12)) - 1;
    for (int t = 0; t < s->sweeps && !status; t++) {
        out[t] = square_alloc(r, p->dim == 2 ? r : 0);
        for (size_t k = 0; k < nb.n; k++)
            *square_at(&out[t], (int)lround(d[k][0] / dx), (int)lround(d[k][1] / dx)) = w[t][k];
    }
    return status;
}

int operator_stencil(const struct problem *p, const struct options *o, const struct scheme *s, double dx,
                     const double kappa[2], int *reach, double **weight, struct failure *why) {
    struct square part[2] = {{{0, 0}, NULL}, {{0, 0}, NULL}}, whole;
    if (lattice_weights(p, o, s, dx, kappa, part, why)) return why->status;
    whole = part[0];
    if (s->sweeps == 2) {
        whole = square_alloc(2 * part[0].r[0], 2 * part[0].r[1]);
        for (int a = 0; a < p->dim; a++) add_convolution(&whole, &part[a], kappa[a]);
        free(part[0].w);
        free(part[1].w);
    }
    int rx = whole.r[0], ry = whole.r[1];
    double sum = 0;
    *weight = xcalloc((size_t)(rx + 1) * (size_t)(ry + 1), sizeof **weight);
    for (int j = 0; j <= ry; j++)
        for (int i = 0; i <= rx; i++) {
            double w = *square_at(&whole, i, j);
            (*weight)[j * (rx + 1) + i] = w;
            if (i || j) sum += w * (i ? 2 : 1) * (j ? 2 : 1);
        }
    (*weight)[0] = -sum; /* a constant temperature is steady */
    reach[0] = rx, reach[1] = ry;
    free(whole.w);
    return STATUS_OK;
}

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

/* Adds w x offset of the ghost at (i, j) to g of its neighbours. */
static void add_ghost(const struct heat_operator *a, int i, int j, double offset, double *g) {
    const struct lattice *l = &a->lattice;
    int rx = a->reach[0], ry = a->reach[1];
    for (int m = j > ry ? j - ry : 0; m <= j + ry && m < l->n[1]; m++)
        for (int k = i > rx ? i - rx : 0; k <= i + rx && k < l->n[0]; k++)
            g[operator_row(a, m) + k] += a->weight[abs(m - j) * (rx + 1) + abs(k - i)] * offset;
}

/* 1 if a source or a wall value, at the foot of any ghost, is not zero. */
static int has_constants(const struct heat_operator *a, const struct problem *p) {
    const struct lattice *l = &a->lattice;
    double x[2];
    for (int j = 0; j < l->n[1] && p->source; j++)
        for (int i = 0; i < l->n[0]; i++) {
            layout_position(l, i, j, x);
            if (p->source(p, x) != 0) return 1;
        }
    for (int s = 0; s < 2 * l->dim; s++)
        for (int i = -a->reach[1 - s / 2]; i < l->n[1 - s / 2] + a->reach[1 - s / 2]; i++) {
            layout_position(l, s / 2 ? i : 0, s / 2 ? 0 : i, x);
            x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
            if (p->wall(p, (enum side)s, x, 0) != 0) return 1;
        }
    return 0;
}

/* g_i = G / rho_c + sum over ghosts of w x offset. */
static void add_constants(const struct heat_operator *a, const struct problem *p, const struct options *o,
                          double *g) {
    const struct lattice *l = &a->lattice;
    int rx = a->reach[0], ry = a->reach[1];
    for (int j = 0; j < l->n[1] && p->source; j++)
        for (int i = 0; i < l->n[0]; i++) {
            double x[2];
            layout_position(l, i, j, x);
            g[operator_row(a, j) + i] = p->source(p, x) / p->material[0].rho_c;
        }
    for (int j = -ry; j < l->n[1] + ry; j++) {
        int past = j >= 0 && j < l->n[1] ? l->n[0] : 0; /* the particles between the ghosts of this row */
        for (int i = -rx; i < l->n[0] + rx; i += i == -1 ? 1 + past : 1) {
            int from[2], side[2] = {ghost_side(l, 0, i, &from[0]), ghost_side(l, 1, j, &from[1])};
            double ghost[2], source[2];
            layout_position(l, i, j, ghost);
            layout_position(l, from[0], from[1], source);
            double offset = layout_ghost_offset(p, o->walls, l, side, ghost, source);
            if (offset != 0) add_ghost(a, i, j, offset, g);
        }
    }
}

static void count_pairs(struct heat_operator *a) {
    size_t pairs = 0;
    for (int j = 0; j <= a->reach[1]; j++)
        for (int i = 0; i <= a->reach[0]; i++)
            if ((i || j) && a->weight[j * (a->reach[0] + 1) + i] != 0) pairs += (size_t)((i ? 2 : 1) * (j ? 2 : 1));
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
    double stretch = l->dim == 2 ? l->dx[0] / l->dx[1] : 1; /* as on a square lattice */
    double kappa[2] = {p->material[0].k[0] / p->material[0].rho_c,
                       p->material[0].k[1] / p->material[0].rho_c * stretch * stretch};
    if (operator_stencil(p, o, s, l->dx[0], kappa, a->reach, &a->weight, why)) return why->status;
    for (int d = 0; d < l->dim; d++)
        if (l->n[d] < a->reach[d] + 2)
            return refuse(why, STATUS_INPUT,
                          "--dx %g: %d particles along an axis, the stencil reaches %d; use a smaller "
                          "--dx or --h",
                          o->dx, l->n[d], a->reach[d]);
    a->stride = stride_of(l->n[0], a->reach[0]);
    a->state = (size_t)a->stride * (size_t)(l->n[1] + 2 * a->reach[1]);
    a->bytes = sizeof(double) * (size_t)(a->reach[0] + 1) * (size_t)(a->reach[1] + 1);
    count_pairs(a);
    a->constant = has_constants(a, p);
    if (a->constant) a->bytes += a->state * sizeof *a->g;
    return STATUS_OK;
}

int operator_create_lattice(struct heat_operator *a, const struct problem *p, const struct options *o,
                            const struct scheme *s, const struct lattice *l, struct failure *why) {
    *a = (struct heat_operator){
        .n = (size_t)l->n[0] * (size_t)l->n[1], .lattice = *l, .threads = o->threads, .lanes = o->lanes};
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
        for (int j = 0; j <= a->reach[1]; j++)
            for (int i = 0; i <= a->reach[0]; i++)
                most += fabs(a->weight[j * (a->reach[0] + 1) + i]) * (i ? 2 : 1) * (j ? 2 : 1);
        return most;
    }
    for (size_t i = 0; i < a->n; i++) {
        double sum = fabs(a->diagonal[i]);
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) sum += fabs(a->value[k]);
        most = fmax(most, sum);
    }
    return most;
}
