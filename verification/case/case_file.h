/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_CASE_FILE_H
#define HEATLADDER_VERIFICATION_CASE_CASE_FILE_H

/* The case file: one `key = value` per line, SI units, numbers with 17 digits, several values separated by
 * commas. */

#include <stddef.h>
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

/* Copies the value of a key in the text of a case file, at most size - 1 characters.  Returns 0 if the key
 * exists. */
int case_file_value(const char *text, const char *key, char *value, size_t size);

/* The whole text of a case file, freed by the caller; NULL with *why if it is not one. */
char *case_file_read(const char *path, struct failure *why);

#endif
