/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_NPY_FILE_H
#define HEATLADDER_VERIFICATION_FOREIGN_NPY_FILE_H

#include <stddef.h>
#include <stdio.h>

struct column_map;
struct failure;
struct samples;

/* Whether a file starts as NumPy's .npy. */
int npy_file_is(const char *start, size_t size);

/* Reads NumPy's .npy, little-endian numbers of 8 or 4 bytes: an array of n rows and the columns x, T (x, y, T for a
 * rectangle) and w where there is one more; or a structured one, whose fields go by their names.  Into *s, whose path
 * and dim are set. */
int npy_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why);

#endif
