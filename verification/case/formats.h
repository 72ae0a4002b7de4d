/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_FORMATS_H
#define HEATLADDER_VERIFICATION_CASE_FORMATS_H

/* The formats of an answer: recognition of a file by its start, and a reader of its points into *s, with path and
 * dim already set.  A reader returns STATUS_OK, or *why states the error and its place. */

#include <stddef.h>
#include <stdio.h>

struct column_map;
struct failure;
struct samples;

/* NumPy's .npy, little-endian numbers of 8 or 4 bytes: an array of n rows with the columns x, T (x, y, T in
 * the plane, x, y, z, T in space) and optionally w; or a structured array with named fields. */
int npy_file_is(const char *start, size_t size);
int npy_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why);

/* Any other file is a table of points: a header of names, then one point per line; separated by commas, semicolons
 * or blanks, with optional quotes, and comments after `#`.  Comments may report costs (`# seconds = S`; also steps
 * and updates); a comment of names above the first point is a header too.  Unused columns are skipped. */
int table_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why);

#endif
