/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_SPACE_SPACE_STUDY_H
#define HEATLADDER_REPORTS_SPACE_SPACE_STUDY_H

struct failure;

/* The jump in space: a slice through the error of the first- and the second-order operator, and E1 against dx. */
int space_study_write(const char *dir, struct failure *why);

#endif
