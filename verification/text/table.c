/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table of text: cells are collected, then printed as wide as the widest of their column. */
#include "verification/text/table.h"

#include "solver/status.h"
#include "verification/text/verdict.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

struct table table_create(int columns, int left) {
    return (struct table){.columns = columns, .left = left};
}

/* The parts of the text between bars; the last of so many has all that is left. */
static void add_cells(struct table *t, const char *text, int count) {
    for (; count > 0; count--) {
        size_t length = count > 1 ? strcspn(text, "|") : strlen(text);
        if (t->cells == t->room) {
            t->room = t->room ? 2 * t->room : 8 * t->columns;
            t->cell = xgrow(t->cell, (size_t)t->cells, (size_t)t->room, sizeof *t->cell);
        }
        char *cell = xcalloc(length + 1, 1);
        memcpy(cell, text, length);
        t->cell[t->cells++] = cell;
        text += length + (text[length] == '|');
    }
}

struct table table_headed(int left, const char *header) {
    struct table t = table_create(1, left);
    for (const char *at = header; *at; at++) t.columns += *at == '|';
    add_cells(&t, header, t.columns);
    return t;
}

void table_add(struct table *t, const char *format, ...) {
    char text[TABLE_ROW];
    int count = 1;
    for (const char *at = format; *at; at++) count += *at == '|';
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    add_cells(t, text, count);
}

void table_number(struct table *t, const char *format, double value, const char *none) {
    if (isfinite(value))
        table_add(t, format, value);
    else
        table_add(t, "%s", none);
}

/* 1 if the last column, without its header, contains sentences. */
static int ends_in_words(const struct table *t) {
    for (int i = 2 * t->columns - 1; i < t->cells; i += t->columns)
        if (strchr(t->cell[i], ' ')) return 1;
    return 0;
}

void table_end(struct table *t, FILE *out) {
    int width[TABLE_COLUMNS] = {0}, words = ends_in_words(t);
    for (int i = 0; i < t->cells; i++) {
        int w = (int)strlen(t->cell[i]), c = i % t->columns;
        if (w > width[c]) width[c] = w;
    }
    for (int i = 0; i < t->cells; i++) {
        int c = i % t->columns, last = c == t->columns - 1;
        const char *text = t->cell[i];
        int w = c < t->left ? -width[c] : width[c];
        if (last && (*text == '\0' || words || c < t->left)) w = 0; /* no blanks at the end */
        fprintf(out, "%s%s%*s%s%s", c ? "  " : "", verdict_colour(out, text), w, text, verdict_colour_end(out, text),
                last ? "\n" : "");
    }
    table_free(t);
}

void table_free(struct table *t) {
    for (int i = 0; i < t->cells; i++) free(t->cell[i]);
    free(t->cell);
    *t = (struct table){0};
}
