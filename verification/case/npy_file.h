/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_NPY_FILE_H
#define HEATLADDER_VERIFICATION_CASE_NPY_FILE_H

/* NumPy's .npy, little-endian numbers of 8 or 4 bytes: an array of n rows, in C's or Fortran's order, with the
 * columns x, T (x, y, T in the plane, x, y, z, T in space) and optionally w, or those that --columns places; or a
 * structured array with named fields. */

#include <stddef.h>
#include <stdio.h>

struct column_map;
struct failure;
struct samples;

enum { NPY_FILE_START = 8 }; /* bytes by which a file is recognized */
int npy_file_is(const char *start, size_t size);

/* Reads the points into *s, with path and dim already set.  Returns STATUS_OK, or *why states the error and its
 * place. */
int npy_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why);

#endif
