/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order of lattice points in blocks, and their jitter.
 *
 * Jitter belongs to the seed alone: points are drawn in blocks of two along each axis, whatever the reach of the
 * operator, first those of the core and then those around it, so that all operators get the same particles. */
#include "solver/space/layout.h"

#include <stdlib.h>
#include <string.h>

/* Advances an index by `step`, x fastest; 0 at the end. */
static int advance(int at[DIM_MAX], const int from[DIM_MAX], const int to[DIM_MAX], const int step[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) {
        at[a] += step[a];
        if (at[a] < to[a]) return 1;
        at[a] = from[a];
    }
    return 0;
}

void layout_in_blocks(const int from[DIM_MAX], const int to[DIM_MAX], const int side[DIM_MAX],
                      void (*visit)(void *context, const int at[DIM_MAX]), void *context) {
    static const int one[DIM_MAX] = {1, 1, 1};
    int block[DIM_MAX], end[DIM_MAX], at[DIM_MAX];
    memcpy(block, from, sizeof block);
    do {
        for (int a = 0; a < DIM_MAX; a++) end[a] = block[a] + side[a] < to[a] ? block[a] + side[a] : to[a];
        memcpy(at, block, sizeof at);
        do visit(context, at);
        while (advance(at, block, end, one));
    } while (advance(block, from, to, side));
}

static size_t index_of(const struct layout_moves *m, const int at[DIM_MAX]) {
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
    struct layout_moves *m;
    gsl_rng *random;
    const int *core_from, *core_to; /* NULL within the core */
};

static void draw(void *context, const int at[DIM_MAX]) {
    const struct draw *d = context;
    double unused[DIM_MAX], *move = is_in(d->m->from, d->m->to, at) ? d->m->move + index_of(d->m, at) : unused;
    if (d->core_from && is_in(d->core_from, d->core_to, at)) return;
    for (int a = 0; a < d->m->dim; a++) move[a] = gsl_rng_uniform(d->random) - 0.5;
}

void layout_moves_draw(struct layout_moves *m, const int core_from[DIM_MAX], const int core_to[DIM_MAX],
                       gsl_rng *random) {
    static const int block[DIM_MAX] = {2, 2, 2};
    size_t points = 1;
    int all[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) all[a] = m->to[a] - m->from[a], points *= (size_t)all[a];
    m->move = xcalloc(points * (size_t)m->dim, sizeof *m->move);
    layout_in_blocks(core_from, core_to, block, draw, &(struct draw){m, random, NULL, NULL});
    layout_in_blocks(m->from, m->to, all, draw, &(struct draw){m, random, core_from, core_to});
}

const double *layout_moves_at(const struct layout_moves *m, const int at[DIM_MAX]) {
    return m->move + index_of(m, at);
}

void layout_moves_free(struct layout_moves *m) {
    free(m->move);
    m->move = NULL;
}
