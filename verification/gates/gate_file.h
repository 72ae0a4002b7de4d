/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_GATE_FILE_H
#define HEATLADDER_VERIFICATION_GATES_GATE_FILE_H

/* Gates of a user, in a file:
 *
 *     GATE("id", QUICK, "measure", "command", lo, hi, ceiling, "why")
 *
 * The file has any number of such rows and C comments.  A text may consist of several literals; a number may be NAN
 * or INFINITY. */

#include "verification/gates/gates.h"

struct gate_file {
    int count;
    struct gate *gate; /* owned; texts point into `text` */
    char *text;        /* owned */
};

/* Reads rows from `size` bytes; messages contain `name`, line and column.  STATUS_OK, or STATUS_INPUT with *why for
 * a row of another form, a repeated id, an unknown measure, an empty band, or a file without rows.  Call
 * gate_file_free in either case. */
int gate_file_read(const char *text, size_t size, const char *name, struct gate_file *f, struct failure *why);

/* Reads rows from a file of at most 1 MB. */
int gate_file_open(const char *path, struct gate_file *f, struct failure *why);

void gate_file_free(struct gate_file *f);

#endif
