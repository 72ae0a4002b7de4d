/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_FIELD_FILE_H
#define HEATLADDER_VERIFICATION_FOREIGN_FIELD_FILE_H

/* The answer of another program: a field of *p at t_end, from a table or NumPy's .npy. */

struct column_map;
struct failure;
struct field;
struct problem;
struct samples;

/* As the file has it, for points of that many coordinates; messages call it `name`.  End with samples_free. */
int field_file_samples(const char *path, const char *name, int dim, const struct column_map *c, struct samples *s,
                       struct failure *why);

/* Checked (coverage.h) against dx and dy, m.  STATUS_OK: the caller owns *f,
 * whose step_seconds are those that the program says it took, NaN where it says nothing. */
int field_file_read(const char *path, const char *name, const struct column_map *c, const struct problem *p,
                    const double d[2], struct field *f, struct failure *why);

#endif
