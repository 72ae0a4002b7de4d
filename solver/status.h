/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_STATUS_H
#define HEATLADDER_SOLVER_STATUS_H

/* How a call ends: its status, the text of a failure, and memory that does not run out quietly. */

#include <stddef.h>

enum {
    STATUS_OK = 0,
    STATUS_GATE = 1,           /* measured, and outside of what was asked for */
    STATUS_INPUT = 2,          /* bad usage or input */
    STATUS_NUMERICAL = 3,      /* a singular matrix, a program that failed */
    STATUS_INCONCLUSIVE = 4,   /* measured, but not enough for a verdict */
    STATUS_NOT_APPLICABLE = 5, /* good input, for which this method has no answer */
    STATUS_UNSTABLE = 6,       /* T grew without bound */
    STATUS_SKIPPED = 77        /* another program says that the case is not for it (as GNU Automake's tests do) */
};

/* The exit status of the program: 0 to 4, or 77; not applicable counts as input, unstable as numerical. */
int status_exit(int status);

/* 1 where nothing was tried: STATUS_INPUT and STATUS_NOT_APPLICABLE. */
int status_refused(int status);

struct failure {
    int status;     /* one of the above */
    char text[480]; /* one line, without a newline: what, its value, what would be valid; where and when */
};

/* Fills *f (printf-like) and returns status, so that a function can end with `return refuse(f, STATUS_INPUT, ...)`.
 */
int refuse(struct failure *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* calloc that ends the program where memory is out; count = 0 gives a block that can be freed. */
void *xcalloc(size_t count, size_t size);

/* xcalloc with the first `used` elements of `old`, which is freed. */
void *xgrow(void *old, size_t used, size_t count, size_t size);

/* The block; without one (NULL) the program ends as in xcalloc. */
void *xcheck(void *block, size_t count, size_t size);

#endif
