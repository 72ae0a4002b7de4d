#ifndef HEATLADDER_SOLVER_STATUS_H
#define HEATLADDER_SOLVER_STATUS_H

/* How a call ends: its status, the text of a failure, and memory that does not run out quietly. */

#include <stddef.h>

/* also the exit statuses */
enum { STATUS_OK = 0, STATUS_GATE = 1, STATUS_INPUT = 2, STATUS_NUMERICAL = 3, STATUS_INCONCLUSIVE = 4 };

struct failure {
    int status;     /* STATUS_OK, STATUS_INPUT or STATUS_NUMERICAL */
    char text[480]; /* one line, without a newline: what, its value, what would be valid; where and when */
};

/* Fills *f (printf-like) and returns status, so that a function can end with `return refuse(f, STATUS_INPUT, ...)`.
 */
int refuse(struct failure *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* calloc that ends the program where memory is out; count = 0 gives a block that can be freed. */
void *xcalloc(size_t count, size_t size);

#endif
