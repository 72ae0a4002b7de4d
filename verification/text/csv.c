/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table as CSV: cells are collected, since a later row may bring a new column. */
#include "verification/text/csv.h"

#include "solver/status.h"
#include "verification/text/utf8.h"

#include <stdlib.h>
#include <string.h>

static char *copy(const char *text) {
    char *own = xcalloc(strlen(text) + 1, 1);
    memcpy(own, text, strlen(text));
    utf8_clean(own);
    return own;
}

void csv_row(struct csv *c) {
    c->cell = xgrow(c->cell, (size_t)c->rows, (size_t)c->rows + 1, sizeof *c->cell);
    c->rows++;
    c->last = -1;
}

static int add_column(struct csv *c, const char *name) {
    int place = 0;
    if (c->columns == CSV_COLUMNS) return -1;
    while (c->last >= 0 && c->order[place++] != c->last) continue;
    memmove(c->order + place + 1, c->order + place, (size_t)(c->columns - place) * sizeof *c->order);
    c->order[place] = c->columns;
    c->name[c->columns] = copy(name);
    return c->columns++;
}

void csv_cell(struct csv *c, const char *name, const char *text) {
    int column = 0;
    while (column < c->columns && strcmp(c->name[column], name) != 0) column++;
    if (column == c->columns) column = add_column(c, name);
    if (column < 0) return;
    char **cell = &c->cell[c->rows - 1][column];
    free(*cell); /* the last counts where a member is written twice, as in JSON */
    *cell = copy(text);
    c->last = column;
}

static void put(FILE *out, const char *text) {
    int quoted = strpbrk(text, ",\"") != NULL;
    if (quoted) fputc('"', out);
    for (; *text; text++) fprintf(out, *text == '"' ? "\"\"" : "%c", *text);
    if (quoted) fputc('"', out);
}

void csv_end(struct csv *c, FILE *out) {
    for (int row = -1; row < c->rows; row++) /* -1: the header */
        for (int i = 0; i < c->columns; i++) {
            char *text = row < 0 ? c->name[c->order[i]] : c->cell[row][c->order[i]];
            put(out, text ? text : "");
            fputc(i == c->columns - 1 ? '\n' : ',', out);
            if (row >= 0) free(text);
        }
    for (int i = 0; i < c->columns; i++) free(c->name[i]);
    free(c->cell);
    *c = (struct csv){0};
}
