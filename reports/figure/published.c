/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a published table. */
#include "reports/figure/published.h"

#include "solver/status.h"
#include "verification/text/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PUBLISHED(name, text) {name, text},
static const struct {
    const char *name, *text;
} tables[] = {
#include "published.inc"
    {NULL, NULL}};
#undef PUBLISHED

/* Cuts *line at its commas into at most max cells; how many. */
static int cells_of(char *line, char **cell, int max) {
    int n = 0;
    for (char *at = line; at && n < max; n++) {
        cell[n] = at;
        at = strchr(at, ',');
        if (at) *at++ = '\0';
    }
    return n;
}

static int fits(char **cell, int n) {
    for (int i = 0; i < n; i++)
        if (strlen(cell[i]) >= PUBLISHED_CELL || !*cell[i]) return 0;
    return n > 1;
}

static void take_header(struct published *t, char **cell, int n) {
    t->columns = n - 1;
    for (int c = 0; c < t->columns; c++) strcpy(t->where[c], cell[c + 1]);
}

/* 0, or -1 where a cell is no number or there is no room. */
static int take_row(struct published *t, char **cell, int n) {
    int r = t->rows;
    if (r == PUBLISHED_ROWS || n != t->columns + 1) return -1;
    strcpy(t->method[r], cell[0]);
    for (int c = 0; c < t->columns; c++) {
        strcpy(t->cell[r][c], cell[c + 1]);
        if (number_read(cell[c + 1], &t->value[r][c])) return -1;
    }
    t->rows++;
    return 0;
}

static int take_line(struct published *t, char *line) {
    char *cell[PUBLISHED_COLUMNS + 1];
    if (*line == '#' || *line == '\0') return 0;
    int n = cells_of(line, cell, PUBLISHED_COLUMNS + 1);
    if (!fits(cell, n)) return -1;
    if (t->columns) return take_row(t, cell, n);
    take_header(t, cell, n);
    return 0;
}

int published_read(struct published *t, const char *name, struct failure *why) {
    int i = 0, bad = 0;
    *t = (struct published){0};
    while (tables[i].name && strcmp(tables[i].name, name) != 0) i++;
    if (!tables[i].name) return refuse(why, STATUS_INPUT, "there is no reports/published/%.60s.csv", name);
    for (const char *from = tables[i].text; *from && !bad;) {
        char line[400];
        size_t length = strcspn(from, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, from);
        bad = length >= sizeof line || take_line(t, line);
        from += length + (from[length] == '\n');
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
