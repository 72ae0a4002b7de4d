/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory, clock and distances of fields. */
#include "solver/field.h"

#include "solver/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

double field_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void field_alloc(struct field *f, int dim, size_t n) {
    *f = (struct field){.dim = dim, .n = n};
    for (int a = 0; a < dim; a++) f->x[a] = xcalloc(n, sizeof **f->x);
    f->T = xcalloc(n, sizeof *f->T);
}

void field_alloc_lattice(struct field *f, int dim, const int shape[DIM_MAX], double *T) {
    *f = (struct field){.dim = dim, .n = 1};
    for (int a = 0; a < DIM_MAX; a++) {
        f->shape[a] = a < dim ? shape[a] : 1;
        f->n *= (size_t)f->shape[a];
        if (a < dim) f->x[a] = xcalloc((size_t)shape[a], sizeof **f->x);
    }
    f->T = T ? T : xcalloc(f->n, sizeof *f->T);
}

static double *copied(const double *from, size_t n) {
    return from ? memcpy(xcalloc(n, sizeof *from), from, n * sizeof *from) : NULL;
}

struct field field_copy(const struct field *f) {
    struct field out = *f;
    for (int a = 0; a < f->dim; a++) out.x[a] = copied(f->x[a], f->shape[0] ? (size_t)f->shape[a] : f->n);
    out.T = copied(f->T, f->n);
    out.weight = copied(f->weight, f->n);
    return out;
}

void field_free(struct field *f) {
    for (int a = 0; a < DIM_MAX; a++) free(f->x[a]);
    free(f->T);
    free(f->weight);
    *f = (struct field){0};
}

size_t field_bytes(const struct field *f) {
    size_t values = f->n * (f->weight ? 2 : 1);
    for (int a = 0; a < f->dim; a++) values += f->shape[0] ? (size_t)f->shape[a] : f->n;
    return values * sizeof *f->T;
}

double field_distance(const struct field *f, const double *T, const double *size) {
    double difference = 0, whole = 0;
    for (size_t i = 0; i < f->n; i++) {
        double w = f->weight ? f->weight[i] : 1;
        if (size[i] == INFINITY) continue;
        difference += w * fabs(f->T[i] - T[i]);
        whole += w * fabs(size[i]);
    }
    return difference / whole;
}

double field_largest(const struct field *f) {
    double most = 0;
    for (size_t i = 0; i < f->n; i++) most = fmax(most, fabs(f->T[i]));
    return most;
}

double field_farthest(const struct field *f, const double *T) {
    double most = 0;
    for (size_t i = 0; i < f->n; i++) {
        double difference = fabs(f->T[i] - T[i]);
        if (difference > most || isnan(difference)) most = difference; /* a NaN propagates */
    }
    return most;
}
