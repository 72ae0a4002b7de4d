/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_READING_H
#define HEATLADDER_REPORTS_FIGURE_READING_H

/* Commands of claims and studies, and the numbers that are read from them: what `heatladder COMMAND --json` prints.
 */

#include "solver/status.h"

#include <stdio.h>

struct reading {
    char command[400];      /* a run, ladder or limit, as typed after the program's name */
    char *json;             /* owned: its output; NULL where there is none */
    struct failure failure; /* a refused command or a failed run */
};

/* Sets the command (printf-like); nothing runs yet. */
void reading_set(struct reading *r, const char *command, ...) __attribute__((format(printf, 2, 3)));

/* Runs the commands in parallel, the last first, since the finest stands last.  STATUS_OK, or *why of the first that
 * failed, with its command.  A run that grows beyond all bounds is an answer (key "failure"), and no failure. */
int reading_run(struct reading *r, int count, struct failure *why);

/* The number under a key of the outermost object; NaN where that is null.  Further forms:
 *
 *     "a,b"         the larger of the two
 *     "a/b"         their ratio
 *     "a after B"   the first a behind the text B
 *     "failure"     1 for a run that failed, else 0 */
double reading_value(const struct reading *r, const char *key);

/* The text under a key, cut to size; "" where that is null. */
void reading_text(const struct reading *r, const char *key, char *text, size_t size);

/* The numbers under blank-separated keys, as a line of CSV. */
void reading_row(const struct reading *r, const char *keys, FILE *out);

void reading_free(struct reading *r, int count);

#endif
