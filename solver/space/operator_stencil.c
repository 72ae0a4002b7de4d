/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The weights of a scheme, and its stencil on a lattice.
 *
 * Every stencil is even along each axis, so an octant of weights represents it (of a plane a quadrant).  A scheme of
 * two sweeps (first derivatives applied twice) becomes one sweep with the convolution of its stencils. */
#include "solver/space/operator.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>

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
