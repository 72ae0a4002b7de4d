/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_ROWS_H
#define HEATLADDER_VERIFICATION_CASE_ROWS_H

/* The reader of text tables: answers of programs, points of `reference`, case files, tables of papers.
 *
 * A row is a line; its cells are separated by commas, semicolons or blanks, with optional quotes.  Blank lines are
 * skipped; a line that starts with # is a comment. */

#include <stddef.h>
#include <stdio.h>

struct failure;

enum { ROWS_CELLS = 256 };

struct rows_line {
    const char *text; /* without its end; of a comment: without # */
    long number;      /* from 1 */
};

struct rows_cell {
    const char *text; /* without blanks around it and quotes; not ended by a NUL */
    size_t length;
};

struct rows {         /* release with rows_free */
    const char *name; /* the file in messages */
    char *text;
    size_t count, comments;
    struct rows_line *line, *comment;
};

/* Reads the rest of a stream.  Returns STATUS_OK, or STATUS_INPUT with file and line in *why for a text that is cut
 * off, has a NUL, or cannot be read. */
int rows_read(FILE *in, const char *name, struct rows *r, struct failure *why);

/* The rows of a NUL-terminated text, which is changed and freed with them. */
int rows_of(char *text, const char *name, struct rows *r, struct failure *why);

void rows_free(struct rows *r);

/* ';' where the line has one, else ',', else ' ' for any number of blanks. */
char rows_separator(const char *line);

/* The number of cells of a line; -1 with *why for more than ROWS_CELLS or text after a quote. */
int rows_split(const struct rows *r, const struct rows_line *l, char separator, struct rows_cell cell[ROWS_CELLS],
               struct failure *why);

/* The place of a name among n cells, from 0; -1 for none, -2 with *why for two. */
int rows_find(const struct rows *r, const struct rows_line *l, const struct rows_cell *cell, int n, const char *name,
              struct failure *why);

struct rows_column {
    const char *name;        /* in messages */
    int place;               /* index of its cell, from 0; -1: the column is not read */
    size_t stride;           /* from row to row, in `value` and `typed` */
    double *value;           /* receives the numbers */
    struct rows_cell *typed; /* receives the cells; NULL: not wanted */
};

/* Reads columns of the rows from `first` on, which have `width` cells each.  Returns STATUS_OK; or of the first row
 * that is wrong, with file, line, column and text in *why, STATUS_NUMERICAL where the number is not finite, else
 * STATUS_INPUT. */
int rows_numbers(const struct rows *r, size_t first, char separator, int width, const struct rows_column *column,
                 int columns, struct failure *why);

/* Whether a cell is that word. */
int rows_is(const struct rows_cell *cell, const char *word);

/* A text for a message: printable, at most 40 characters, with a mark if truncated. */
const char *rows_quote(const char *text, size_t length, char quoted[48]);

#endif
