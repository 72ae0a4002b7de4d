/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_INDEX_INDEX_H
#define HEATLADDER_REPORTS_INDEX_INDEX_H

struct failure;

/* <dir>/index.html: one page of the files in `dir`, and <dir>/summary.md: its verdict for the summary of a job.  What
 * is not there is in one line with the command that makes it.  A status of solver/status.h. */
int index_write(const char *dir, struct failure *why);

#endif
