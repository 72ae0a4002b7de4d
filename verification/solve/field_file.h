/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_FIELD_FILE_H
#define HEATLADDER_VERIFICATION_SOLVE_FIELD_FILE_H

/* The answer of an external program: a field at t_end, from a table or NumPy's .npy. */

struct column_map;
struct failure;
struct field;
struct image;

/* The field, checked (coverage.h) against the problem of the case and its spacings d by axis, m.  If STATUS_OK, the
 * caller owns *f, with weights of about 1 at most, and step_seconds as reported by the program, NaN if not. */
int field_file_read(const char *path, const char *name, const struct column_map *c, const struct image *image,
                    const double *d, struct field *f, struct failure *why);

#endif
