/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_PUBLISHED_H
#define HEATLADDER_REPORTS_FIGURE_PUBLISHED_H

/* A table as printed in a paper: reports/published/<name>.csv, lines of comment, a header, rows.  The first column
 * names the method, the header's other cells are where (dx, t), as printed.  The files are compiled in, so that the
 * program finds them wherever it is run; no number of theirs stands anywhere else. */

struct failure;

enum { PUBLISHED_COLUMNS = 8, PUBLISHED_ROWS = 4 };

struct published {
    int rows, columns; /* without the header and the column of names */
    const char *method[PUBLISHED_ROWS];
    const char *where[PUBLISHED_COLUMNS];
    const char *cell[PUBLISHED_ROWS][PUBLISHED_COLUMNS];
    double value[PUBLISHED_ROWS][PUBLISHED_COLUMNS];
};

/* STATUS_OK, or STATUS_INPUT where there is no such table. */
int published_read(struct published *t, const char *name, struct failure *why);

/* The row of that method, or -1. */
int published_row(const struct published *t, const char *method);

/* Units by which `measured`, rounded to as many digits as `printed` shows, differs from it in the last of them. */
double published_units(const char *printed, double measured);

#endif
