/* The operator with a row for each particle: off the lattice, or where the conductivity varies.
 *
 * A scheme of one sweep gives the row of particle i at once; a neighbour that is a ghost adds w sign to the column of
 * its source and w offset to g_i.  A scheme of two sweeps first gets the rows of its derivatives D_x, D_y at every
 * point within one support of the domain, ghosts among them, and the row of i is that of D_x kappa_x D_x + D_y
 * kappa_y D_y, with the ghosts in the columns of their sources. Rows are kept in blocks of particles, each filled by
 * one thread, and joined in order: the result is the same for any number of threads. */
#include "solver/space/csr.h"
#include "solver/space/kernel.h"
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct list { /* the rows of a block of points, one after the other; each ends at end[i] */
    size_t n, room;
    uint32_t *column;
    double *value, *other; /* other: the second derivative's weights, two sweeps only */
};

static void list_add(struct list *l, int two, uint32_t column, double value, double other) {
    if (l->n == l->room) {
        l->room = l->room ? 2 * l->room : 64;
        l->column = realloc(l->column, l->room * sizeof *l->column);
        l->value = realloc(l->value, l->room * sizeof *l->value);
        if (two) l->other = realloc(l->other, l->room * sizeof *l->other);
        if (!l->column || !l->value || (two && !l->other)) free(xcalloc(SIZE_MAX / 2, 2)); /* reports and ends */
    }
    l->column[l->n] = column;
    l->value[l->n] = value;
    if (two) l->other[l->n] = other;
    l->n++;
}

static void list_free(struct list *l) {
    free(l->column);
    free(l->value);
    free(l->other);
}

struct assembly {
    const struct problem *p;
    const struct options *o;
    const struct scheme *s;
    const struct cloud *c;
    struct neighbours cells;
    double h, support; /* m */
    double volume;     /* m^d */
    double cell;       /* m, as layout_cell */
};

/* The weights of point i on its neighbours `near`; returns a status and the number of neighbours. */
static int point_weights(const struct assembly *m, size_t i, uint32_t near[NEIGHBOURS_MAX], double *w[2], size_t *n,
                         struct failure *why) {
    const struct cloud *c = m->c;
    double d[NEIGHBOURS_MAX][2], V[NEIGHBOURS_MAX], H[NEIGHBOURS_MAX];
    *n = neighbours_find(&m->cells, i, near, NEIGHBOURS_MAX);
    if (*n > NEIGHBOURS_MAX)
        return refuse(why, STATUS_NUMERICAL, "particle %zu at (%.6g, %.6g) m has %zu neighbours, at most %d are held",
                      i, c->x[i], c->y[i], *n, NEIGHBOURS_MAX);
    for (size_t k = 0; k < *n; k++) d[k][0] = c->x[near[k]] - c->x[i], d[k][1] = c->y[near[k]] - c->y[i];
    const struct problem *p = m->p;
    const struct material *material = &p->material[layout_material(p, c->x[i])];
    struct neighbourhood nb = {.dim = c->dim,
                               .i = i,
                               .x = {c->x[i], c->y[i]},
                               .n = *n,
                               .d = d,
                               .h = m->h,
                               .volume = m->volume,
                               .rho_c = layout_rho_c(p, m->cell, c->x[i]),
                               .kappa = {material->k[0] / material->rho_c, material->k[1] / material->rho_c}};
    if (c->spacing) {
        double unit = m->volume / c->volume; /* what the scheme counts a volume for */
        for (size_t k = 0; k < *n; k++) {
            double s = c->spacing[near[k]];
            V[k] = unit * (c->dim == 2 ? s * s : s), H[k] = m->o->h * s;
        }
        nb.V = V, nb.H = H, nb.h = m->o->h * c->spacing[i];
    }
    return m->s->weights(p, m->o, &nb, w, why);
}

/* A row while it is assembled: dense, with a list of the columns that it touches. */
struct scratch {
    double *value;    /* n */
    uint32_t *column; /* touched, in the order of arrival */
    size_t n;
    unsigned char *touched; /* n */
};

static void scratch_add(struct scratch *s, uint32_t column, double value) {
    if (!s->touched[column]) s->touched[column] = 1, s->column[s->n++] = column;
    s->value[column] += value;
}

/* Ascending.  Columns arrive by cells, in runs that ascend: insertion takes a few moves each. */
static void sort_columns(uint32_t *column, size_t n) {
    for (size_t k = 1; k < n; k++) {
        uint32_t held = column[k];
        size_t at = k;
        for (; at > 0 && column[at - 1] > held; at--) column[at] = column[at - 1];
        column[at] = held;
    }
}

/* Moves the scratch row of particle i to the list: off-diagonal columns, ascending. */
static void scratch_flush(struct scratch *s, size_t i, struct list *out, double *diagonal) {
    sort_columns(s->column, s->n);
    for (size_t k = 0; k < s->n; k++) {
        uint32_t j = s->column[k];
        if (j == i)
            *diagonal += s->value[j];
        else if (s->value[j] != 0)
            list_add(out, 0, j, s->value[j], 0);
        s->value[j] = 0, s->touched[j] = 0;
    }
    s->n = 0;
}

/* Adds w T_point to the row: the point may be a ghost. */
static void add_entry(const struct cloud *c, struct scratch *s, double *g, uint32_t point, double w) {
    scratch_add(s, c->source[point], w * (c->factor ? c->factor[point] : c->sign[point]));
    *g += w * c->offset[point];
}

static int direct_row(const struct assembly *m, size_t i, struct scratch *s, double *diagonal, double *g,
                      struct failure *why) {
    uint32_t near[NEIGHBOURS_MAX];
    double weight[NEIGHBOURS_MAX], *w[2] = {weight, NULL};
    size_t n;
    if (point_weights(m, i, near, w, &n, why)) return why->status;
    for (size_t k = 0; k < n; k++) {
        *diagonal -= weight[k];
        add_entry(m->c, s, g, near[k], weight[k]);
    }
    return STATUS_OK;
}

enum { BLOCKS = 64 };

struct derivatives { /* rows of D_x and D_y at every point within one support of the domain */
    struct list list[BLOCKS];
    size_t *end;          /* total: where the row of a point ends in the list of its block */
    unsigned char *block; /* total */
};

static size_t derivatives_begin(const struct derivatives *d, size_t i) {
    return i > 0 && d->block[i - 1] == d->block[i] ? d->end[i - 1] : 0;
}

/* The rows of one block of points. */
static int derive_block(const struct assembly *m, int block, size_t begin, size_t end, struct derivatives *d,
                        struct failure *why) {
    const struct cloud *c = m->c;
    struct list *list = &d->list[block];
    uint32_t near[NEIGHBOURS_MAX];
    double weight[2][NEIGHBOURS_MAX], *w[2] = {weight[0], weight[1]};
    for (size_t i = begin; i < end; i++) {
        size_t n = 0;
        double outside = 0;
        for (int a = 0; a < c->dim; a++) {
            double x = a ? c->y[i] : c->x[i];
            outside = fmax(outside, fmax(m->p->lo[a] - x, x - m->p->hi[a]));
        }
        if (outside < m->support) {
            if (point_weights(m, i, near, w, &n, why)) return why->status;
            double sum[2] = {0, 0};
            for (size_t k = 0; k < n; k++) {
                double other = c->dim == 2 ? weight[1][k] : 0;
                list_add(list, 1, near[k], weight[0][k], other);
                sum[0] -= weight[0][k], sum[1] -= other;
            }
            list_add(list, 1, (uint32_t)i, sum[0], sum[1]);
        }
        d->end[i] = list->n, d->block[i] = (unsigned char)block;
    }
    return STATUS_OK;
}

/* By as many threads; of several failures the first in the order of points. */
static int derive_all(const struct assembly *m, int threads, struct derivatives *d, struct failure *why) {
    size_t total = m->c->total;
    int first_bad = BLOCKS;
    d->end = xcalloc(total, sizeof *d->end);
    d->block = xcalloc(total, sizeof *d->block);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int b = 0; b < BLOCKS; b++) {
        struct failure local;
        size_t begin = total * (size_t)b / BLOCKS, end = total * (size_t)(b + 1) / BLOCKS;
        if (derive_block(m, b, begin, end, d, &local)) {
#pragma omp critical(derivatives_failure)
            if (b < first_bad) first_bad = b, *why = local;
        }
    }
    return first_bad < BLOCKS ? why->status : STATUS_OK;
}

static void composed_row(const struct assembly *m, const struct derivatives *d, size_t i, struct scratch *s,
                         double *g) {
    const struct material *material = &m->p->material[0];
    double kappa[2] = {material->k[0] / material->rho_c, m->c->dim == 2 ? material->k[1] / material->rho_c : 0};
    const struct list *own = &d->list[d->block[i]];
    for (size_t k = derivatives_begin(d, i); k < d->end[i]; k++) {
        uint32_t j = own->column[k];
        const struct list *l = &d->list[d->block[j]];
        double x = kappa[0] * own->value[k], y = kappa[1] * own->other[k];
        for (size_t q = derivatives_begin(d, j); q < d->end[j]; q++)
            add_entry(m->c, s, g, l->column[q], x * l->value[q] + y * l->other[q]);
    }
}

/* The rows of one block of particles. */
static int assemble_block(const struct assembly *m, const struct derivatives *d, struct heat_operator *a, double *g,
                          size_t begin, size_t end, struct list *out, struct failure *why) {
    size_t n = m->c->n;
    struct scratch s = {xcalloc(n, sizeof(double)), xcalloc(n, sizeof(uint32_t)), 0, xcalloc(n, 1)};
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        if (m->s->sweeps == 2)
            composed_row(m, d, i, &s, &g[i]);
        else
            status = direct_row(m, i, &s, &a->diagonal[i], &g[i], why);
        scratch_flush(&s, i, out, &a->diagonal[i]);
        a->row[i + 1] = out->n;
    }
    free(s.value);
    free(s.column);
    free(s.touched);
    return status;
}

static void join(struct heat_operator *a, struct list part[BLOCKS], const size_t begin[BLOCKS + 1]) {
    size_t total = 0;
    for (int b = 0; b < BLOCKS; b++) total += part[b].n;
    a->column = xcalloc(total, sizeof *a->column);
    a->value = xcalloc(total, sizeof *a->value);
    for (size_t b = 0, at = 0; b < BLOCKS; at += part[b].n, b++) {
        if (part[b].n) {
            memcpy(a->column + at, part[b].column, part[b].n * sizeof *a->column);
            memcpy(a->value + at, part[b].value, part[b].n * sizeof *a->value);
        }
        for (size_t i = begin[b]; i < begin[b + 1]; i++) a->row[i + 1] += at;
    }
    a->pairs = total;
    a->bytes =
        total * (sizeof *a->column + sizeof *a->value) + (a->n + 1) * sizeof *a->row + a->n * sizeof *a->diagonal;
}

static void keep_constants(struct heat_operator *a, const struct assembly *m, double *g) {
    const struct problem *p = m->p;
    const struct cloud *c = m->c;
    for (size_t i = 0; i < a->n; i++) {
        double x[2] = {c->x[i], c->y[i]};
        if (p->source) g[i] += p->source(p, x) / layout_rho_c(p, m->cell, x[0]);
        a->constant |= g[i] != 0;
    }
    if (a->constant)
        a->g = g, a->bytes += a->n * sizeof *g;
    else
        free(g);
}

int csr_assemble(struct heat_operator *a, const struct problem *p, const struct options *o, const struct scheme *s,
                 const struct cloud *c, double spacing, struct failure *why) {
    struct assembly m = {p,
                         o,
                         s,
                         c,
                         {0},
                         o->h * spacing,
                         KERNEL_SUPPORT * o->h * (c->spacing ? c->coarsest : spacing),
                         s->volume ? s->volume(p, o, o->h * spacing, c->volume) : c->volume,
                         layout_cell(o, spacing)};
    struct derivatives d = {{{0, 0, NULL, NULL, NULL}}, NULL, NULL};
    struct list part[BLOCKS] = {{0, 0, NULL, NULL, NULL}};
    size_t begin[BLOCKS + 1];
    int status = STATUS_OK, threads = o->threads > 1 ? o->threads : 1;
    double *g = xcalloc(a->n, sizeof *g);
    a->row = xcalloc(a->n + 1, sizeof *a->row);
    a->diagonal = xcalloc(a->n, sizeof *a->diagonal);
    neighbours_create(&m.cells, c, m.support);
    if (s->sweeps == 2) status = derive_all(&m, threads, &d, why);
    for (size_t b = 0; b <= BLOCKS; b++) begin[b] = a->n * b / BLOCKS;
    int first_bad = BLOCKS;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (!status)
    for (int b = 0; b < BLOCKS; b++) {
        struct failure local;
        if (status) continue;
        if (assemble_block(&m, &d, a, g, begin[b], begin[b + 1], &part[b], &local)) {
#pragma omp critical(rows_failure)
            if (b < first_bad) first_bad = b, *why = local;
        }
    }
    if (first_bad < BLOCKS) status = why->status;
    for (int b = 0; b < BLOCKS; b++) list_free(&d.list[b]);
    free(d.end);
    free(d.block);
    neighbours_free(&m.cells);
    if (!status) {
        join(a, part, begin);
        keep_constants(a, &m, g);
    } else {
        free(g);
    }
    for (int b = 0; b < BLOCKS; b++) list_free(&part[b]);
    return status;
}
