/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_BLOCKS_H
#define HEATLADDER_SOLVER_SPACE_BLOCKS_H

#include "solver/status.h"

#include <stdint.h>

/* Work on points in a fixed number of blocks, each done by one thread, so that results do not depend on the number of
 * threads. */

enum { BLOCKS = 64 };

/* Calls work(context, b, begin, end, why) for each block b of n points on the given number of threads.  Returns the
 * failure of the first block that fails. */
int blocks_run(size_t n, int threads,
               int (*work)(void *context, int b, size_t begin, size_t end, struct failure *why), void *context,
               struct failure *why);

struct blocks_list { /* entries of the points of a block, one point after the other */
    size_t n, room;
    uint32_t *point;
    double *value;
};

void blocks_list_grow(struct blocks_list *l); /* doubles the capacity */

/* Appends an entry. */
static inline void blocks_list_add(struct blocks_list *l, uint32_t point, double value) {
    if (l->n == l->room) blocks_list_grow(l);
    l->point[l->n] = point;
    l->value[l->n++] = value;
}

/* Joins the entries of all blocks, in order, into arrays owned by the caller; returns their number.  Each block is
 * freed once copied, to limit peak memory.  On entry
 * begin[i + 1] is the number of entries of point i < n, on return the end of its entries. */
size_t blocks_list_join(struct blocks_list part[BLOCKS], size_t n, size_t *begin, uint32_t **point, double **value);
void blocks_list_free(struct blocks_list part[BLOCKS]);

#endif
