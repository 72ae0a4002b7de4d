/* The list of methods, the words of their options, and the three things that every method needs: fail, xcalloc and
 * the field that it returns. */
#include "solver/method.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define METHOD(name) extern const struct method method_##name;
#include "solver/methods.def"
#undef METHOD

#define METHOD(name) &method_##name,
const struct method *const methods[] = {
#include "solver/methods.def"
    NULL};
#undef METHOD

const char *const kernel_words[] = {"cubic", "quartic", "wendland", NULL};
const char *const stepper_words[] = {"auto", "euler", "rk2", "rkl2", "exact", "matched", NULL};
const char *const layout_words[] = {"lattice", "node", "jitter", NULL};
const char *const sampling_words[] = {"point", "cell", "spline", NULL};
const char *const walls_words[] = {"mirror", "fixed", NULL};
const char *const mean_words[] = {"harmonic", "arithmetic", "series", NULL};
const char *const domain_words[] = {"folded", "whole", NULL};
const char *const volume_words[] = {"moment", "raw", "tuned", NULL};

int fail(struct failure *f, int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->text, sizeof f->text, format, arguments);
    va_end(arguments);
    f->status = status;
    return status;
}

void *xcalloc(size_t count, size_t size) {
    void *block = calloc(count ? count : 1, size);
    if (!block) {
        fprintf(stderr, "heatladder: out of memory (%zu x %zu bytes)\n", count, size);
        exit(STATUS_NUMERICAL);
    }
    return block;
}

void field_alloc(struct field *f, int dim, size_t n) {
    *f = (struct field){.dim = dim, .n = n};
    f->x = xcalloc(n, sizeof *f->x);
    f->y = dim == 2 ? xcalloc(n, sizeof *f->y) : NULL;
    f->T = xcalloc(n, sizeof *f->T);
}

void field_free(struct field *f) {
    free(f->x);
    free(f->y);
    free(f->T);
    free(f->weight);
    *f = (struct field){0};
}
