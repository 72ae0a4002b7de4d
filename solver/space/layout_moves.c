/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Jitter that belongs to the seed alone: points are drawn in blocks of two by two, whatever the reach of the
 * operator, first those of the core and then those around it, so that all operators get the same particles. */
#include "solver/space/layout.h"

#include <stdlib.h>

static double *move_of(const struct layout_moves *m, int i, int j) {
    return m->move + 2 * ((size_t)(j - m->from[1]) * (size_t)(m->to[0] - m->from[0]) + (size_t)(i - m->from[0]));
}

static int is_in(const int from[2], const int to[2], int i, int j) {
    return i >= from[0] && i < to[0] && j >= from[1] && j < to[1];
}

static void draw(struct layout_moves *m, int dim, int i, int j, gsl_rng *random) {
    double unused[2], *move = is_in(m->from, m->to, i, j) ? move_of(m, i, j) : unused;
    for (int a = 0; a < dim; a++) move[a] = gsl_rng_uniform(random) - 0.5;
}

void layout_moves_draw(struct layout_moves *m, int dim, const int core_from[2], const int core_to[2],
                       gsl_rng *random) {
    enum { BLOCK = 2 };
    const int high = dim == 2 ? BLOCK : 1;
    m->move = xcalloc(2 * (size_t)(m->to[0] - m->from[0]) * (size_t)(m->to[1] - m->from[1]), sizeof *m->move);
    for (int j0 = core_from[1]; j0 < core_to[1]; j0 += high)
        for (int i0 = core_from[0]; i0 < core_to[0]; i0 += BLOCK)
            for (int j = j0; j < j0 + high && j < core_to[1]; j++)
                for (int i = i0; i < i0 + BLOCK && i < core_to[0]; i++) draw(m, dim, i, j, random);
    for (int j = m->from[1]; j < m->to[1]; j++)
        for (int i = m->from[0]; i < m->to[0]; i++)
            if (!is_in(core_from, core_to, i, j)) draw(m, dim, i, j, random);
}

double layout_moves_at(const struct layout_moves *m, int i, int j, int axis) {
    return move_of(m, i, j)[axis];
}

void layout_moves_free(struct layout_moves *m) {
    free(m->move);
    m->move = NULL;
}
