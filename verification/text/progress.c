/* Progress on standard error, where a person is looking. */
#include "verification/text/progress.h"

#include <omp.h>
#include <stdio.h>
#include <unistd.h>

struct progress progress_start(const char *what, int total) {
    return (struct progress){.what = what, .total = total, .shown = !omp_in_parallel() && isatty(STDERR_FILENO)};
}

void progress_tick(struct progress *p) {
#pragma omp atomic
    ++p->done;
    if (!p->shown) return;
#pragma omp critical(progress_line)
    {
        int done;
#pragma omp atomic read
        done = p->done;
        fprintf(stderr, "\r%d of %d %s ", done, p->total, p->what);
        fflush(stderr);
    }
}

void progress_end(struct progress *p) {
    if (p->shown) fprintf(stderr, "\r%40s\r", "");
}
