/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_TABLE_FILE_H
#define HEATLADDER_VERIFICATION_FOREIGN_TABLE_FILE_H

#include <stdio.h>

struct column_map;
struct failure;
struct samples;

/* Reads a table of points: a header of names, then a line a point; commas, semicolons or blanks between, quotes
 * around what may hold them, `#` before a comment (`# seconds = S` and likewise steps and updates say what the run
 * took; a comment of names above the first point is a header too).  Columns that nothing is wanted of are skipped.
 * Into *s, whose path and dim are set. */
int table_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why);

#endif
