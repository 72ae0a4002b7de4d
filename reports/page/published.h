#ifndef HEATLADDER_REPORTS_PAGE_PUBLISHED_H
#define HEATLADDER_REPORTS_PAGE_PUBLISHED_H

/* A table as printed in a paper: reports/published/<name>.csv, lines of comment, a header, rows.  The first column
 * names the method, the header's other cells are where (dx, t), as printed. */

struct failure;

enum { REPORT_PUBLISHED_COLUMNS = 8, REPORT_PUBLISHED_ROWS = 4, REPORT_PUBLISHED_CELL = 24 };

struct published {
    int rows, columns; /* without the header and the column of names */
    char method[REPORT_PUBLISHED_ROWS][REPORT_PUBLISHED_CELL];
    char where[REPORT_PUBLISHED_COLUMNS][REPORT_PUBLISHED_CELL];
    char cell[REPORT_PUBLISHED_ROWS][REPORT_PUBLISHED_COLUMNS][REPORT_PUBLISHED_CELL];
    double value[REPORT_PUBLISHED_ROWS][REPORT_PUBLISHED_COLUMNS];
};

/* STATUS_OK, or STATUS_INPUT where the file is not there or is no such table. */
int published_read(struct published *t, const char *name, struct failure *why);

/* Units by which `measured`, rounded to as many digits as `printed` shows, differs from it in the last of them. */
double published_units(const char *printed, double measured);

#endif
