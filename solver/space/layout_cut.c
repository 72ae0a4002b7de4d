/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lattice cut by the walls at any position.
 *
 * On a rod, rectangle or box its points are lo + (i + 1/2 + shift) dx; under a round body it has any origin and
 * angle (about z).
 * Each point is moved by the layout (jitter: within +-A dx; hexagonal: rows sqrt(3)/2 dx apart).  Points inside the
 * body, or on its wall to 1e-6 dx, are particles, points beyond it dummies.  A round body about 0 looks the same from
 * the axes of its lattice: cells are clipped there. */
#include "solver/shape.h"
#include "solver/space/layout.h"

#include <math.h>
#include <stdlib.h>

/* dx, least distance of a particle from a round wall with its image beyond; nearer points are left out.  A cell
 * conducts to its wall as 1/depth, and the largest stable step falls with the depth. */
static const double CLEAR = 0.25;

struct frame { /* point (i, j, k) is at first + (i d[0], ...) in its own axes */
    int dim;
    double first[DIM_MAX], d[DIM_MAX]; /* m */
    double axis[2];                    /* cosine and sine of the angle about z */
    int blocks[DIM_MAX];               /* sides of a block */
    struct layout_moves moves;         /* and the range of indices */
    double moved;                      /* m, full width of the jitter */
    double clear;                      /* m, free strip along a wall */
    int hexagonal;
};

int layout_is_cut(const struct problem *p, const struct options *o) {
    return p->shape || o->shift > 0 || o->walls > WALLS_FIXED;
}

/* Indices along an axis of the points up to `reach` from the body. */
static void take_range(const struct problem *p, int a, const struct frame *f, double reach, int *from, int *to) {
    *from = (int)floor((p->lo[a] - reach - f->first[a]) / f->d[a]) - 1;
    *to = (int)ceil((p->hi[a] + reach - f->first[a]) / f->d[a]) + 2;
}

static struct frame frame_of(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                             gsl_rng *random) {
    const double CORE = 2.2; /* dx: the reach of so_ssph; displacements within are the same for all operators */
    struct frame f = {
        .dim = p->dim, .d = {l->dx[0], l->dx[1], l->dx[2]}, .axis = {1, 0}, .moves = {p->dim, {0}, {1, 1, 1}, NULL}};
    int core_from[DIM_MAX] = {0}, core_to[DIM_MAX] = {1, 1, 1};
    f.moved = o->layout == LAYOUT_JITTER ? 2 * o->jitter * l->dx[0] : 0;
    f.hexagonal = o->layout == LAYOUT_HEXAGONAL && p->dim == 2;
    f.clear = p->shape && o->walls == WALLS_MIRROR ? CLEAR * l->dx[0] : 0;
    if (p->shape) {
        double origin[DIM_MAX];
        for (int a = 0; a < p->dim; a++) origin[a] = gsl_rng_uniform(random);
        double angle = 90 * gsl_rng_uniform(random);
        if (f.hexagonal) f.d[1] = sqrt(0.75) * f.d[0];
        if (o->has_angle) angle = o->angle;
        for (int a = 0; a < p->dim; a++) f.first[a] = f.d[a] * (o->has_origin ? o->origin[a] : origin[a]);
        f.axis[0] = cos(angle * M_PI / 180), f.axis[1] = sin(angle * M_PI / 180);
    }
    for (int a = 0; a < p->dim; a++) {
        if (!p->shape) f.first[a] = p->lo[a] + (0.5 + o->shift) * f.d[a];
        take_range(p, a, &f, reach, &f.moves.from[a], &f.moves.to[a]);
        take_range(p, a, &f, CORE * l->dx[0], &core_from[a], &core_to[a]);
    }
    layout_moves_draw(&f.moves, core_from, core_to, random);
    for (int a = 0; a < DIM_MAX; a++) f.blocks[a] = (int)fmax(1, floor(reach / l->dx[0]));
    return f;
}

/* A point by its index: in the axes of the lattice, `at`, and in those of the body, x. */
static void place(const struct frame *f, const int index[DIM_MAX], double at[DIM_MAX], double x[DIM_MAX]) {
    const double *move = layout_moves_at(&f->moves, index);
    for (int a = 0; a < DIM_MAX; a++) at[a] = a < f->dim ? f->first[a] + index[a] * f->d[a] : 0;
    if (f->hexagonal) at[0] += (index[1] % 2 ? 0.25 : -0.25) * f->d[0];
    for (int a = 0; a < f->dim && f->moved > 0; a++) at[a] += f->moved * move[a];
    x[0] = f->axis[0] * at[0] - f->axis[1] * at[1];
    x[1] = f->axis[1] * at[0] + f->axis[0] * at[1];
    x[2] = at[2];
}

struct list { /* points, DIM_MAX coordinates each, and the cells of particles */
    size_t n, room;
    double *x, *cell;
    unsigned char *held;
};

static void list_add(struct list *l, const double x[DIM_MAX], double cell, int held) {
    if (l->n == l->room) {
        size_t room = l->room ? 2 * l->room : 256;
        l->x = xgrow(l->x, DIM_MAX * l->n, DIM_MAX * room, sizeof *l->x);
        l->cell = xgrow(l->cell, l->n, room, sizeof *l->cell);
        l->held = xgrow(l->held, l->n, room, sizeof *l->held);
        l->room = room;
    }
    for (size_t a = 0; a < DIM_MAX; a++) l->x[DIM_MAX * l->n + a] = x[a];
    l->cell[l->n] = cell, l->held[l->n++] = (unsigned char)held;
}

static void list_free(struct list *l) {
    free(l->x);
    free(l->cell);
    free(l->held);
}

/* Distance of a point from the body, m; beyond an edge or a corner that from it. */
static double beyond(const struct problem *p, const double *x, double depth) {
    double away[DIM_MAX] = {0};
    if (p->shape) return -depth;
    for (int a = 0; a < p->dim; a++) away[a] = fmax(0, fmax(p->lo[a] - x[a], x[a] - p->hi[a]));
    return hypot(hypot(away[0], away[1]), away[2]);
}

struct points {
    const struct problem *p;
    struct frame f;
    double reach; /* m */
    struct list inside, outside;
};

static void sort_point(void *context, const int index[DIM_MAX]) {
    struct points *all = context;
    const struct problem *p = all->p;
    const struct frame *f = &all->f;
    int wall;
    double at[DIM_MAX], x[DIM_MAX], lo[DIM_MAX], hi[DIM_MAX];
    place(f, index, at, x);
    double depth = shape_nearest(p, x, &wall).depth, on = LAYOUT_ON_WALL * f->d[0];
    if (f->clear > 0 && depth < f->clear) return;
    if (!(depth >= -on)) {
        if (beyond(p, x, depth) < all->reach) list_add(&all->outside, x, 0, 0);
        return;
    }
    for (int a = 0; a < DIM_MAX; a++) lo[a] = at[a] - f->d[a] / 2, hi[a] = at[a] + f->d[a] / 2;
    list_add(&all->inside, x, shape_clipped(p, lo, hi), depth <= on && p->side[wall] == DIRICHLET);
}

static void fill(struct cloud *c, const struct list *inside, const struct list *outside, size_t room) {
    layout_cloud_alloc(c, room);
    c->cell = xcalloc(c->n, sizeof *c->cell);
    c->held = xcalloc(c->n, 1);
    for (size_t i = 0; i < c->total; i++) {
        layout_cloud_put(c, i, i < c->n ? inside->x + DIM_MAX * i : outside->x + DIM_MAX * (i - c->n));
        c->source[i] = i < c->n ? (uint32_t)i : 0;
        c->factor[i] = i < c->n;
    }
    for (size_t i = 0; i < c->n; i++) c->cell[i] = inside->cell[i], c->held[i] = inside->held[i];
}

/* Replaces the dummies by images of the particles in plane walls.  A particle on a wall is its own image. */
static void mirror(const struct problem *p, const struct options *o, const struct lattice *l, struct cloud *c) {
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(c, i, x);
        if (shape_depth(p, x) > LAYOUT_ON_WALL * l->dx[0]) layout_mirror(p, o, l, i, c);
    }
}

/* The images of all particles in round walls: as far beyond the nearest point of each as the particle is in front. Of
 * cells they are mirror ghosts, else dummies that hold nothing yet. */
static void mirror_round(const struct problem *p, struct cloud *c) {
    const double k = p->material[0].k[0];
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++) {
        double x[DIM_MAX], image[DIM_MAX];
        layout_cloud_place(c, i, x);
        for (int s = X_LO; s <= X_HI; s++) {
            if (!shape_has_wall(p, s)) continue;
            struct foot foot = shape_foot(p, s, x);
            if (foot.depth >= c->reach) continue;
            size_t g = c->total++;
            for (int a = 0; a < DIM_MAX; a++) image[a] = x[a] + 2 * foot.depth * foot.normal[a];
            layout_cloud_put(c, g, image);
            double value = p->wall(p, (enum side)s, foot.x, 0);
            double sign = p->side[s] == DIRICHLET ? -1 : layout_robin_factor(p, s, k, foot.depth);
            c->source[g] = (uint32_t)i;
            c->factor[g] = sign;
            c->offset[g] = p->side[s] == NEUMANN ? 2 * foot.depth * value / k : (1 - sign) * value;
        }
    }
}

int layout_cut(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
               struct cloud *c, struct failure *why) {
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    struct points all = {p, frame_of(p, o, l, reach, random), reach, {0}, {0}};
    gsl_rng_free(random);
    layout_in_blocks(all.f.moves.from, all.f.moves.to, all.f.blocks, sort_point, &all);
    layout_moves_free(&all.f.moves);
    int mirrors = o->walls == WALLS_MIRROR;
    if (o->walls == WALLS_ONE_SIDED) all.outside.n = 0;
    *c = (struct cloud){.dim = p->dim, .n = all.inside.n, .total = all.inside.n + all.outside.n, .reach = reach};
    c->volume = all.f.d[0] * all.f.d[1] * all.f.d[2];
    fill(c, &all.inside, &all.outside, mirrors ? (p->dim == 3 ? 8 : 4) * c->total : c->total);
    if (mirrors && p->shape)
        mirror_round(p, c);
    else if (mirrors)
        mirror(p, o, l, c);
    list_free(&all.inside);
    list_free(&all.outside);
    if (c->n > 0) return STATUS_OK;
    layout_cloud_free(c);
    return refuse(why, STATUS_INPUT, "--dx %g: no point of the lattice is in the body; use a smaller --dx", o->dx);
}
