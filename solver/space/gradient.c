/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two sweeps in place of their product.
 *
 * The rows of D kappa D have some 50 entries in the plane, those of D some 15, and both derivatives of a pair are one
 * number times C d.  F is symmetric and kept by one of the two particles, so that a particle takes 12 B for each pair
 * that it keeps and 8 B for each that another does, 10 B a neighbour in place of 12 in rows.  The first sweep needs
 * the derivatives at the ghosts within one support of the domain too.  Particles are in the order of cells, so that
 * the two of a pair are within `reach` of each other: the second sweep can follow the first at that distance. */
#include "solver/space/gradient.h"
#include "solver/space/assembly.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Whether point i is a particle, or a ghost within one support of the domain. */
static int is_needed(const struct assembly *m, size_t i) {
    const struct cloud *c = m->c;
    double outside = 0;
    for (int a = 0; a < c->dim; a++) {
        double x = a ? c->y[i] : c->x[i];
        outside = fmax(outside, fmax(m->p->lo[a] - x, x - m->p->hi[a]));
    }
    return outside < m->support;
}

struct pairs {
    const struct assembly *m;
    const unsigned char *needed;
    struct gradient *g;
    struct assembly_list part[ASSEMBLY_BLOCKS];
    size_t *begin;
};

static int take_pairs(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct pairs *all = context;
    const struct assembly *m = all->m;
    struct surroundings *at = xcalloc(1, sizeof *at);
    double F[NEIGHBOURS_MAX];
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        if (!all->needed[i]) continue;
        status = assembly_neighbourhood(m, i, at, why);
        if (!status) status = m->s->pairs(m->p, m->o, &at->nb, F, &all->g->C[3 * i], why);
        size_t before = all->part[b].n;
        for (size_t k = 0; k < at->nb.n && !status; k++)
            if (!all->needed[at->near[k]] || i < at->near[k]) assembly_list_add(&all->part[b], at->near[k], F[k]);
        all->begin[i + 1] = all->part[b].n - before;
    }
    free(at);
    return status;
}

/* Each pair once more, for its other point, in the order of keepers. */
static void lend(struct gradient *g, const unsigned char *needed) {
    uint32_t *at = g->lent;
    for (uint32_t k = 0; k < g->kept[g->total]; k++)
        if (needed[g->other[k]]) at[g->other[k] + 1]++;
    for (size_t i = 0; i < g->total; i++) at[i + 1] += at[i];
    g->keeper = xcalloc(at[g->total], sizeof *g->keeper);
    g->pair = xcalloc(at[g->total], sizeof *g->pair);
    for (uint32_t i = 0; i < g->total; i++)
        for (uint32_t k = g->kept[i]; k < g->kept[i + 1]; k++) {
            if (!needed[g->other[k]]) continue;
            uint32_t to = at[g->other[k]]++;
            g->keeper[to] = i, g->pair[to] = k;
        }
    memmove(at + 1, at, g->total * sizeof *at);
    at[0] = 0;
}

static void place(const struct assembly *m, struct gradient *g) {
    const struct cloud *c = m->c;
    const struct material *material = &m->p->material[0];
    size_t ghosts = c->total - c->n;
    g->place = xcalloc(2 * c->total, sizeof *g->place);
    for (size_t i = 0; i < c->total; i++) g->place[2 * i] = c->x[i], g->place[2 * i + 1] = c->y[i];
    g->source = xcalloc(ghosts, sizeof *g->source);
    g->factor = xcalloc(ghosts, sizeof *g->factor);
    g->offset = xcalloc(ghosts, sizeof *g->offset);
    for (size_t k = 0; k < ghosts; k++) {
        g->source[k] = c->source[c->n + k];
        g->factor[k] = c->factor[c->n + k], g->offset[k] = c->offset[c->n + k];
    }
    g->flux = xcalloc(2 * c->total, sizeof *g->flux);
    for (int d = 0; d < c->dim; d++) g->kappa[d] = material->k[d] / material->rho_c;
}

/* Of two particles the first keeps their pair. */
static size_t find_reach(const struct gradient *g, size_t n) {
    size_t reach = 0;
    for (size_t i = 0; i < n; i++)
        for (uint32_t k = g->kept[i]; k < g->kept[i + 1]; k++)
            if (g->other[k] < n && g->other[k] - i > reach) reach = g->other[k] - i;
    return reach;
}

/* The derivative (C d)_a F of a pair, at point i towards point j. */
static void derive(const struct gradient *g, size_t i, size_t j, double F, double D[2]) {
    double dx = g->place[2 * j] - g->place[2 * i], dy = g->place[2 * j + 1] - g->place[2 * i + 1];
    const double *C = &g->C[3 * i];
    D[0] = F * (C[0] * dx + C[1] * dy), D[1] = F * (C[1] * dx + C[2] * dy);
}

/* Pairs of point i, the ones that it keeps first; pair k of them: the other point, and its derivative. */
static uint32_t pairs_of(const struct gradient *g, size_t i) {
    return g->kept[i + 1] - g->kept[i] + g->lent[i + 1] - g->lent[i];
}

static size_t derive_pair(const struct gradient *g, size_t i, uint32_t k, double D[2]) {
    uint32_t kept = g->kept[i + 1] - g->kept[i], own = g->kept[i] + k, other = g->lent[i] + (k - kept);
    size_t j = k < kept ? g->other[own] : g->keeper[other];
    derive(g, i, j, g->F[k < kept ? own : g->pair[other]], D);
    return j;
}

/* What the adjoint of the first sweep has of a particle's own flux: sum_j w_ij (q_j + q_i) = sum_j w_ij (q_j - q_i) +
 * 2 q_i sum_j w_ij. */
static void add_sums(struct gradient *g, size_t n) {
    double D[2];
    g->sum = xcalloc(2 * n, sizeof *g->sum);
    for (size_t i = 0; i < n; i++)
        for (uint32_t k = 0; k < pairs_of(g, i); k++) {
            derive_pair(g, i, k, D);
            for (size_t a = 0; a < 2; a++) g->sum[2 * i + a] += 2 * D[a];
        }
}

static void count(struct heat_operator *a, const struct gradient *g) {
    size_t ghosts = g->total - a->n, kept = g->kept[g->total], lent = g->lent[g->total];
    a->pairs = 2 * ((size_t)g->kept[a->n] + g->lent[a->n]);
    a->bytes = kept * (sizeof *g->other + sizeof *g->F) + lent * (sizeof *g->keeper + sizeof *g->pair) +
               2 * (g->total + 1) * sizeof *g->kept + g->total * 7 * sizeof(double) +
               (g->sum ? 2 * a->n * sizeof *g->sum : 0) + ghosts * (sizeof *g->source + 2 * sizeof(double));
}

int gradient_assemble(struct heat_operator *a, const struct problem *p, const struct options *o,
                      const struct scheme *s, const struct cloud *c, double spacing, struct failure *why) {
    struct assembly m;
    if (assembly_create(&m, p, o, s, c, spacing, why)) return why->status;
    struct gradient *g = xcalloc(1, sizeof *g);
    a->gradient = g, a->state = g->total = c->total;
    g->C = xcalloc(3 * c->total, sizeof *g->C);
    g->kept = xcalloc(c->total + 1, sizeof *g->kept);
    g->lent = xcalloc(c->total + 1, sizeof *g->lent);
    unsigned char *needed = xcalloc(c->total, 1);
    for (size_t i = 0; i < c->total; i++) needed[i] = (unsigned char)is_needed(&m, i);
    struct pairs all = {.m = &m, .needed = needed, .g = g, .begin = xcalloc(c->total + 1, sizeof *all.begin)};
    int status = assembly_in_blocks(c->total, o->threads, take_pairs, &all, why);
    if (!status) {
        size_t pairs = assembly_list_join(all.part, c->total, all.begin, &g->other, &g->F);
        if (pairs > UINT32_MAX)
            status =
                refuse(why, STATUS_INPUT, "%zu pairs of particles: two sweeps take at most %u", pairs, UINT32_MAX);
    }
    if (!status) {
        for (size_t i = 0; i < g->total; i++) g->kept[i + 1] = (uint32_t)all.begin[i + 1];
        lend(g, needed);
        place(&m, g);
        if (s->adjoint) add_sums(g, a->n);
        g->reach = find_reach(g, a->n);
        count(a, g);
        assembly_keep_constants(&m, xcalloc(a->n, sizeof *a->g), a);
    }
    assembly_list_free(all.part);
    free(all.begin);
    free(needed);
    assembly_free(&m);
    return status;
}

void gradient_free(struct gradient *g) {
    if (!g) return;
    free(g->place), free(g->C), free(g->sum);
    free(g->kept), free(g->lent);
    free(g->other), free(g->F);
    free(g->keeper), free(g->pair);
    free(g->source), free(g->factor), free(g->offset);
    free(g->flux);
    free(g);
}

/* Adds w T at a point to the row: the point may be a ghost. */
static void add_entry(const struct gradient *g, size_t n, size_t point, double w, struct row *row) {
    if (point < n)
        csr_row_add(row, (uint32_t)point, w);
    else
        csr_row_add(row, g->source[point - n], w * g->factor[point - n]);
}

/* row += v . (D T)_i */
static void add_derivative(const struct gradient *g, size_t n, size_t i, const double v[2], struct row *row) {
    double D[2], sum = 0;
    for (uint32_t k = 0; k < pairs_of(g, i); k++) {
        size_t j = derive_pair(g, i, k, D);
        double w = v[0] * D[0] + v[1] * D[1];
        add_entry(g, n, j, w, row), sum += w;
    }
    add_entry(g, n, i, -sum, row);
}

void gradient_compose(const struct gradient *g, size_t n, size_t i, struct row *row) {
    double D[2], own[2] = {0, 0};
    for (uint32_t k = 0; k < pairs_of(g, i); k++) {
        size_t j = derive_pair(g, i, k, D);
        for (int a = 0; a < 2; a++) D[a] *= g->kappa[a], own[a] -= D[a];
        add_derivative(g, n, j, D, row);
    }
    for (int a = 0; a < 2 && g->sum; a++) own[a] += g->kappa[a] * g->sum[2 * i + (size_t)a];
    add_derivative(g, n, i, own, row);
}
