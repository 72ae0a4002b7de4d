/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Work on points in blocks, and the lists that the blocks fill: rows of a matrix, faces of cells. */
#include "solver/space/blocks.h"

#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

int blocks_run(size_t n, int threads,
               int (*work)(void *context, int b, size_t begin, size_t end, struct failure *why), void *context,
               struct failure *why) {
    int first = BLOCKS;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads > 1 ? threads : 1)
    for (int b = 0; b < BLOCKS; b++) {
        struct failure own;
        size_t begin = n * (size_t)b / BLOCKS, end = n * (size_t)(b + 1) / BLOCKS;
        if (work(context, b, begin, end, &own)) {
#pragma omp critical(blocks_failure)
            if (b < first) first = b, *why = own;
        }
    }
    return first < BLOCKS ? why->status : STATUS_OK;
}

void blocks_list_grow(struct blocks_list *l) {
    l->room = l->room ? 2 * l->room : 64;
    l->point = xcheck(realloc(l->point, l->room * sizeof *l->point), l->room, sizeof *l->point);
    l->value = xcheck(realloc(l->value, l->room * sizeof *l->value), l->room, sizeof *l->value);
}

static void list_free(struct blocks_list *l) {
    free(l->point), free(l->value);
    l->point = NULL, l->value = NULL;
}

/* Gives the pages of a large list back at once: glibc keeps freed pages below the end of the heap. */
static void list_return(struct blocks_list *l) {
    size_t bytes = l->room * (sizeof *l->point + sizeof *l->value);
    list_free(l);
#ifdef __GLIBC__
    const size_t large = 1 << 20;
    if (bytes >= large) malloc_trim(0);
#else
    (void)bytes;
#endif
}

size_t blocks_list_join(struct blocks_list part[BLOCKS], size_t n, size_t *begin, uint32_t **point, double **value) {
    size_t total = 0;
    for (size_t i = 0; i < n; i++) begin[i + 1] += begin[i];
    for (int b = 0; b < BLOCKS; b++) total += part[b].n;
    *point = xcalloc(total, sizeof **point);
    *value = xcalloc(total, sizeof **value);
    size_t at = total;
    for (int b = BLOCKS - 1; b >= 0; b--) {
        if (part[b].n == 0) continue;
        at -= part[b].n;
        memcpy(*point + at, part[b].point, part[b].n * sizeof **point);
        memcpy(*value + at, part[b].value, part[b].n * sizeof **value);
        list_return(&part[b]);
    }
    return total;
}

void blocks_list_free(struct blocks_list part[BLOCKS]) {
    for (int b = 0; b < BLOCKS; b++) list_free(&part[b]);
}
