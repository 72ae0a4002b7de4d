/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory of the program: exhaustion ends it.  The library returns a status instead, and lists its blocks
 * (references/library/guard.c). */
#undef calloc
#undef realloc
#undef free
#include "solver/status.h"

#include <stdio.h>
#include <stdlib.h>

void *xcheck(void *block, size_t count, size_t size) {
    if (block) return block;
    fprintf(stderr, "heatladder: out of memory (%zu x %zu bytes)\n", count, size);
    _Exit(STATUS_NUMERICAL); /* callable from any thread */
}

void *guard_calloc(size_t count, size_t size) {
    return calloc(count, size);
}

void *guard_realloc(void *block, size_t size) {
    return realloc(block, size);
}

void guard_free(void *block) {
    free(block);
}
