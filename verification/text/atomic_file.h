/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_ATOMIC_FILE_H
#define HEATLADDER_VERIFICATION_TEXT_ATOMIC_FILE_H

/* Files that are there whole or not at all: written beside their place under another name, then renamed. */

#include <stddef.h>

struct failure;

/* Checks that `path` can be written, so that a long run is refused before it starts.  Returns STATUS_OK or
 * STATUS_INPUT; a NULL path is valid.  Creates and changes nothing. */
int atomic_file_check(const char *path, struct failure *why);

struct atomic_file {
    const char *path, *bytes;
    size_t size;
};

/* Writes the bytes of each file to its path; if there are several, all are written completely before the first is
 * moved into place.  Returns STATUS_OK or STATUS_INPUT; after a failure or an interrupt the previous files are
 * intact.  Interrupts (SIGINT, SIGTERM, SIGHUP) wait until all files are in place; only one thread may write at a
 * time.  Special files (/dev/null, a pipe), and files in a read-only directory, are written in place and may remain
 * incomplete. */
int atomic_file_write_all(const struct atomic_file *files, int count, struct failure *why);

/* Between hold and release SIGINT, SIGTERM and SIGHUP are recorded, and raised by the outermost release.  Calls nest
 * and are thread-safe; signals that the caller of this program ignores stay ignored. */
void atomic_file_hold(void);
int atomic_file_noted(void); /* the signal that waits, 0 for none */
void atomic_file_release(void);

#endif
