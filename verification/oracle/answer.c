/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answer of `reference` for a set of points, as CSV. */
#include "verification/oracle/answer.h"

#include "references/snapshot.h"
#include "solver/status.h"
#include "verification/text/number.h"

#include <stdlib.h>
#include <string.h>

void answer_times(double from, double to, int count, double *time) {
    for (int k = 0; k < count; k++) time[k] = from + (to - from) * k / (count - 1);
}

int answer_check(const struct answer *a, struct failure *why) {
    for (int i = 0; i < a->columns.count; i++) {
        const struct columns_kind *kind = a->columns.kind[i];
        if (kind->needs_time && a->times == 0)
            return refuse(why, STATUS_INPUT, "--what %s needs --time T[,T...]: when, s", kind->name);
        if (strcmp(kind->name, "source") == 0 && a->image->problem.source_change && a->times == 0)
            return refuse(why, STATUS_INPUT, "--what source changes in time here and needs --time T[,T...]: when, s");
        if (kind->needs_cell && !a->points.cell && !(a->cell > 0))
            return refuse(why, STATUS_INPUT,
                          "--what %s needs the cell around each point: columns dx and dy of the points, or --dx DX",
                          kind->name);
        for (int k = 0; k < a->times && strncmp(kind->name, "flux", 4) == 0; k++)
            if (a->time[k] == 0)
                return refuse(why, STATUS_INPUT, "--time 0: --what %s needs a time > 0, when the gradient is finite",
                              kind->name);
    }
    return STATUS_OK;
}

enum { BLOCK = 4096 }; /* points whose exact solution is asked for at once: those of a lattice share */

static void exact_of(const struct answer *a, const struct snapshot *now, size_t first, size_t n,
                     struct exact e[BLOCK]) {
    static const size_t room = BLOCK;
    double *x = xcalloc(2 * room, sizeof *x), *y = x + room, at[2];
    for (size_t i = 0; i < n; i++) {
        mapping_to_scene(&a->image->map, a->points.dim, a->points.x[first + i], at);
        x[i] = at[0], y[i] = at[1];
    }
    snapshot_at_points(now, n, x, y, e);
    free(x);
}

static void write_points(const struct answer *a, double time, FILE *out) {
    struct snapshot now = snapshot_take(a->scene, a->image->of, time);
    const double same[2] = {a->cell, a->cell};
    struct exact *exact = xcalloc(BLOCK, sizeof *exact);
    double value[COLUMNS_VALUES];
    char digits[NUMBER_PRINTED];
    for (size_t i = 0; i < a->points.n; i++) {
        size_t left = a->points.n - i;
        if (a->columns.needs_time && i % BLOCK == 0) exact_of(a, &now, i, left < BLOCK ? left : BLOCK, exact);
        int n = columns_values(&a->columns, a->image, time, a->points.x[i], a->points.cell ? a->points.cell[i] : same,
                               a->columns.needs_time ? &exact[i % BLOCK] : NULL, value);
        for (int d = 0; d < a->points.dim; d++) {
            if (d) putc(',', out);
            const struct points_text *typed = &a->points.typed[i][d];
            int length = typed->length ? 0 : number_print(a->points.x[i][d], digits);
            fwrite(typed->length ? typed->start : digits, 1, (size_t)(typed->length + length), out);
        }
        for (int k = a->times > 1 ? -1 : 0; k < n; k++) {
            size_t length = (size_t)number_print(k < 0 ? time : value[k], digits);
            putc(',', out);
            fwrite(digits, 1, length, out);
        }
        putc('\n', out);
        if (ferror(out)) break;
    }
    free(exact);
    snapshot_free(&now);
}

void answer_write(const struct answer *a, FILE *out) {
    char header[COLUMNS_HEADER];
    columns_header(&a->columns, header);
    fprintf(out, "%s%s%s\n", a->points.dim == 2 ? "x,y" : "x", a->times > 1 ? ",time" : "", header);
    if (a->times == 0) write_points(a, 0, out);
    for (int k = 0; k < a->times && !ferror(out); k++) write_points(a, a->time[k], out);
}
