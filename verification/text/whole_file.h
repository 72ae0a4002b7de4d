/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_WHOLE_FILE_H
#define HEATLADDER_VERIFICATION_TEXT_WHOLE_FILE_H

/* All of a file as text in memory, ended by a NUL that *size does not count (size may be NULL).  To be freed. */

#include <stdio.h>

/* fopen of a file to be read: NULL with errno set; but ends the program where memory is out, so that a file
 * that is there is not taken for one that is not.  A named pipe is refused (ENOTSUP), as it may have no writer. */
FILE *whole_file_open(const char *path);

/* Text of errno after a failure of whole_file_open or whole_file_at. */
const char *whole_file_error(void);

/* Reads the rest of a stream; ferror(in) is set if it could not be read to its end.  Reading stops at a NUL, which
 * is not text, because a device may produce them without end. */
char *whole_file_read(FILE *in, size_t *size);

/* NULL with errno set where the file cannot be opened or read. */
char *whole_file_at(const char *path, size_t *size);

#endif
