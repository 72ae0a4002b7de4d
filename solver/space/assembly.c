/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Neighbourhoods of the points of a cloud, as input for schemes. */
#include "solver/space/assembly.h"
#include "solver/space/kernel.h"
#include "solver/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int assembly_in_blocks(size_t n, int threads,
                       int (*work)(void *context, int b, size_t begin, size_t end, struct failure *why),
                       void *context, struct failure *why) {
    int first = ASSEMBLY_BLOCKS;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads > 1 ? threads : 1)
    for (int b = 0; b < ASSEMBLY_BLOCKS; b++) {
        struct failure own;
        size_t begin = n * (size_t)b / ASSEMBLY_BLOCKS, end = n * (size_t)(b + 1) / ASSEMBLY_BLOCKS;
        if (work(context, b, begin, end, &own)) {
#pragma omp critical(assembly_failure)
            if (b < first) first = b, *why = own;
        }
    }
    return first < ASSEMBLY_BLOCKS ? why->status : STATUS_OK;
}

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

double assembly_rho_c(const struct assembly *m, size_t i) {
    const struct problem *p = m->p;
    if (!m->mesh.volume || p->materials < 2) return layout_rho_c(p, m->cell, m->c->x[i]);
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

double assembly_stretch(const struct assembly *m, size_t i, uint32_t j) {
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

int assembly_at_wall(const struct assembly *m, size_t i) {
    double x[DIM_MAX];
    if (!m->wide.cloud) return 0;
    layout_cloud_place(m->c, i, x);
    return shape_depth(m->p, x) < m->support;
}

int assembly_neighbourhood(const struct assembly *m, size_t i, struct surroundings *out, struct failure *why) {
    const struct cloud *c = m->c;
    const struct neighbours *cells = assembly_at_wall(m, i) ? &m->wide : &m->cells;
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
                                     .rho_c = assembly_rho_c(m, i)};
    for (int a = 0; a < DIM_MAX; a++) out->nb.kappa[a] = material->k[a] / material->rho_c;
    if (m->s->cells) {
        for (size_t k = 0; k < n; k++) out->X[k] = c->x[out->near[k]];
        out->nb.volume = m->mesh.volume[i], out->nb.face = m->mesh.face + m->mesh.begin[i], out->nb.X = out->X;
    }
    return STATUS_OK;
}

void assembly_list_grow(struct assembly_list *l) {
    l->room = l->room ? 2 * l->room : 64;
    l->point = xcheck(realloc(l->point, l->room * sizeof *l->point), l->room, sizeof *l->point);
    l->value = xcheck(realloc(l->value, l->room * sizeof *l->value), l->room, sizeof *l->value);
}

static void list_free(struct assembly_list *l) {
    free(l->point), free(l->value);
    l->point = NULL, l->value = NULL;
}

size_t assembly_list_join(struct assembly_list part[ASSEMBLY_BLOCKS], size_t n, size_t *begin, uint32_t **point,
                          double **value) {
    size_t total = 0;
    for (size_t i = 0; i < n; i++) begin[i + 1] += begin[i];
    for (int b = 0; b < ASSEMBLY_BLOCKS; b++) total += part[b].n;
    *point = xcalloc(total, sizeof **point);
    *value = xcalloc(total, sizeof **value);
    size_t at = total;
    for (int b = ASSEMBLY_BLOCKS - 1; b >= 0; b--) { /* last first: the end of the heap returns to the system */
        if (part[b].n == 0) continue;
        at -= part[b].n;
        memcpy(*point + at, part[b].point, part[b].n * sizeof **point);
        memcpy(*value + at, part[b].value, part[b].n * sizeof **value);
        list_free(&part[b]);
    }
    return total;
}

void assembly_list_free(struct assembly_list part[ASSEMBLY_BLOCKS]) {
    for (int b = 0; b < ASSEMBLY_BLOCKS; b++) list_free(&part[b]);
}

void assembly_keep_constants(const struct assembly *m, double *g, struct heat_operator *a) {
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
