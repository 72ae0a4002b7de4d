/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Progress on standard error, where a person is looking. */
#include "verification/text/progress.h"

#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

enum { WIDTH = 79 }; /* a narrow terminal; longer text would wrap and stay */

struct progress progress_start(const char *what, int total) {
    return (struct progress){.what = what, .total = total, .shown = !omp_in_parallel() && isatty(STDERR_FILENO)};
}

/* Writes over the line. */
__attribute__((format(printf, 1, 0))) static void show(const char *format, va_list arguments) {
    char text[WIDTH + 1];
    vsnprintf(text, sizeof text, format, arguments);
#pragma omp critical(progress_line)
    {
        fprintf(stderr, "\r%-*s\r", WIDTH, text);
        fflush(stderr);
    }
}

void progress_now(struct progress *p, const char *format, ...) {
    va_list arguments;
    if (!p->shown) return;
    va_start(arguments, format);
    show(format, arguments);
    va_end(arguments);
}

void progress_tick(struct progress *p) {
    int done;
#pragma omp atomic capture
    done = ++p->done;
    progress_now(p, "%d of %d %s", done, p->total, p->what);
}

void progress_print(struct progress *p, const char *format, ...) {
    va_list arguments;
    progress_end(p);
    va_start(arguments, format);
#pragma omp critical(progress_line)
    {
        vfprintf(stderr, format, arguments);
        fputc('\n', stderr);
    }
    va_end(arguments);
}

void progress_end(struct progress *p) {
    progress_now(p, "%s", "");
}
