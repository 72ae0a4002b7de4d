/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lattice cut by the walls at any position.
 *
 * On a rod or rectangle its points are lo + (i + 1/2 + shift) dx; under a round body it has any origin and angle.
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

struct frame {                      /* point (i, j) is at first + (i d[0], j d[1]) in its own axes */
    double first[2], d[2], axis[2]; /* m; m; cosine and sine */
    int blocks;                     /* side of a block */
    struct layout_moves moves;      /* and the range of indices */
    double moved;                   /* m, full width of the jitter */
    double clear;                   /* m, free strip along a wall */
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
    struct frame f = {.d = {l->dx[0], l->dx[1]}, .axis = {1, 0}, .moves = {.to = {1, 1}}};
    int core_from[2] = {0, 0}, core_to[2] = {1, 1};
    f.moved = o->layout == LAYOUT_JITTER ? 2 * o->jitter * l->dx[0] : 0;
    f.hexagonal = o->layout == LAYOUT_HEXAGONAL && p->dim == 2;
    f.clear = p->shape && o->walls == WALLS_MIRROR ? CLEAR * l->dx[0] : 0;
    if (p->shape) {
        double origin[2] = {gsl_rng_uniform(random), gsl_rng_uniform(random)}, angle = 90 * gsl_rng_uniform(random);
        if (f.hexagonal) f.d[1] = sqrt(0.75) * f.d[0];
        if (o->has_angle) angle = o->angle;
        for (int a = 0; a < 2; a++) f.first[a] = f.d[a] * (o->has_origin ? o->origin[a] : origin[a]);
        f.axis[0] = cos(angle * M_PI / 180), f.axis[1] = sin(angle * M_PI / 180);
    }
    for (int a = 0; a < p->dim; a++) {
        if (!p->shape) f.first[a] = p->lo[a] + (0.5 + o->shift) * f.d[a];
        take_range(p, a, &f, reach, &f.moves.from[a], &f.moves.to[a]);
        take_range(p, a, &f, CORE * l->dx[0], &core_from[a], &core_to[a]);
    }
    layout_moves_draw(&f.moves, p->dim, core_from, core_to, random);
    f.blocks = (int)fmax(1, floor(reach / l->dx[0]));
    return f;
}

/* Point (i, j): in the axes of the lattice, `at`, and in the plane, x. */
static void place(const struct frame *f, int dim, int i, int j, double at[2], double x[2]) {
    at[0] = f->first[0] + i * f->d[0];
    at[1] = dim == 2 ? f->first[1] + j * f->d[1] : 0;
    if (f->hexagonal) at[0] += (j % 2 ? 0.25 : -0.25) * f->d[0];
    for (int a = 0; a < dim && f->moved > 0; a++) at[a] += f->moved * layout_moves_at(&f->moves, i, j, a);
    x[0] = f->axis[0] * at[0] - f->axis[1] * at[1];
    x[1] = f->axis[1] * at[0] + f->axis[0] * at[1];
}

struct list { /* points, x and y alternating, and the cells of particles */
    size_t n, room;
    double *x, *cell;
    unsigned char *held;
};

static void list_add(struct list *l, const double x[2], double cell, int held) {
    if (l->n == l->room) {
        size_t room = l->room ? 2 * l->room : 256;
        l->x = xgrow(l->x, 2 * l->n, 2 * room, sizeof *l->x);
        l->cell = xgrow(l->cell, l->n, room, sizeof *l->cell);
        l->held = xgrow(l->held, l->n, room, sizeof *l->held);
        l->room = room;
    }
    l->x[2 * l->n] = x[0], l->x[2 * l->n + 1] = x[1];
    l->cell[l->n] = cell, l->held[l->n++] = (unsigned char)held;
}

static void list_free(struct list *l) {
    free(l->x);
    free(l->cell);
    free(l->held);
}

/* Distance of a point from the body, m; beyond a corner that from the corner. */
static double beyond(const struct problem *p, const double x[2], double depth) {
    double away[2] = {0, 0};
    if (p->shape) return -depth;
    for (int a = 0; a < p->dim; a++) away[a] = fmax(0, fmax(p->lo[a] - x[a], x[a] - p->hi[a]));
    return hypot(away[0], away[1]);
}

static void sort_point(const struct problem *p, const struct frame *f, const double at[2], const double x[2],
                       double reach, struct list *inside, struct list *outside) {
    int wall;
    double depth = shape_nearest(p, x, &wall).depth, on = LAYOUT_ON_WALL * f->d[0], lo[2], hi[2];
    if (f->clear > 0 && depth < f->clear) return;
    if (!(depth >= -on)) {
        if (beyond(p, x, depth) < reach) list_add(outside, x, 0, 0);
        return;
    }
    for (int a = 0; a < 2; a++) lo[a] = at[a] - f->d[a] / 2, hi[a] = at[a] + f->d[a] / 2;
    list_add(inside, x, shape_clipped(p, lo, hi), depth <= on && p->side[wall] == DIRICHLET);
}

static void fill(struct cloud *c, const struct list *inside, const struct list *outside, size_t room) {
    c->x = xcalloc(room, sizeof *c->x);
    c->y = xcalloc(room, sizeof *c->y);
    c->source = xcalloc(room, sizeof *c->source);
    c->factor = xcalloc(room, sizeof *c->factor);
    c->offset = xcalloc(room, sizeof *c->offset);
    c->cell = xcalloc(c->n, sizeof *c->cell);
    c->held = xcalloc(c->n, 1);
    for (size_t i = 0; i < c->total; i++) {
        const double *x = i < c->n ? inside->x + 2 * i : outside->x + 2 * (i - c->n);
        c->x[i] = x[0], c->y[i] = x[1];
        c->source[i] = i < c->n ? (uint32_t)i : 0;
        c->factor[i] = i < c->n;
    }
    for (size_t i = 0; i < c->n; i++) c->cell[i] = inside->cell[i], c->held[i] = inside->held[i];
}

/* Replaces the dummies by images of the particles in plane walls.  A particle on a wall is its own image. */
static void mirror(const struct problem *p, const struct options *o, const struct lattice *l, struct cloud *c) {
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++)
        if (shape_depth(p, (const double[2]){c->x[i], c->y[i]}) > LAYOUT_ON_WALL * l->dx[0])
            layout_mirror(p, o, l, i, c);
}

/* The images of all particles in round walls: as far beyond the nearest point of each as the particle is in front. Of
 * cells they are mirror ghosts, else dummies that hold nothing yet. */
static void mirror_round(const struct problem *p, struct cloud *c) {
    const double k = p->material[0].k[0];
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++) {
        const double x[2] = {c->x[i], c->y[i]};
        for (int s = X_LO; s <= X_HI; s++) {
            if (!shape_has_wall(p, s)) continue;
            struct foot foot = shape_foot(p, s, x);
            if (foot.depth >= c->reach) continue;
            size_t g = c->total++;
            for (int a = 0; a < 2; a++) (a ? c->y : c->x)[g] = x[a] + 2 * foot.depth * foot.normal[a];
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
    struct list inside = {0}, outside = {0};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    struct frame f = frame_of(p, o, l, reach, random);
    gsl_rng_free(random);
    const int *from = f.moves.from, *to = f.moves.to;
    for (int j0 = from[1]; j0 < to[1]; j0 += f.blocks)
        for (int i0 = from[0]; i0 < to[0]; i0 += f.blocks)
            for (int j = j0; j < j0 + f.blocks && j < to[1]; j++)
                for (int i = i0; i < i0 + f.blocks && i < to[0]; i++) {
                    double at[2], x[2];
                    place(&f, p->dim, i, j, at, x);
                    sort_point(p, &f, at, x, reach, &inside, &outside);
                }
    layout_moves_free(&f.moves);
    int mirrors = o->walls == WALLS_MIRROR;
    if (o->walls == WALLS_ONE_SIDED) outside.n = 0;
    *c = (struct cloud){.dim = p->dim, .n = inside.n, .total = inside.n + outside.n, .reach = reach};
    c->volume = f.d[0] * (p->dim == 2 ? f.d[1] : 1);
    fill(c, &inside, &outside, mirrors ? 4 * c->total : c->total);
    if (mirrors && p->shape)
        mirror_round(p, c);
    else if (mirrors)
        mirror(p, o, l, c);
    list_free(&inside);
    list_free(&outside);
    if (c->n > 0) return STATUS_OK;
    layout_cloud_free(c);
    return refuse(why, STATUS_INPUT, "--dx %g: no point of the lattice is in the body; use a smaller --dx", o->dx);
}
