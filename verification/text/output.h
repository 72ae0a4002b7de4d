/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_OUTPUT_H
#define HEATLADDER_VERIFICATION_TEXT_OUTPUT_H

/* Files that are there whole or not at all: written in memory, then put in their places.
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

/* Opens a file in memory; its place is a path, printf-like, or `-` for standard output.  Ends the program if memory
 * runs out. */
FILE *output_open(struct output *o, const char *path, ...) __attribute__((format(printf, 2, 3)));

/* Ends the writing and sets `text`.  Not required before output_close. */
void output_end(struct output *o);

/* Puts `count` files that belong together in their places: STATUS_OK; or none of them with *why filled, STATUS_INPUT
 * where a place cannot be written, and the previous files are intact.  All are written completely before the first is
 * moved into place; interrupts wait until the last is.  Special files (/dev/null, a pipe), and files in a read-only
 * directory, are written in place and may remain incomplete.  Frees the files. */
int output_close(struct output *o, int count, struct failure *why);

/* Discards the files and frees their memory; some may never have been opened (zeroed). */
void output_drop(struct output *o, int count);

/* Checks that `path` can be written, and makes the directories that it lacks, so that a long run is refused before it
 * starts.  With `-`, what the program prints goes to standard error from here on.  Returns STATUS_OK or STATUS_INPUT;
 * a NULL path is valid.  Changes no file. */
int output_check(const char *path, struct failure *why);
int output_directory(const char *dir, const char *name, struct failure *why); /* the same for dir/name */

/* Makes the directories of `path`, up to its last slash. */
int output_folders(const char *path, struct failure *why);

/* Between hold and release SIGINT, SIGTERM and SIGHUP are recorded, and raised by the outermost release.  Calls nest
 * and are thread-safe; signals that the caller of this program ignores stay ignored. */
void output_hold(void);
int output_noted(void); /* the signal that waits, 0 for none */
void output_release(void);

#endif
