/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_STATUS_H
#define HEATLADDER_SOLVER_STATUS_H

/* Statuses, failure texts, and checked allocation. */

#include <stddef.h>

enum {
    STATUS_OK = 0,
    STATUS_GATE = 1,           /* measured, but out of bounds */
    STATUS_INPUT = 2,          /* bad usage or input */
    STATUS_NUMERICAL = 3,      /* a numerical failure, such as a singular matrix or a failed program */
    STATUS_INCONCLUSIVE = 4,   /* measured, but insufficient for a verdict */
    STATUS_NOT_APPLICABLE = 5, /* valid input that this method cannot treat */
    STATUS_UNSTABLE = 6,       /* T grows without bound */
    STATUS_SKIPPED = 77        /* an external program declines the case (as in GNU Automake's tests) */
};

/* Exit status of the program: 0 to 4, or 77.  Not applicable maps to input, unstable to numerical. */
int status_exit(int status);

/* 1 if nothing was run: STATUS_INPUT and STATUS_NOT_APPLICABLE. */
int status_refused(int status);

struct failure {
    int status;     /* one of the above */
    char text[480]; /* one line without a newline: option, value and valid range; place and time */
    int exchanged;  /* 1 + the pair of axes (0: x and y, 1: y and z, 2: x and z) with which exchanged all points of a
                     * refused answer are inside; 0: none */
};

/* Fills *f (printf-like) and returns status, for `return refuse(f, STATUS_INPUT, ...)`. */
int refuse(struct failure *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* calloc that ends the program if memory is exhausted; count = 0 returns a block that can be freed. */
void *xcalloc(size_t count, size_t size);

/* xcalloc that copies the first `used` elements of `old` and frees it. */
void *xgrow(void *old, size_t used, size_t count, size_t size);

/* Returns the block; ends the program as xcalloc does if it is NULL. */
void *xcheck(void *block, size_t count, size_t size);

/* calloc, realloc and free of solver/ and references/, renamed by the compiler.  In the program they are those of the
 * C library; the library lists its blocks (references/library/guard.c). */
void *guard_calloc(size_t count, size_t size);
void *guard_realloc(void *block, size_t size);
void guard_free(void *block);

#endif
