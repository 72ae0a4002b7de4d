/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_INDEX_INDEX_H
#define HEATLADDER_REPORTS_INDEX_INDEX_H

#include "verification/page/page.h"

struct failure;

/* <dir>/index.html: one page of the files in `dir`, and <dir>/summary.md: its verdict for the summary of a job.  What
 * is not there is in one line with the command that makes it.  A status of solver/status.h. */
int index_write(const char *dir, struct failure *why);

/* The files of the reports in `dir`, by section, NULL last; 1 where one of a section is there. */
extern const char *const parts_sections[];
int parts_has(const char *section, const char *dir);
void parts_put(const char *section, const char *dir, FILE *out);

/* The charts of `make bench` of that scene; one line that names the command of each file that is not there. */
void parts_put_precision(const char *scene, const char *dir, FILE *out);
void parts_put_missing(const char *dir, FILE *out);

/* The gates that `verify --json` has written, read back; *origin: when, where and by which version they were run.  0,
 * or -1 where there is no such file or it is none of verify's; gates_free in any case, once *origin is done with. */
int gates_json_read(const char *path, struct gates *g, const char **origin);

#endif
