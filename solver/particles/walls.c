/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies: the table of treatments, the wall at a dummy, and the particles near it. */
#include "solver/particles/walls.h"

#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* NULL for walls without dummies. */
static const struct wall_treatment *treatment(enum walls walls) {
    static const struct wall_treatment *const all[] = {
        [WALLS_FIXED] = &walls_fixed, [WALLS_DISTANCE] = &walls_distance, [WALLS_AVERAGE] = &walls_average,
        [WALLS_IMAGE] = &walls_image, [WALLS_FIT] = &walls_fit,           [WALLS_ONE_SIDED] = NULL};
    return all[walls];
}

unsigned walls_kinds(enum walls walls) {
    const struct wall_treatment *t = treatment(walls);
    return t ? t->kinds : 1u << DIRICHLET | 1u << NEUMANN | 1u << ROBIN;
}

/* ---- The wall at a dummy ---- */

static void site_add(const struct problem *p, int s, const double *x, struct wall_site *site) {
    int n = site->walls++;
    struct foot f = shape_foot(p, s, x);
    site->side[n] = (enum side)s;
    memcpy(site->normal[n], f.normal, sizeof f.normal);
    site->away[n] = -f.depth;
    site->value[n] = p->wall(p, (enum side)s, site->foot, 0);
    site->k[n] = p->material[0].k[walls_axis(f.normal)];
}

static struct wall_site site_of(const struct problem *p, const struct cloud *c, size_t j) {
    struct wall_site site = {0};
    const double *x = site.x;
    layout_cloud_place(c, j, site.x);
    if (p->shape) {
        int s;
        struct foot f = shape_nearest(p, x, &s);
        memcpy(site.foot, f.x, sizeof f.x);
        site_add(p, s, x, &site);
        return site;
    }
    for (int a = 0; a < p->dim; a++) site.foot[a] = fmin(fmax(x[a], p->lo[a]), p->hi[a]);
    for (int s = 0; s < 2 * p->dim; s++)
        if (shape_has_wall(p, s) && shape_foot(p, s, x).depth < 0) site_add(p, s, x, &site);
    return site;
}

/* ---- The particles near a dummy ---- */

static void probe_create(struct walls_fill *w, const struct wall_treatment *t) {
    const struct cloud *c = w->c;
    struct cloud *q = w->probe = xcalloc(1, sizeof *q);
    *q = (struct cloud){.dim = c->dim, .n = c->n, .total = c->total};
    layout_cloud_alloc(q, q->total);
    for (size_t j = 0; j < c->total; j++) {
        double x[DIM_MAX];
        layout_cloud_place(c, j, x);
        if (j >= c->n) {
            struct wall_site site = site_of(w->p, c, j);
            t->place(&site, x);
        }
        layout_cloud_put(q, j, x);
    }
    neighbours_create(&w->cells, q, KERNEL_SUPPORT * w->widest * w->o->h * w->spacing);
}

static void probe_free(struct walls_fill *w) {
    if (!w->probe) return;
    neighbours_free(&w->cells);
    layout_cloud_free(w->probe);
    free(w->probe);
}

int walls_near(const struct walls_fill *w, size_t d, size_t least,
               int (*attempt)(const struct walls_fill *w, const struct wall_near *near, void *with,
                              struct failure *why),
               void *with, struct failure *why) {
    const struct cloud *q = w->probe;
    size_t place = q->n + d;
    uint32_t *all = xcalloc(NEIGHBOURS_MAX, sizeof *all);
    struct wall_near *near = xcalloc(1, sizeof *near);
    near->nb = (struct neighbourhood){.dim = q->dim, .i = place, .d = near->d};
    layout_cloud_place(q, place, near->nb.x);
    size_t found = neighbours_find(&w->cells, place, all, NEIGHBOURS_MAX);
    if (found > NEIGHBOURS_MAX) { /* dummies share a foot; the particles among them must not be cut off */
        free(all);
        all = xcalloc(found, sizeof *all);
        neighbours_find(&w->cells, place, all, found);
    }
    struct failure last; /* failure of the attempts; a success leaves *why unchanged */
    char text[PLACE_TEXT];
    const double *x = near->nb.x;
    int status =
        refuse(&last, STATUS_NUMERICAL, "the wall at %s has fewer than %zu particles within %g h; use a smaller --dx",
               problem_place(q->dim, x, text), least, KERNEL_SUPPORT * w->widest);
    for (double grown = 1; grown <= w->widest && status; grown *= 1.1) {
        double H = grown * w->o->h * w->spacing, most = KERNEL_SUPPORT * H * (1 - 1e-9);
        size_t n = 0;
        for (size_t k = 0; k < found && n < NEIGHBOURS_MAX; k++) {
            if (all[k] >= q->n) continue;
            layout_cloud_place(q, all[k], near->d[n]);
            for (int a = 0; a < DIM_MAX; a++) near->d[n][a] -= x[a];
            if (neighbourhood_distance(&near->nb, n) >= most) continue;
            near->from[n++] = all[k];
        }
        near->nb.n = n, near->nb.h = H;
        if (n >= least) status = attempt(w, near, with, &last);
    }
    if (status) *why = last;
    free(near);
    free(all);
    return status;
}

/* ---- All dummies ---- */

static void keep(struct cloud *c, size_t d, const struct wall_sum *sum, size_t *room) {
    size_t used = c->begin[d];
    while (used + sum->n > *room) {
        size_t more = *room ? 2 * *room : 1024;
        c->from = xgrow(c->from, *room, more, sizeof *c->from);
        c->share = xgrow(c->share, *room, more, sizeof *c->share);
        *room = more;
    }
    for (size_t k = 0; k < sum->n; k++) c->from[used + k] = sum->from[k], c->share[used + k] = sum->share[k];
    c->begin[d + 1] = used + sum->n;
    c->offset[c->n + d] = sum->offset;
}

int walls_fill(const struct problem *p, const struct options *o, struct cloud *c, double spacing,
               struct failure *why) {
    const struct wall_treatment *t = treatment(o->walls);
    struct walls_fill w = {.p = p, .o = o, .c = c, .spacing = spacing, .widest = assembly_widest(p->dim, o->h)};
    size_t dummies = c->total - c->n, room = 0;
    int status = STATUS_OK;
    if (!layout_is_cut(p, o) || !t) return STATUS_OK;
    c->begin = xcalloc(dummies + 1, sizeof *c->begin);
    if (t->pairs) c->away = xcalloc(dummies, sizeof *c->away);
    if (t->place) probe_create(&w, t);
    struct wall_sum *sum = xcalloc(1, sizeof *sum);
    for (size_t d = 0; d < dummies && !status; d++) {
        struct wall_site site = site_of(p, c, c->n + d);
        sum->n = 0;
        status = t->fill(&w, d, &site, sum, why);
        keep(c, d, sum, &room);
        if (c->away) c->away[d] = site.away[0];
    }
    free(sum);
    probe_free(&w);
    return status;
}
