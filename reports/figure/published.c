/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds a published table. */
#include "reports/figure/published.h"

#include "solver/status.h"
#include "verification/text/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PUBLISHED(name, ...) {name, {__VA_ARGS__}},
static const struct table {
    const char *name;
    const char *cell[PUBLISHED_ROWS + 1][PUBLISHED_COLUMNS + 1]; /* the header first; NULL if empty */
} tables[] = {
#include "published.inc"
    {0}};
#undef PUBLISHED

int published_read(struct published *t, const char *name, struct failure *why) {
    const struct table *of = tables;
    int bad = 0;
    *t = (struct published){0};
    while (of->name && strcmp(of->name, name) != 0) of++;
    if (!of->name) return refuse(why, STATUS_INPUT, "there is no reports/published/%.60s.csv", name);
    for (; t->columns < PUBLISHED_COLUMNS && of->cell[0][t->columns + 1]; t->columns++)
        t->where[t->columns] = of->cell[0][t->columns + 1];
    for (; t->rows < PUBLISHED_ROWS && of->cell[t->rows + 1][0]; t->rows++) {
        const char *const *row = of->cell[t->rows + 1];
        t->method[t->rows] = row[0];
        for (int c = 0; c < t->columns; c++) {
            t->cell[t->rows][c] = row[c + 1];
            bad |= !row[c + 1] || number_read(row[c + 1], &t->value[t->rows][c]);
        }
    }
    if (!bad && t->rows > 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "reports/published/%.60s.csv is no table of numbers with a header", name);
}

int published_row(const struct published *t, const char *method) {
    int r = 0;
    while (r < t->rows && strcmp(t->method[r], method) != 0) r++;
    return r < t->rows ? r : -1;
}

double published_units(const char *printed, double measured) {
    char *end;
    double value = strtod(printed, &end);
    const char *point = strchr(printed, '.'), *power = strpbrk(printed, "eE");
    long digits = point ? (power ? power : end) - point - 1 : 0;
    double unit = pow(10, (power ? (double)atol(power + 1) : 0) - (double)digits);
    return round(measured / unit) - round(value / unit);
}
