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

/* Orders particles by square cells of side `reach`, so that neighbours in space are neighbours in memory. */
static void place_particles(const struct options *o, const struct lattice *l, double reach, struct cloud *c) {
    int block[2] = {(int)fmax(1, floor(reach / l->dx[0])), l->dim == 2 ? (int)fmax(1, floor(reach / l->dx[1])) : 1};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, o->seed);
    double amplitude = o->layout == LAYOUT_JITTER || o->layout == LAYOUT_RELAXED ? 2 * o->jitter : 0;
    struct layout_moves moves = {{0, 0}, {l->n[0], l->n[1]}, NULL};
    layout_moves_draw(&moves, l->dim, moves.from, moves.to, random);
    gsl_rng_free(random);
    size_t k = 0;
    for (int j0 = 0; j0 < l->n[1]; j0 += block[1])
        for (int i0 = 0; i0 < l->n[0]; i0 += block[0])
            for (int j = j0; j < j0 + block[1] && j < l->n[1]; j++)
                for (int i = i0; i < i0 + block[0] && i < l->n[0]; i++, k++) {
                    double x[DIM_MAX];
                    layout_position(l, i, j, 0, x);
                    if (o->layout == LAYOUT_HEXAGONAL && l->dim == 2) x[0] += (j % 2 ? 0.25 : -0.25) * l->dx[0];
                    c->x[k] = x[0] + amplitude * l->dx[0] * layout_moves_at(&moves, i, j, 0);
                    c->y[k] = l->dim == 2 ? x[1] + amplitude * l->dx[1] * layout_moves_at(&moves, i, j, 1) : 0;
                    c->source[k] = (uint32_t)k;
                    c->factor[k] = 1;
                }
    layout_moves_free(&moves);
}

/* Appends the images of particle i beyond the walls, up to three (two sides and the corner). */
void layout_mirror(const struct problem *p, const struct options *o, const struct lattice *l, size_t i,
                   struct cloud *c) {
    double source[2] = {c->x[i], c->y[i]};
    for (int sx = -1; sx < 2; sx++)
        for (int sy = p->dim == 2 ? -1 : 1; sy < 2; sy++) { /* -1: not beyond this axis; else low or high side */
            int side[2] = {sx, p->dim == 2 && sy >= 0 ? 2 + sy : -1}, near = 1;
            double factor = 1;
            double ghost[2] = {source[0], source[1]};
            if (side[0] < 0 && side[1] < 0) continue;
            for (int a = 0; a < p->dim; a++) {
                if (side[a] < 0) continue;
                double wall = side[a] % 2 ? p->hi[a] : p->lo[a], extent = p->hi[a] - p->lo[a];
                int periodic = p->side[side[a]] == PERIODIC;
                near = near && fabs(source[a] - wall) < c->reach;
                ghost[a] = periodic ? source[a] + (side[a] % 2 ? -extent : extent) : 2 * wall - source[a];
                if (l->sign[side[a]] == LAYOUT_ROBIN)
                    factor *= layout_robin_factor(p, side[a], p->material[layout_material(p, ghost[0])].k[a],
                                                  fabs(source[a] - wall));
                else
                    factor *= l->sign[side[a]];
            }
            if (!near) continue;
            size_t k = c->total++;
            c->x[k] = ghost[0];
            c->y[k] = ghost[1];
            c->source[k] = (uint32_t)i;
            c->factor[k] = factor;
            c->offset[k] = layout_ghost_offset(p, o->walls, NULL, side, ghost, source);
        }
}

static void take_places(const struct field *from, struct cloud *c) {
    memcpy(c->x, from->x, c->n * sizeof *c->x);
    if (from->y) memcpy(c->y, from->y, c->n * sizeof *c->y);
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
    size_t n = (size_t)l->n[0] * (size_t)l->n[1], width[2];
    for (int a = 0; a < 2; a++) width[a] = a < p->dim ? (size_t)(2 * ceil(reach / l->dx[a]) + 3) : 0;
    size_t most = n + width[0] * (size_t)l->n[1] + width[1] * (size_t)l->n[0] + width[0] * width[1];
    *c = (struct cloud){.dim = p->dim, .n = n, .total = n, .reach = reach, .volume = l->dx[0] * l->dx[1]};
    c->x = xcalloc(most, sizeof *c->x);
    c->y = xcalloc(most, sizeof *c->y);
    c->source = xcalloc(most, sizeof *c->source);
    c->factor = xcalloc(most, sizeof *c->factor);
    c->offset = xcalloc(most, sizeof *c->offset);
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

void layout_cloud_free(struct cloud *c) {
    free(c->x);
    free(c->y);
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
