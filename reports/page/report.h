#ifndef HEATLADDER_REPORTS_PAGE_REPORT_H
#define HEATLADDER_REPORTS_PAGE_REPORT_H

/* What every page of the report is made of: runs, each asked for by its command line, and files that are there whole
 * or not at all. */

#include "verification/command/request.h"
#include "verification/run/result.h"

#include <stdio.h>

struct report_run {
    char command[320]; /* as a user would type it after the program's name */
    struct request request;
    struct result result;
    struct field field;
};

/* Reads a command line (printf-like); report_solve then runs it where its verb is `run`.  Both may be called from any
 * thread and keep what went wrong in run->result.failure, which report_check turns into a status and a text that
 * names the command.  The caller ends with report_free. */
void report_start(struct report_run *run, const char *format, ...) __attribute__((format(printf, 2, 3)));
void report_solve(struct report_run *run);
int report_check(const struct report_run *run, struct failure *why);
void report_free(struct report_run *run);

/* E1 (Song eq. 46) against the solution as the source prints it, or `exact` where the two are one; that solution
 * rounded to so many decimals, 0 for none. */
double report_error_as_printed(const struct report_run *run, int decimals);

/* The exact solution at x and the run's end time, K. */
double report_exact(const struct report_run *run, const double x[2]);

struct report_page {
    FILE *out; /* to be written to */
    char *text;
    size_t size;
};

int report_open(struct report_page *page, struct failure *why);
/* Puts the page at <dir>/<name><ending>; frees it in any case. */
int report_close(struct report_page *page, const char *dir, const char *name, const char *ending,
                 struct failure *why);

/* The first lines of a data file: its title, and how to make it again.  Further "# command: ..." lines may follow. */
void report_head(FILE *out, const char *title);

#endif
