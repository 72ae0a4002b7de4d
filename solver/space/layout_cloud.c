/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles off the lattice, and their ghosts: mirror images beyond the walls, which keep the boundary conditions
 * exact.
 *
 * Jitter: each particle of the cell-centred lattice is displaced uniformly within +-A dx along each axis.  The
 * displacements depend on the seed alone: points are drawn in blocks of two along each axis, whatever the reach of
 * the operator, first those of the core and then those around it, so that all operators get the same particles.
 * Relaxed: these particles settle by relax.c.  Hexagonal: rows sqrt(3)/2 dx apart, stretched to fill the height and
 * displaced by dx/4 to alternating sides.  A hexagonal lattice has its mirror lines through particles.  The walls
 * mirror between rows, so one row of pairs along each wall is dx/2 and 3/2 dx apart.  On a rod the hexagonal layout
 * is the lattice.
 *
 * A lattice may be cut by the walls at any position.  On a rod, rectangle or box its points are lo + (i + 1/2 +
 * shift) dx; under a round body it has any origin and angle (about z).  Each point is moved by the layout (jitter or
 * hexagonal).  Points inside the body, or on its wall to 1e-6 dx, are particles, points beyond it dummies.  Cells are
 * clipped in the axes of the lattice: a round body about 0 is the same there. */
#include "solver/space/layout.h"

#include "solver/shape.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Blocks of lattice points, and their displacements ---- */

/* Advances an index by `step`, x fastest; 0 at the end. */
static int next_index(int at[DIM_MAX], const int from[DIM_MAX], const int to[DIM_MAX], const int step[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) {
        at[a] += step[a];
        if (at[a] < to[a]) return 1;
        at[a] = from[a];
    }
    return 0;
}

/* Calls visit for all indices from <= at < to, block by block of the given sides; x is fastest among blocks and in
 * each. */
static void in_blocks(const int from[DIM_MAX], const int to[DIM_MAX], const int side[DIM_MAX],
                      void (*visit)(void *context, const int at[DIM_MAX]), void *context) {
    static const int one[DIM_MAX] = {1, 1, 1};
    int block[DIM_MAX], end[DIM_MAX], at[DIM_MAX];
    memcpy(block, from, sizeof block);
    do {
        for (int a = 0; a < DIM_MAX; a++) end[a] = block[a] + side[a] < to[a] ? block[a] + side[a] : to[a];
        memcpy(at, block, sizeof at);
        do visit(context, at);
        while (next_index(at, block, end, one));
    } while (next_index(block, from, to, side));
}

/* Displacements of the points with from <= index < to, in widths of the jitter, -1/2 to 1/2. */
struct moves {
    int dim, from[DIM_MAX], to[DIM_MAX]; /* 0 and 1 past dim */
    double *move;                        /* dim for each point */
};

static size_t moves_index(const struct moves *m, const int at[DIM_MAX]) {
    size_t k = 0;
    for (int a = DIM_MAX - 1; a >= 0; a--) k = k * (size_t)(m->to[a] - m->from[a]) + (size_t)(at[a] - m->from[a]);
    return k * (size_t)m->dim;
}

static int is_in(const int from[DIM_MAX], const int to[DIM_MAX], const int at[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++)
        if (at[a] < from[a] || at[a] >= to[a]) return 0;
    return 1;
}

struct draw {
    struct moves *m;
    gsl_rng *random;
    const int *core_from, *core_to; /* NULL within the core */
};

static void draw(void *context, const int at[DIM_MAX]) {
    const struct draw *d = context;
    double unused[DIM_MAX], *move = is_in(d->m->from, d->m->to, at) ? d->m->move + moves_index(d->m, at) : unused;
    if (d->core_from && is_in(d->core_from, d->core_to, at)) return;
    for (int a = 0; a < d->m->dim; a++) move[a] = gsl_rng_uniform(d->random) - 0.5;
}

/* Fills m->move for m->from and m->to.  If a core is given, its displacements depend on the core and the random
 * numbers alone. */
static void moves_draw(struct moves *m, const int core_from[DIM_MAX], const int core_to[DIM_MAX], gsl_rng *random) {
    static const int block[DIM_MAX] = {2, 2, 2};
    size_t points = 1;
    int all[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) all[a] = m->to[a] - m->from[a], points *= (size_t)all[a];
    m->move = xcalloc(points * (size_t)m->dim, sizeof *m->move);
    in_blocks(core_from, core_to, block, draw, &(struct draw){m, random, NULL, NULL});
    in_blocks(m->from, m->to, all, draw, &(struct draw){m, random, core_from, core_to});
}

static const double *moves_at(const struct moves *m, const int at[DIM_MAX]) {
    return m->move + moves_index(m, at);
}

static void moves_free(struct moves *m) {
    free(m->move);
    m->move = NULL;
}

/* ---- Images beyond plane walls ---- */

/* Appends the image of particle i beyond the sides, side[a] along axis a or -1. */
static void append_image(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                         const double source[DIM_MAX], const int side[DIM_MAX], struct cloud *c) {
    double ghost[DIM_MAX] = {source[0], source[1], source[2]}, factor = 1;
    size_t k = c->total++;
    for (int a = 0; a < p->dim; a++) {
        if (side[a] < 0) continue;
        double wall = side[a] % 2 ? p->hi[a] : p->lo[a], extent = p->hi[a] - p->lo[a];
        int periodic = p->side[side[a]] == PERIODIC;
        ghost[a] = periodic ? source[a] + (side[a] % 2 ? -extent : extent) : 2 * wall - source[a];
        if (l->sign[side[a]] == LAYOUT_RECURRENCE)
            factor *= layout_image_factor(p, side[a], p->material[layout_material(p, ghost[0])].k[a],
                                          fabs(source[a] - wall));
        else
            factor *= l->sign[side[a]];
    }
    layout_cloud_put(c, k, ghost);
    c->source[k] = (uint32_t)i;
    c->factor[k] = factor;
    c->offset[k] = layout_ghost_offset(p, o->walls, NULL, side, ghost, source);
}

double layout_image_offset(const struct problem *p, const struct options *o, const struct cloud *c, size_t j) {
    double ghost[DIM_MAX], source[DIM_MAX];
    int side[DIM_MAX] = {-1, -1, -1};
    layout_cloud_place(c, j, ghost);
    layout_cloud_place(c, c->source[j], source);
    for (int a = 0; a < p->dim; a++) side[a] = ghost[a] < p->lo[a] ? 2 * a : ghost[a] > p->hi[a] ? 2 * a + 1 : -1;
    return layout_ghost_offset(p, o->walls, NULL, side, ghost, source);
}

/* Appends the images of particle i beyond plane walls, up to three (seven in space), to the cloud, whose arrays have
 * room for them. */
static void append_images(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                          struct cloud *c) {
    double source[DIM_MAX], depth = INFINITY;
    int images = 1;
    layout_cloud_place(c, i, source);
    for (int a = 0; a < p->dim; a++)
        images *= 3, depth = fmin(depth, fmin(source[a] - p->lo[a], p->hi[a] - source[a]));
    if (depth >= c->reach) return;                 /* most particles of a large cloud */
    for (int image = 1; image < images; image++) { /* a digit an axis: not beyond it, beyond its low or high side */
        int side[DIM_MAX] = {-1, -1, -1}, near = 1;
        for (int a = p->dim - 1, digits = image; a >= 0; a--, digits /= 3)
            if (digits % 3) side[a] = 2 * a + digits % 3 - 1;
        for (int a = 0; a < p->dim && near; a++)
            near = side[a] < 0 || fabs(source[a] - (side[a] % 2 ? p->hi[a] : p->lo[a])) < c->reach;
        if (near) append_image(p, o, l, i, source, side, c);
    }
}

/* ---- Between the walls ---- */

struct placing { /* places all particles */
    const struct options *o;
    const struct lattice *l;
    struct moves moves;
    double amplitude; /* dx */
    struct cloud *c;
    size_t k;
};

static void place_point(void *context, const int at[DIM_MAX]) {
    struct placing *t = context;
    const struct lattice *l = t->l;
    const double *move = moves_at(&t->moves, at);
    double x[DIM_MAX];
    layout_position(l, at[0], at[1], at[2], x);
    if (t->o->layout == LAYOUT_HEXAGONAL && l->dim == 2) x[0] += (at[1] % 2 ? 0.25 : -0.25) * l->dx[0];
    for (int a = 0; a < l->dim; a++) x[a] += t->amplitude * l->dx[a] * move[a];
    layout_cloud_put(t->c, t->k, x);
    t->c->source[t->k] = (uint32_t)t->k;
    t->c->factor[t->k++] = 1;
}

/* Orders particles by square or cubic cells of side `reach`, so that neighbours in space are neighbours in memory. */
static void place_particles(const struct options *o, const struct lattice *l, double reach, struct cloud *c) {
    int block[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) block[a] = a < l->dim ? (int)fmax(1, floor(reach / l->dx[a])) : 1;
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    struct placing t = {o, l, {l->dim, {0, 0, 0}, {l->n[0], l->n[1], l->n[2]}, NULL}, 0, c, 0};
    if (o->layout == LAYOUT_JITTER || o->layout == LAYOUT_RELAXED) t.amplitude = 2 * o->jitter;
    moves_draw(&t.moves, t.moves.from, t.moves.to, random);
    gsl_rng_free(random);
    in_blocks(t.moves.from, t.moves.to, block, place_point, &t);
    moves_free(&t.moves);
}

/* ---- Cut by the walls ---- */

/* dx, least distance of a particle from a round wall with its image beyond; nearer points are left out.  A cell
 * conducts to its wall as 1/depth, and the largest stable step falls with the depth. */
static const double CLEAR = 0.25;

struct frame { /* point (i, j, k) is at first + (i d[0], ...) in its own axes */
    int dim;
    double first[DIM_MAX], d[DIM_MAX]; /* m */
    double axis[2];                    /* cosine and sine of the angle about z */
    int blocks[DIM_MAX];               /* sides of a block */
    struct moves moves;                /* and the range of indices */
    double moved;                      /* m, full width of the jitter */
    double clear;                      /* m, free strip along a wall */
    int hexagonal;
};

int layout_is_cut(const struct problem *p, const struct options *o) {
    return p->shape || o->shift > 0 || o->walls > WALLS_FIXED;
}

/* Indices along an axis of the points up to `reach` from the body. */
static void set_range(const struct problem *p, int a, const struct frame *f, double reach, int *from, int *to) {
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
        set_range(p, a, &f, reach, &f.moves.from[a], &f.moves.to[a]);
        set_range(p, a, &f, CORE * l->dx[0], &core_from[a], &core_to[a]);
    }
    moves_draw(&f.moves, core_from, core_to, random);
    for (int a = 0; a < DIM_MAX; a++) f.blocks[a] = (int)fmax(1, floor(reach / l->dx[0]));
    return f;
}

/* A point by its index: in the axes of the lattice, `at`, and in those of the body, x. */
static void locate(const struct frame *f, const int index[DIM_MAX], double at[DIM_MAX], double x[DIM_MAX]) {
    const double *move = moves_at(&f->moves, index);
    for (int a = 0; a < DIM_MAX; a++) at[a] = a < f->dim ? f->first[a] + index[a] * f->d[a] : 0;
    if (f->hexagonal) at[0] += (index[1] % 2 ? 0.25 : -0.25) * f->d[0];
    for (int a = 0; a < f->dim && f->moved > 0; a++) at[a] += f->moved * move[a];
    x[0] = f->axis[0] * at[0] - f->axis[1] * at[1];
    x[1] = f->axis[1] * at[0] + f->axis[0] * at[1];
    x[2] = at[2];
}

struct point_list { /* points, DIM_MAX coordinates each, and the cells of particles */
    size_t n, room;
    double *x, *cell;
    unsigned char *held;
};

static void points_add(struct point_list *l, const double x[DIM_MAX], double cell, int held) {
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

static void points_free(struct point_list *l) {
    free(l->x);
    free(l->cell);
    free(l->held);
}

/* Distance of a point from the body, m; beyond an edge or a corner that from it. */
static double distance_outside(const struct problem *p, const double *x, double depth) {
    double away[DIM_MAX] = {0};
    if (p->shape) return -depth;
    for (int a = 0; a < p->dim; a++) away[a] = fmax(0, fmax(p->lo[a] - x[a], x[a] - p->hi[a]));
    return hypot(hypot(away[0], away[1]), away[2]);
}

struct points {
    const struct problem *p;
    struct frame f;
    double reach; /* m */
    struct point_list inside, outside;
};

static void sort_point(void *context, const int index[DIM_MAX]) {
    struct points *all = context;
    const struct problem *p = all->p;
    const struct frame *f = &all->f;
    int wall;
    double at[DIM_MAX], x[DIM_MAX], lo[DIM_MAX], hi[DIM_MAX];
    locate(f, index, at, x);
    double depth = shape_nearest(p, x, &wall).depth, on = LAYOUT_ON_WALL * f->d[0];
    if (f->clear > 0 && depth < f->clear) return;
    if (!(depth >= -on)) {
        if (distance_outside(p, x, depth) < all->reach) points_add(&all->outside, x, 0, 0);
        return;
    }
    for (int a = 0; a < DIM_MAX; a++) lo[a] = at[a] - f->d[a] / 2, hi[a] = at[a] + f->d[a] / 2;
    points_add(&all->inside, x, shape_clipped(p, lo, hi), depth <= on && p->side[wall] == DIRICHLET);
}

static void fill_cloud(struct cloud *c, const struct point_list *inside, const struct point_list *outside,
                       size_t room) {
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
static void mirror_plane(const struct problem *p, const struct options *o, const struct lattice *l, struct cloud *c) {
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(c, i, x);
        if (shape_depth(p, x) > LAYOUT_ON_WALL * l->dx[0]) append_images(p, o, l, i, c);
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
            double sign = layout_image_factor(p, s, k, foot.depth);
            c->source[g] = (uint32_t)i;
            c->factor[g] = sign;
            c->offset[g] = problem_law(p, s)->is_flux ? 2 * foot.depth * value / k : (1 - sign) * value;
        }
    }
}

/* The particles of such a lattice.  The lattice points within `reach` (m) beyond the walls become dummies without
 * values.  Returns STATUS_INPUT if no point is inside. */
static int cut_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                     struct cloud *c, struct failure *why) {
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    struct points all = {p, frame_of(p, o, l, reach, random), reach, {0}, {0}};
    gsl_rng_free(random);
    in_blocks(all.f.moves.from, all.f.moves.to, all.f.blocks, sort_point, &all);
    moves_free(&all.f.moves);
    int mirrors = o->walls == WALLS_MIRROR;
    if (o->walls == WALLS_ONE_SIDED) all.outside.n = 0;
    *c = (struct cloud){.dim = p->dim, .n = all.inside.n, .total = all.inside.n + all.outside.n, .reach = reach};
    c->volume = all.f.d[0] * all.f.d[1] * all.f.d[2];
    fill_cloud(c, &all.inside, &all.outside, mirrors ? (p->dim == 3 ? 8 : 4) * c->total : c->total);
    if (mirrors && p->shape)
        mirror_round(p, c);
    else if (mirrors)
        mirror_plane(p, o, l, c);
    points_free(&all.inside);
    points_free(&all.outside);
    if (c->n > 0) return STATUS_OK;
    layout_cloud_free(c);
    return refuse(why, STATUS_INPUT, "--dx %g: no point of the lattice is in the body; use a smaller --dx", o->dx);
}

/* ---- The cloud ---- */

static void copy_positions(const struct field *from, struct cloud *c) {
    for (size_t i = 0; i < c->n; i++) {
        double x[DIM_MAX];
        layout_cloud_put(c, i, field_place(from, i, x));
    }
}

int layout_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                 struct cloud *c, struct failure *why) {
    if (layout_is_cut(p, o)) return cut_cloud(p, o, l, reach, c, why);
    for (int a = 0; a < p->dim; a++)
        if (reach > p->hi[a] - p->lo[a])
            return refuse(why, STATUS_INPUT,
                          "--dx %g: the ghosts of a wall reach %g m, beyond the opposite wall; use a "
                          "smaller --dx or --h",
                          o->dx, reach);
    size_t n = 1, most = 1; /* particles; with ghosts */
    for (int a = 0; a < p->dim; a++) {
        n *= (size_t)l->n[a];
        most *= (size_t)l->n[a] + (size_t)(2 * ceil(reach / l->dx[a]) + 3);
    }
    *c = (struct cloud){.dim = p->dim, .n = n, .total = n, .reach = reach, .volume = layout_volume(l)};
    layout_cloud_alloc(c, most);
    place_particles(o, l, reach, c);
    if (o->layout == LAYOUT_RELAXED && o->placed)
        copy_positions(o->placed, c);
    else if (o->layout == LAYOUT_RELAXED && relax_cloud(p, o, p->dim == 2 ? sqrt(c->volume) : c->volume, c, why)) {
        layout_cloud_free(c);
        return why->status;
    }
    for (size_t i = 0; i < n; i++) append_images(p, o, l, i, c);
    return STATUS_OK;
}

void layout_cloud_alloc(struct cloud *c, size_t points) {
    c->x = xcalloc(points, sizeof *c->x);
    c->y = xcalloc(points, sizeof *c->y);
    if (c->dim == 3) c->z = xcalloc(points, sizeof *c->z);
    c->source = xcalloc(points, sizeof *c->source);
    c->factor = xcalloc(points, sizeof *c->factor);
    c->offset = xcalloc(points, sizeof *c->offset);
}

void layout_cloud_free(struct cloud *c) {
    free(c->x);
    free(c->y);
    free(c->z);
    free(c->source);
    free(c->offset);
    free(c->factor);
    free(c->cell);
    free(c->held);
    free(c->begin);
    free(c->from);
    free(c->share);
    free(c->away);
    *c = (struct cloud){0};
}
