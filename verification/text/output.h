/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_OUTPUT_H
#define HEATLADDER_VERIFICATION_TEXT_OUTPUT_H

/* A file written in memory, then put in its place whole (atomic_file.h).
 *
 *     FILE *out = output_open(&page, "%s/%s.csv", dir, name);
 *     fprintf(out, ...);
 *     return output_close(&page, 1, why); */

#include <stdio.h>

struct failure;

/* Like POSIX open_memstream: a stream with a NUL-terminated text, freed by the caller after fclose; but it ends the
 * program if memory runs out, instead of omitting data.  Not seekable. */
FILE *output_stream(char **text, size_t *size);

struct output {
    FILE *out; /* to be written to; NULL once closed */
    char path[1024], *text;
    int too_long; /* 1: `path` is cut off, which output_close refuses */
    size_t size;
};

/* Opens a file in memory; its place is a path, printf-like.  Ends the program if memory runs out. */
FILE *output_open(struct output *o, const char *path, ...) __attribute__((format(printf, 2, 3)));

/* Ends the writing and sets `text`.  Not required before output_close. */
void output_end(struct output *o);

/* Puts `count` files that belong together in their places: STATUS_OK; or none of them with *why filled, STATUS_INPUT
 * where a place cannot be written.  Frees them. */
int output_close(struct output *o, int count, struct failure *why);

/* Discards the files and frees their memory; some may never have been opened (zeroed). */
void output_drop(struct output *o, int count);

/* Makes the directory if it does not exist, and checks that a file `name` can be written in it. */
int output_directory(const char *dir, const char *name, struct failure *why);

#endif
