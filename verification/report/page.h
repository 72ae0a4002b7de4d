/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_REPORT_PAGE_H
#define HEATLADDER_VERIFICATION_REPORT_PAGE_H

#include "verification/gates/gates.h"

#include <stdio.h>

struct ladder;

/* Verdicts of gates for readers. */

enum { PAGE_ORIGIN = 400 }; /* letters of page_origin */

/* Time, machine and version of the program. */
void page_origin(char *text, size_t size);

/* One HTML page at `path`, whole or not at all: verdict, failures with their commands, table; last the command that
 * makes the page, without the program's name.  The ladders of the gates go beside it, as page_data_path names the
 * file.  A status of solver/status.h. */
int page_gates_write(const struct gates *g, const char *title, const char *command, const char *path,
                     struct failure *why);
int page_ladder_write(const struct ladder *l, const struct diagnosis *d, const char *command, const char *path,
                      struct failure *why);

/* verdict.html -> verdict.csv */
void page_data_path(const char *path, char *data, size_t size);

/* The orders of all ladders and the errors of some, in blocks for reports/index/gates.gp. */
void page_data_write(const struct gates *g, const char *command, FILE *out);

/* The verdicts on standard output: each gate with `all`, else how many of each group hold; then the reason, diagnosis
 * and command of every gate that does not hold, with `all` its numbers and why too; then one line of counts. */
void print_gates(const struct gates *g, int all, double seconds);

/* Those that do not hold as annotations of GitHub Actions, on standard error: an error a failure, a warning where
 * none was decided. */
void print_annotations(const struct gates *g);

/* The verdicts as JUnit XML, reasons included.  STATUS_OK, or STATUS_INPUT with *why filled. */
int junit_write(const struct gates *g, const char *path, struct failure *why);

#endif
