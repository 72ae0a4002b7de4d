/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_INDEX_INDEX_H
#define HEATLADDER_REPORTS_INDEX_INDEX_H

#include <stdio.h>

struct failure;

/* <dir>/index.html: one page of the tables and figures in `dir`, and the commands that make those that are not there.
 * A status of solver/status.h. */
int index_write(const char *dir, struct failure *why);

/* The parts of a section that are in `dir`; 1 where there is one. */
int parts_put(const char *section, const char *dir, FILE *out);
int parts_has(const char *section, const char *dir);

/* The figures of one scene: its ladders, and the charts of `make bench`. */
int parts_has_ladder(const char *scene, const char *dir); /* its figure of make verify is there */
void parts_put_scene(const char *scene, const char *dir, FILE *out);

/* One line: the sections that lack a part, with the command that makes it. */
void parts_put_missing(const char *dir, FILE *out);

#endif
