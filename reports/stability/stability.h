/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_STABILITY_STABILITY_H
#define HEATLADDER_REPORTS_STABILITY_STABILITY_H

/* The data of the figures of stability: one file a figure, one block a curve (# NAME, header, rows, two blank lines;
 * gnuplot: plot FILE index "NAME").  A plot draws and never computes. */

#include "verification/stability/model_problem.h"

#include <stdio.h>

/* All pages into `dir`; progress goes to standard output. */
int stability_write(const char *dir, struct failure *why);

/* The head of a page: its title and one command that gives a number of it. */
void stability_head(FILE *out, const char *title, const char *command);
/* The head of a block: its columns, and its name (printf-like). */
void stability_block(FILE *out, const char *columns, const char *name, ...) __attribute__((format(printf, 3, 4)));

/* The model problem of a method by its name, with a kernel and an h/dx (h = 0: the default), defaults not yet
 * resolved. */
struct model_problem stability_model(const char *method, int dim, enum kernel_name kernel, double h);

/* The pages.  Each writes into `out`. */
int stability_limits_page(FILE *out, struct failure *why);
int stability_jitter_page(FILE *out, struct failure *why);
int stability_blowup_page(FILE *out, struct failure *why);
int stability_checkerboard_page(FILE *out, struct failure *why);

#endif
