/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_WHOLE_FILE_H
#define HEATLADDER_VERIFICATION_TEXT_WHOLE_FILE_H

/* All of a file as NUL-terminated text in memory; *size excludes the NUL (size may be NULL).  The caller frees
 * it. */

#include <stdio.h>

/* fopen for reading: NULL with errno set on failure; ends the program if memory runs out, so that an existing file
 * is not reported as missing.  A named pipe is refused (ENOTSUP), since it may have no writer. */
FILE *whole_file_open(const char *path);

/* Text of errno after a failure of whole_file_open or whole_file_at. */
const char *whole_file_error(void);

/* Reads the rest of a stream; ferror(in) is set if it could not be read to its end.  Reading stops at a NUL, which
 * is not text, because a device may produce them without end. */
char *whole_file_read(FILE *in, size_t *size);

/* NULL with errno set if the file cannot be opened or read. */
char *whole_file_at(const char *path, size_t *size);

#endif
