/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_TABLE_H
#define HEATLADDER_VERIFICATION_TEXT_TABLE_H

/* Tables of text with aligned columns. */

#include <stdio.h>

enum { TABLE_COLUMNS = 16, TABLE_ROW = 8000 /* letters of one table_add */ };

struct table {
    int columns;
    int left;  /* the first so many columns are set left, and a last one of sentences; the others right */
    int cells; /* filled so far, row by row; the first row is the header */
    int room;
    char **cell; /* owned */
};

/* Without a row yet; end with table_end. */
struct table table_create(int columns, int left);
/* With a first row: "one|two|three". */
struct table table_headed(int left, const char *header);
/* One cell, or several: "%s|%d|%.3g".  The last takes all that is left, bars too. */
void table_add(struct table *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The value, or `none` where it is not finite. */
void table_number(struct table *t, const char *format, double value, const char *none)
    __attribute__((format(printf, 2, 0)));
void table_end(struct table *t, FILE *out); /* prints and frees it */
void table_free(struct table *t);

#endif
