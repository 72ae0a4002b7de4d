#ifndef HEATLADDER_REPORTS_PAMPLONA_PLATE_H
#define HEATLADDER_REPORTS_PAMPLONA_PLATE_H

/* Pamplona 2019, Table 1: the "average error", which the paper does not define, by every definition at hand. */

struct failure;
struct command_run;

enum { REPORT_PLATE_MEAN_RELATIVE, REPORT_PLATE_ERRORS = 7 };

/* Errors of the run's field against the exact solution at time t, s; in %, in the order of the table's rows. */
void pamplona_plate_errors(const struct command_run *run, double t, double error[REPORT_PLATE_ERRORS]);

int pamplona_plate_write(const char *dir, struct failure *why);

#endif
