/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles off the lattice, and their ghosts: mirror images beyond the walls, which keep the boundary conditions
 * exact.
 *
 * Jitter: each particle of the cell-centred lattice is displaced uniformly within +-A dx along each axis.  Relaxed:
 * these particles settle by relax.c.  Hexagonal: rows sqrt(3)/2 dx apart, stretched to fill the height and displaced
 * by dx/4 to alternating sides.  A hexagonal lattice has its mirror lines through particles.  The walls mirror
 * between rows, so one row of pairs along each wall is dx/2 and 3/2 dx apart.  On a rod the hexagonal layout is the
 * lattice. */
#include "solver/space/layout.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct placing {
    const struct options *o;
    const struct lattice *l;
    struct layout_moves moves;
    double amplitude; /* dx */
    struct cloud *c;
    size_t k;
};

static void place(void *context, const int at[DIM_MAX]) {
    struct placing *t = context;
    const struct lattice *l = t->l;
    const double *move = layout_moves_at(&t->moves, at);
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
    layout_moves_draw(&t.moves, t.moves.from, t.moves.to, random);
    gsl_rng_free(random);
    layout_in_blocks(t.moves.from, t.moves.to, block, place, &t);
    layout_moves_free(&t.moves);
}

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
        if (l->sign[side[a]] == LAYOUT_ROBIN)
            factor *= layout_robin_factor(p, side[a], p->material[layout_material(p, ghost[0])].k[a],
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

void layout_mirror(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                   struct cloud *c) {
    double source[DIM_MAX];
    int images = 1;
    layout_cloud_place(c, i, source);
    for (int a = 0; a < p->dim; a++) images *= 3;
    for (int image = 1; image < images; image++) { /* a digit an axis: not beyond it, beyond its low or high side */
        int side[DIM_MAX] = {-1, -1, -1}, near = 1;
        for (int a = p->dim - 1, digits = image; a >= 0; a--, digits /= 3)
            if (digits % 3) side[a] = 2 * a + digits % 3 - 1;
        for (int a = 0; a < p->dim && near; a++)
            near = side[a] < 0 || fabs(source[a] - (side[a] % 2 ? p->hi[a] : p->lo[a])) < c->reach;
        if (near) append_image(p, o, l, i, source, side, c);
    }
}

static void take_places(const struct field *from, struct cloud *c) {
    for (size_t i = 0; i < c->n; i++) {
        double x[DIM_MAX];
        layout_cloud_put(c, i, field_place(from, i, x));
    }
}

int layout_cloud(const struct problem *p, const struct options *o, const struct lattice *l, double reach,
                 struct cloud *c, struct failure *why) {
    if (layout_is_cut(p, o)) return layout_cut(p, o, l, reach, c, why);
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
        take_places(o->placed, c);
    else if (o->layout == LAYOUT_RELAXED && relax_cloud(p, o, p->dim == 2 ? sqrt(c->volume) : c->volume, c, why)) {
        layout_cloud_free(c);
        return why->status;
    }
    for (size_t i = 0; i < n; i++) layout_mirror(p, o, l, i, c);
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
