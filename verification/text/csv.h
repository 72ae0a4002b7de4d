/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_CSV_H
#define HEATLADDER_VERIFICATION_TEXT_CSV_H

/* A table as CSV (RFC 4180): one header line, then one line a row.  Rows may lack cells; a column takes its place
 * after that of the cell before it. */

#include <stdio.h>

enum { CSV_COLUMNS = 160 };

struct csv {
    int columns, rows, last;    /* last: column of the cell written last in this row, -1: none */
    int order[CSV_COLUMNS];     /* columns from left to right */
    char *name[CSV_COLUMNS];    /* owned */
    char *(*cell)[CSV_COLUMNS]; /* owned: a row each; NULL: empty */
};

void csv_row(struct csv *c); /* begins a row */
/* Puts a cell into the row; text that is no UTF-8, and control characters, become '?'.  Columns past CSV_COLUMNS are
 * dropped. */
void csv_cell(struct csv *c, const char *name, const char *text);
void csv_end(struct csv *c, FILE *out); /* prints and frees it */

#endif
