/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_GATE_FILE_H
#define HEATLADDER_VERIFICATION_GATES_GATE_FILE_H

/* Gates of a user, in a file:
 *
 *     GATE("id", QUICK, "measure", "command", lo, hi, ceiling, "why")
 *
 * any number of rows, with C comments between; a text may be several literals, a number NAN or INFINITY. */

#include "verification/gates/gates.h"

struct gate_file {
    int count;
    struct gate *gate; /* owned; texts point into `text` */
    char *text;        /* owned */
};

/* Rows from `size` bytes; messages have `name`, line and column.  STATUS_OK, or STATUS_INPUT with *why for a row of
 * another form, an id that occurs twice, an unknown measure, a band without inside, or no row.  gate_file_free in
 * either case. */
int gate_file_read(const char *text, size_t size, const char *name, struct gate_file *f, struct failure *why);

/* The same from a file of at most 1 MB. */
int gate_file_open(const char *path, struct gate_file *f, struct failure *why);

void gate_file_free(struct gate_file *f);

#endif
