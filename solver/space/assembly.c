/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Neighbourhoods of the points of a cloud, and the operator with one row per particle: off the lattice, or with
 * variable conductivity.
 *
 * The scheme gives the row of particle i.  A neighbour that is a ghost adds w factor to the column of its source and
 * w offset to g_i.  A scheme of two sweeps multiplies out the sum of D_a K_ab D_b over the axes, with D at i and
 * at its neighbours, including dummies: on a cut lattice the value of a ghost is a sum over particles.  Rows are
 * collected in blocks of particles and joined in order. */
#include "solver/space/assembly.h"

#include "solver/shape.h"
#include "solver/space/blocks.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Neighbourhoods ---- */

int assembly_create(struct assembly *m, const struct problem *p, const struct options *o, const struct scheme *s,
                    const struct cloud *c, double spacing, struct failure *why) {
    *m = (struct assembly){.p = p,
                           .o = o,
                           .s = s,
                           .c = c,
                           .h = o->h * spacing,
                           .support = KERNEL_SUPPORT * o->h * spacing,
                           .volume = s->volume ? s->volume(p, o, o->h * spacing, c->volume) : c->volume,
                           .cell = layout_cell(o, spacing)};
    if (s->cells) return voronoi_create(&m->mesh, p, c, o->threads, why);
    neighbours_create(&m->cells, c, m->support);
    if (o->walls == WALLS_ONE_SIDED) neighbours_create(&m->wide, c, assembly_widest(p->dim, o->h) * m->support);
    return STATUS_OK;
}

/* J m^-3 K^-1, with a contact resistance: the heat capacity of its own material in cell i and in those beside it on
 * the other side, over the volume of cell i.  T jumps within a cut cell. */
static double own_rho_c(const struct assembly *m, size_t i) {
    const struct voronoi *v = &m->mesh;
    const int of = layout_material(m->p, m->c->x[i]);
    double volume = v->volume[i] * (of ? v->beyond[i] : 1 - v->beyond[i]);
    for (size_t k = v->begin[i]; k < v->begin[i + 1]; k++) {
        const size_t j = v->point[k];
        if (j < v->n && layout_material(m->p, m->c->x[j]) != of)
            volume += v->volume[j] * (of ? v->beyond[j] : 1 - v->beyond[j]);
    }
    return m->p->material[of].rho_c * volume / v->volume[i];
}

/* J m^-3 K^-1, heat capacity of the cell of particle i. */
static double rho_c_of(const struct assembly *m, size_t i) {
    const struct problem *p = m->p;
    if (!m->mesh.volume || p->materials < 2) return layout_rho_c(p, m->cell, m->c->x[i]);
    if (p->resistance > 0) return own_rho_c(m, i);
    double beyond = m->mesh.beyond[i];
    return (1 - beyond) * p->material[0].rho_c + beyond * p->material[1].rho_c;
}

void assembly_free(struct assembly *m) {
    neighbours_free(&m->cells);
    neighbours_free(&m->wide);
    voronoi_free(&m->mesh);
}

/* The points across the faces of cell i. */
static size_t faces_of_cell(const struct voronoi *v, size_t i, uint32_t *out) {
    size_t n = v->begin[i + 1] - v->begin[i];
    if (n <= NEIGHBOURS_MAX) memcpy(out, v->point + v->begin[i], n * sizeof *out);
    return n;
}

/* Dummy temperatures of Morris, Fox & Zhu (1997), extrapolated for each pair: T_j = T_w + (1 - stretch) (T_i - T_w),
 * stretch = 1 + d_j/d_i with the distances from the wall, at most 1.5. */
static double stretch_of(const struct assembly *m, size_t i, uint32_t j) {
    double x[DIM_MAX];
    layout_cloud_place(m->c, i, x);
    const double depth = shape_depth(m->p, x);
    const double most = 1.5; /* limit of the publication */
    return depth * (most - 1) > m->c->away[j - m->c->n] ? 1 + m->c->away[j - m->c->n] / depth : most;
}

double assembly_widest(int dim, double h) {
    const double ball = 6; /* dx, radius */
    return dim < 3 ? 3 : fmin(3, fmax(1, ball / (KERNEL_SUPPORT * h)));
}

/* 1 if --walls one_sided determines the row of particle i: it is within the support of a wall. */
static int is_at_wall(const struct assembly *m, size_t i) {
    double x[DIM_MAX];
    if (!m->wide.cloud) return 0;
    layout_cloud_place(m->c, i, x);
    return shape_depth(m->p, x) < m->support;
}

int assembly_neighbourhood(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why) {
    const struct cloud *c = m->c;
    const struct neighbours *cells = is_at_wall(m, i) ? &m->wide : &m->cells;
    char place[PLACE_TEXT];
    double x[DIM_MAX];
    layout_cloud_place(c, i, x);
    size_t n =
        m->s->cells ? faces_of_cell(&m->mesh, i, out->near) : neighbours_find(cells, i, out->near, NEIGHBOURS_MAX);
    if (n > NEIGHBOURS_MAX)
        return refuse(why, STATUS_NUMERICAL,
                      "particle %zu at %s has %zu neighbours, at most %d are possible; use a smaller --h", i,
                      problem_place(c->dim, x, place), n, NEIGHBOURS_MAX);
    for (size_t k = 0; k < n; k++) {
        layout_cloud_place(c, out->near[k], out->d[k]);
        for (int a = 0; a < DIM_MAX; a++) out->d[k][a] -= x[a];
    }
    const struct problem *p = m->p;
    const struct material *material = &p->material[layout_material(p, c->x[i])];
    out->nb = (struct neighbourhood){.dim = c->dim,
                                     .i = i,
                                     .x = {x[0], x[1], x[2]},
                                     .n = n,
                                     .d = out->d,
                                     .h = m->h,
                                     .volume = m->volume,
                                     .rho_c = rho_c_of(m, i)};
    for (int a = 0; a < DIM_MAX; a++) {
        out->nb.kappa[a] = material->k[a] / material->rho_c;
        out->nb.cross[a] = p->cross[a] / material->rho_c;
    }
    if (m->s->cells) {
        for (size_t k = 0; k < n; k++) out->X[k] = c->x[out->near[k]];
        out->nb.volume = m->mesh.volume[i], out->nb.face = m->mesh.face + m->mesh.begin[i], out->nb.X = out->X;
    }
    return STATUS_OK;
}

/* ---- One row ---- */

/* A row of A, with ghosts in the columns of their sources. */
struct row {
    double *value;    /* by column, n of the operator; zero if not touched */
    uint32_t *column; /* touched columns, in any order */
    size_t n;         /* number of touched columns */
    unsigned char *touched;
    struct blocks_list *images; /* lists the weights of ghosts too; NULL: not */
};

/* Adds w at a column. */
static inline void row_add(struct row *r, uint32_t column, double w) {
    if (!r->touched[column]) r->touched[column] = 1, r->column[r->n++] = column;
    r->value[column] += w;
}

static void row_create(struct row *r, size_t n) {
    *r = (struct row){xcalloc(n, sizeof(double)), xcalloc(n, sizeof(uint32_t)), 0, xcalloc(n, 1), NULL};
}

static void row_clear(struct row *r) {
    for (size_t k = 0; k < r->n; k++) r->value[r->column[k]] = 0, r->touched[r->column[k]] = 0;
    r->n = 0;
}

static void row_free(struct row *r) {
    free(r->value);
    free(r->column);
    free(r->touched);
}

/* Ascending order.  Columns arrive in ascending runs, cell by cell, so insertion sort needs few moves. */
static void sort_columns(uint32_t *column, size_t n) {
    for (size_t k = 1; k < n; k++) {
        uint32_t held = column[k];
        size_t at = k;
        for (; at > 0 && column[at - 1] > held; at--) column[at] = column[at - 1];
        column[at] = held;
    }
}

/* Appends the row of particle i to the list, off-diagonal columns in ascending order. */
static void move_row(struct row *r, size_t i, struct blocks_list *out, double *diagonal) {
    sort_columns(r->column, r->n);
    for (size_t k = 0; k < r->n; k++) {
        uint32_t j = r->column[k];
        if (j == i)
            *diagonal += r->value[j];
        else if (r->value[j] != 0)
            blocks_list_add(out, j, r->value[j]);
    }
    row_clear(r);
}

/* Adds the dummy j of a cut lattice to the row of particle i, with the weight w. */
static void add_dummy(const struct assembly *m, size_t i, uint32_t j, double w, struct row *r, double *g) {
    const struct cloud *c = m->c;
    if (c->away) {
        double stretch = stretch_of(m, i, j);
        row_add(r, (uint32_t)i, -w * (stretch - 1));
        *g += w * stretch * c->offset[j];
        return;
    }
    for (size_t k = c->begin[j - c->n]; k < c->begin[j - c->n + 1]; k++) row_add(r, c->from[k], w * c->share[k]);
    *g += w * c->offset[j];
}

/* Row i with --walls one_sided. */
static int add_wall_row(const struct assembly *m, struct heat_operator *a, size_t i, const struct surroundings *at,
                        struct row *r, double *g, struct failure *why) {
    struct wall_row row;
    if (m->s->at_wall(m->p, m->o, &at->nb, &row, why)) return why->status;
    for (size_t k = 0; k < at->nb.n; k++) row_add(r, at->near[k], row.w[k]);
    a->diagonal[i] = row.own;
    *g += row.g;
    return STATUS_OK;
}

/* Adds point j, a particle, ghost or dummy, to the row of particle i with the weight w. */
static void add_point(const struct assembly *m, size_t i, uint32_t j, double w, struct row *r, double *g) {
    const struct cloud *c = m->c;
    if (j >= c->n && c->begin) {
        add_dummy(m, i, j, w, r, g);
        return;
    }
    row_add(r, c->source[j], w * c->factor[j]);
    *g += c->offset[j] * w;
    if (r->images && j >= c->n) blocks_list_add(r->images, j, w);
}

/* Adds flux .  D T at point j; `of` receives its neighbourhood. */
static int add_derivative(const struct assembly *m, size_t i, uint32_t j, const double *flux, struct surroundings *of,
                          struct row *r, double *g, struct failure *why) {
    double weight[DIM_MAX][NEIGHBOURS_MAX], *w[] = {weight[0], weight[1], weight[2]}, own = 0;
    if (assembly_neighbourhood(m, j, of, why) || operator_weights(m->s, m->p, m->o, &of->nb, w, why))
        return why->status;
    for (size_t k = 0; k < of->nb.n; k++) {
        double sum = flux[0] * w[0][k];
        if (m->p->dim > 1) sum += flux[1] * w[1][k];
        if (m->p->dim > 2) sum += flux[2] * w[2][k];
        own -= sum;
        add_point(m, i, of->near[k], sum, r, g);
    }
    add_point(m, i, j, own, r, g);
    return STATUS_OK;
}

/* w K/rho_c, with K of the place of point j; of a ghost, beyond the wall. */
static void conduct(const struct assembly *m, const struct neighbourhood *nb, uint32_t j, const double w[DIM_MAX],
                    double flux[DIM_MAX]) {
    double x[DIM_MAX], K[DIM_MAX][DIM_MAX];
    for (int a = 0; a < nb->dim; a++) flux[a] = nb->kappa[a] * w[a];
    if (!problem_has_cross(m->p)) return;
    layout_cloud_place(m->c, j, x);
    problem_tensor(m->p, x, K);
    for (int b = 0; b < nb->dim; b++) {
        flux[b] = 0;
        for (int a = 0; a < nb->dim; a++) flux[b] += w[a] * K[a][b] / nb->rho_c;
    }
}

/* Adds sum_j w_ij . (q_j - q_i), or q_j + q_i for an adjoint scheme, with q = K D T/rho_c. */
static int add_composed_row(const struct assembly *m, size_t i, struct surroundings at[2], struct row *r, double *g,
                            struct failure *why) {
    double weight[DIM_MAX][NEIGHBOURS_MAX], *w[] = {weight[0], weight[1], weight[2]}, flux[DIM_MAX];
    double own[DIM_MAX] = {0};
    const double sign = m->s->adjoint ? 1 : -1;
    if (operator_weights(m->s, m->p, m->o, &at[0].nb, w, why)) return why->status;
    for (size_t k = 0; k < at[0].nb.n; k++) {
        const double here[DIM_MAX] = {w[0][k], m->p->dim > 1 ? w[1][k] : 0, m->p->dim > 2 ? w[2][k] : 0};
        conduct(m, &at[0].nb, (uint32_t)i, here, flux);
        for (int a = 0; a < m->p->dim; a++) own[a] += sign * flux[a];
        if (problem_has_cross(m->p)) conduct(m, &at[0].nb, at[0].near[k], here, flux);
        if (add_derivative(m, i, at[0].near[k], flux, &at[1], r, g, why)) return why->status;
    }
    return add_derivative(m, i, (uint32_t)i, own, &at[1], r, g, why);
}

static int add_row(const struct assembly *m, struct heat_operator *a, size_t i, struct surroundings at[2],
                   struct row *r, double *g, struct failure *why) {
    const struct cloud *c = m->c;
    double weight[NEIGHBOURS_MAX], *w[] = {weight};
    if (c->held && c->held[i]) return STATUS_OK;
    if (assembly_neighbourhood(m, i, at, why)) return why->status;
    if (is_at_wall(m, i)) return add_wall_row(m, a, i, at, r, g, why);
    if (m->s->sweeps == 2) return add_composed_row(m, i, at, r, g, why);
    if (operator_weights(m->s, m->p, m->o, &at->nb, w, why)) return why->status;
    for (size_t k = 0; k < at->nb.n; k++) {
        a->diagonal[i] -= weight[k];
        add_point(m, i, at->near[k], weight[k], r, g);
    }
    return STATUS_OK;
}

/* ---- All rows ---- */

struct rows {
    const struct assembly *m;
    struct heat_operator *a;
    double *g;
    struct blocks_list part[BLOCKS], images[BLOCKS];
};

static int add_rows(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct rows *all = context;
    const struct assembly *m = all->m;
    struct heat_operator *a = all->a;
    struct blocks_list *list = &all->part[b];
    struct row r;
    struct surroundings *at = xcalloc(2, sizeof *at);
    int status = STATUS_OK;
    row_create(&r, m->c->n);
    if (a->images) r.images = &all->images[b];
    for (size_t i = begin; i < end && !status; i++) {
        size_t before = list->n, images = all->images[b].n;
        status = add_row(m, a, i, at, &r, &all->g[i], why);
        move_row(&r, i, list, &a->diagonal[i]);
        a->row[i + 1] = list->n - before;
        if (a->images) a->images->row[i + 1] = all->images[b].n - images;
    }
    row_free(&r);
    free(at);
    return status;
}

/* Determines the bandwidth of A, and stores its bands if they have at most twice the entries of the rows. */
static void copy_bands(struct heat_operator *a) {
    ptrdiff_t n = (ptrdiff_t)a->n, band = 0;
    for (ptrdiff_t i = 0; i < n; i++)
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++)
            if (labs((ptrdiff_t)a->column[k] - i) > band) band = labs((ptrdiff_t)a->column[k] - i);
    size_t entries = (size_t)(2 * band + 1) * a->n;
    a->band = (int)band;
    if (entries > 2 * (a->row[a->n] + a->n)) return;
    a->banded = xcalloc(entries, sizeof *a->banded);
    for (ptrdiff_t i = 0; i < n; i++) {
        a->banded[band * n + i] = a->diagonal[i];
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++)
            a->banded[((ptrdiff_t)a->column[k] - i + band) * n + i] = a->value[k];
    }
    a->bytes += entries * sizeof *a->banded;
}

/* Keeps the volumes and heat capacities of the cells. */
static void keep_cells(struct assembly *m, struct heat_operator *a) {
    if (m->p->materials == 2) {
        a->rho_c = xcalloc(a->n, sizeof *a->rho_c);
        for (size_t i = 0; i < a->n; i++) a->rho_c[i] = rho_c_of(m, i);
        a->bytes += a->n * sizeof *a->rho_c;
    }
    a->volume = m->mesh.volume, m->mesh.volume = NULL;
}

/* An operator whose data change keeps the weights of its ghosts; the creator of the operator gives it the cloud. */
static void keep_images(struct heat_operator *a, struct rows *all) {
    struct images *to = a->images;
    size_t entries = blocks_list_join(all->images, a->n, to->row, &to->point, &to->weight);
    a->bytes += entries * (sizeof *to->point + sizeof *to->weight) + (a->n + 1) * sizeof *to->row;
}

/* Adds the source to g, K s^-1.  *a takes g over if any value is not zero. */
static void keep_constants(const struct assembly *m, double *g, struct heat_operator *a) {
    const struct problem *p = m->p;
    const struct cloud *c = m->c;
    for (size_t i = 0; i < a->n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(c, i, x);
        if (p->source) g[i] += p->source(p, x) / (a->rho_c ? a->rho_c[i] : layout_rho_c(p, m->cell, x[0]));
        if (c->held && c->held[i]) g[i] = 0;
        a->constant |= g[i] != 0;
    }
    if (a->constant)
        a->g = g, a->bytes += a->n * sizeof *g;
    else
        free(g);
}

static int assemble(struct heat_operator *a, const struct problem *p, const struct options *o, const struct scheme *s,
                    const struct cloud *c, double spacing, struct failure *why) {
    struct assembly m;
    if (assembly_create(&m, p, o, s, c, spacing, why)) return why->status;
    struct rows all = {.m = &m, .a = a, .g = xcalloc(a->n, sizeof *all.g)};
    a->row = xcalloc(a->n + 1, sizeof *a->row);
    a->diagonal = xcalloc(a->n, sizeof *a->diagonal);
    if (problem_changes(p)) {
        a->images = xcalloc(1, sizeof *a->images);
        a->images->row = xcalloc(a->n + 1, sizeof *a->images->row);
    }
    int status = blocks_run(a->n, o->threads, add_rows, &all, why);
    if (!status && s->cells) keep_cells(&m, a);
    assembly_free(&m); /* before the rows are copied, to limit peak memory */
    if (!status) {
        a->pairs = blocks_list_join(all.part, a->n, a->row, &a->column, &a->value);
        a->bytes += a->pairs * (sizeof *a->column + sizeof *a->value) + (a->n + 1) * sizeof *a->row +
                    a->n * sizeof *a->diagonal;
        copy_bands(a);
        if (a->images) keep_images(a, &all);
        keep_constants(&m, all.g, a);
    } else {
        free(all.g);
    }
    blocks_list_free(all.part);
    blocks_list_free(all.images);
    return status;
}

void assembly_constants(const struct heat_operator *a, const struct problem *p, const struct options *o, double t,
                        double *g) {
    const struct images *from = a->images;
    const struct cloud *c = from->cloud;
    struct later now;
    double *offset = xcalloc(c->total, sizeof *offset), x[DIM_MAX];
    problem_later(p, t, &now);
    for (size_t j = c->n; j < c->total; j++) offset[j] = layout_image_offset(&now.problem, o, c, j);
    for (size_t i = 0; i < a->n; i++) {
        layout_cloud_place(c, i, x);
        g[i] = p->source ? now.problem.source(&now.problem, x) / p->material[0].rho_c : 0;
        for (size_t k = from->row[i]; k < from->row[i + 1]; k++) g[i] += from->weight[k] * offset[from->point[k]];
    }
    free(offset);
}

int assembly_operator(struct heat_operator *a, const struct problem *p, const struct options *o,
                      const struct scheme *s, const struct cloud *c, double spacing, struct failure *why) {
    *a = (struct heat_operator){.n = c->n, .state = c->n, .threads = o->threads, .lanes = o->lanes};
    int status = assemble(a, p, o, s, c, spacing, why);
    if (status) operator_free(a);
    return status;
}
