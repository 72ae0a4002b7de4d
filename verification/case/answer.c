/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the answer of `reference` for a set of points as CSV. */
#include "verification/case/answer.h"

#include "references/snapshot.h"
#include "solver/status.h"
#include "verification/text/number.h"

#include <stdlib.h>
#include <string.h>

void answer_times(double from, double to, int count, double *time) {
    for (int k = 0; k < count; k++) time[k] = from + (to - from) * k / (count - 1);
}

int answer_check(const struct answer *a, struct failure *why) {
    int has_cell = a->points.cell || a->cell > 0;
    return columns_check(&a->columns, &a->image->problem, a->times, a->time, has_cell, why);
}

enum { BLOCK = 4096 }; /* points per evaluation, since lattice points share work */

static char *put(char *at, const char *text, size_t length) {
    memcpy(at, text, length);
    return at + length;
}

/* Writes the line of point i; returns its end. */
static char *put_row(const struct answer *a, double time, size_t i, const double *value, int n, char *at) {
    for (int d = 0; d < a->points.dim; d++) {
        const struct rows_cell *typed = &a->points.typed[i][d];
        if (d) *at++ = ',';
        at = put(at, typed->text, typed->length);
        if (!typed->length) at += snprintf(at, NUMBER_PRINTED, "%.17g", a->points.x[i][d]);
    }
    for (int k = a->times > 1 ? -1 : 0; k < n; k++) {
        *at++ = ',';
        at += snprintf(at, NUMBER_PRINTED, "%.17g", k < 0 ? time : value[k]);
    }
    *at++ = '\n';
    return at;
}

/* Maximum number of characters in the lines of n points. */
static size_t room(const struct answer *a, size_t first, size_t n) {
    int numbers = a->points.dim + 1 + a->columns.values;
    size_t letters = n * (size_t)numbers * (NUMBER_PRINTED + 1);
    for (size_t i = first; i < first + n; i++)
        for (int d = 0; d < a->points.dim; d++) letters += a->points.typed[i][d].length;
    return letters;
}

struct text {
    char *start; /* owned */
    size_t length;
};

static struct text write_block(const struct answer *a, const struct snapshot *now, size_t block) {
    size_t first = block * BLOCK, left = a->points.n - first, n = left < BLOCK ? left : BLOCK;
    const int count = a->columns.values;
    double *value = xcalloc(n * (size_t)count, sizeof *value);
    double(*same)[DIM_MAX] = a->points.cell ? NULL : xcalloc(n, sizeof *same);
    char *text = xcalloc(room(a, first, n), 1), *at = text;
    for (size_t i = 0; i < n && same; i++)
        for (int d = 0; d < DIM_MAX; d++) same[i][d] = a->cell;
    columns_at_points(&a->columns, a->image, now, n, a->points.x + first, same ? same : a->points.cell + first,
                      value);
    for (size_t i = 0; i < n; i++) at = put_row(a, now->time, first + i, value + i * (size_t)count, count, at);
    free(value);
    free(same);
    return (struct text){text, (size_t)(at - text)};
}

/* Blocks are independent and written in order, so the output does not depend on the number of threads. */
static void write_points(const struct answer *a, double time, FILE *out) {
    enum { KEPT = 16 }; /* blocks */
    struct snapshot now = snapshot_take(a->scene, a->image->of, time);
    size_t blocks = (a->points.n + BLOCK - 1) / BLOCK;
    struct text text[KEPT];
    for (size_t first = 0; first < blocks && !ferror(out); first += KEPT) {
        int n = (int)(blocks - first < KEPT ? blocks - first : KEPT);
#pragma omp parallel for schedule(dynamic, 1) if (n > 1)
        for (int k = 0; k < n; k++) text[k] = write_block(a, &now, first + (size_t)k);
        for (int k = 0; k < n; k++) {
            fwrite(text[k].start, 1, text[k].length, out);
            free(text[k].start);
        }
    }
    snapshot_free(&now);
}

void answer_write(const struct answer *a, FILE *out) {
    static const char *const coordinates[] = {"", "x", "x,y", "x,y,z"};
    char header[COLUMNS_HEADER];
    columns_header(&a->columns, header);
    fprintf(out, "%s%s,%s\n", coordinates[a->points.dim], a->times > 1 ? ",time" : "", header);
    if (a->times == 0) write_points(a, 0, out);
    for (int k = 0; k < a->times && !ferror(out); k++) write_points(a, a->time[k], out);
}
