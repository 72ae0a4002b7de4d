/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_CASE_FILE_H
#define HEATLADDER_VERIFICATION_CASE_CASE_FILE_H

/* The case file: one `key = value` per line, SI units, numbers with 17 digits, several values separated by
 * commas. */

#include "verification/case/rows.h"

#include <stdio.h>

struct failure;
struct mapping;
struct options;
struct problem;
struct scene;

extern const char case_file_help[]; /* every key, for --help */

struct case_extra { /* settings that are not part of the problem */
    const char *label;
    const struct mapping *map; /* between the scene and the case; NULL for none */
    const char *name, *value;  /* parameter of --vary; NULL for none */
    int seed;                  /* seed of --seeds, from 1; 0 for none */
};

/* *p: the problem of the case (mapping_image).  Returns STATUS_OK, or STATUS_INPUT with the nearest valid spacings
 * if dx and dy of *o do not divide the extents of *p into whole cells, to a relative tolerance of 1e-6. */
int case_file_check(const struct problem *p, const struct options *o, struct failure *why);

/* Writes the data with which an external program solves the image of *p, of the scene *s, at *o. */
void case_file_write(const struct scene *s, const struct problem *p, const struct options *o,
                     const struct case_extra *extra, FILE *out);

/* The rows of a case file, to be released in either case; STATUS_INPUT if there is none. */
int case_file_read(const char *path, struct rows *r, struct failure *why);

/* The value of a key, NULL for none; *line, unless NULL, becomes its line. */
const char *case_file_value(const struct rows *r, const char *key, long *line);

/* STATUS_OK if the kept case and that in `text`, which is freed, are of one problem and spacing; else STATUS_INPUT
 * with key and line.  Steps, labels, and the key `but` may differ, and keys may be missing from the kept case. */
int case_file_compare(const struct rows *kept, char *text, const char *but, struct failure *why);

#endif
