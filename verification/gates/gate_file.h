/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_GATE_FILE_H
#define HEATLADDER_VERIFICATION_GATES_GATE_FILE_H

/* Gates that a user keeps beside their own code:
 *
 *     GATE("id", QUICK, "measure", "command", lo, hi, ceiling, "why")
 *
 * any number of them, with C comments between; a text may be of several literals, a number NAN or INFINITY. */

#include "verification/gates/gates.h"

struct gate_file {
    int count;
    struct gate *gate; /* owned; its texts point into `text` */
    char *text;        /* owned */
};

/* Rows from `size` bytes; `name` stands in messages, with line and column.  STATUS_OK, or STATUS_INPUT with *why
 * where a row is not of that form, an id is there twice, a measure is unknown, a band is none, or there is no row.
 * End with gate_file_free in any case. */
int gate_file_read(const char *text, size_t size, const char *name, struct gate_file *f, struct failure *why);

/* The same from a file of at most 1 MB. */
int gate_file_open(const char *path, struct gate_file *f, struct failure *why);

void gate_file_free(struct gate_file *f);

#endif
