/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Progress on standard error, where a person is looking. */
#include "verification/text/progress.h"

#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

enum { WIDTH = 79 }; /* of a terminal at least: what is longer cannot be taken away again */

struct progress progress_start(const char *what, int total) {
    return (struct progress){.what = what, .total = total, .shown = !omp_in_parallel() && isatty(STDERR_FILENO)};
}

static void take_away(const struct progress *p) {
    if (p->shown) fprintf(stderr, "\r%*s\r", WIDTH, "");
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

void progress_now(struct progress *p, const char *format, ...) {
    char text[WIDTH + 1];
    va_list arguments;
    if (!p->shown) return;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
#pragma omp critical(progress_line)
    {
        fprintf(stderr, "\r%-*s\r", WIDTH, text);
        fflush(stderr);
    }
}

void progress_print(struct progress *p, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
#pragma omp critical(progress_line)
    {
        take_away(p);
        vfprintf(stderr, format, arguments);
        fputc('\n', stderr);
    }
    va_end(arguments);
}

void progress_end(struct progress *p) {
    take_away(p);
}
