/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_ATOMIC_FILE_H
#define HEATLADDER_VERIFICATION_TEXT_ATOMIC_FILE_H

/* Files that are there whole or not at all: written beside their place under another name, then renamed. */

#include <stddef.h>

struct failure;

/* Whether `path` could be written, so that a long run is refused before it starts.  STATUS_OK or STATUS_INPUT; a NULL
 * path is fine.  Creates nothing, changes nothing. */
int atomic_file_check(const char *path, struct failure *why);

struct atomic_file {
    const char *path, *bytes;
    size_t size;
};

/* Puts the bytes of each of them at its path; where there are several, all are written in full before the first takes
 * its place.  STATUS_OK or STATUS_INPUT; on a failure, or when interrupted, what was there before stays whole.
 * Interrupts (SIGINT, SIGTERM, SIGHUP) wait until the files are in their places; no two threads may write at once.
 * What is no regular file (/dev/null, a pipe), or lies in a directory that may not be written, is written to as it
 * is: it may be left in part. */
int atomic_file_write_all(const struct atomic_file *files, int count, struct failure *why);

/* From hold to release SIGINT, SIGTERM and SIGHUP are noted, and raised by the outermost release.  Calls nest, and
 * may come from any thread; what the caller of this program ignores stays ignored. */
void atomic_file_hold(void);
int atomic_file_noted(void); /* the signal that waits, 0 for none */
void atomic_file_release(void);

#endif
