/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory exhaustion ends the program.  The library returns a status instead (references/library/guard.c). */
#include "solver/status.h"

#include <stdio.h>
#include <stdlib.h>

void *xcheck(void *block, size_t count, size_t size) {
    if (block) return block;
    fprintf(stderr, "heatladder: out of memory (%zu x %zu bytes)\n", count, size);
    _Exit(STATUS_NUMERICAL); /* callable from any thread */
}
