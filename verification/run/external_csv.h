#ifndef HEATLADDER_VERIFICATION_RUN_EXTERNAL_CSV_H
#define HEATLADDER_VERIFICATION_RUN_EXTERNAL_CSV_H

struct failure;
struct field;
struct problem;

/* Reads the points and temperatures at `path`, and the costs in its comments, into *f.  STATUS_OK, the arrays owned
 * by the caller; STATUS_INPUT where the file is missing or ill-formed, STATUS_NUMERICAL where a temperature is not
 * finite, each with the number of the line. */
int external_csv_read(const char *path, const struct problem *p, struct field *f, struct failure *why);

#endif
