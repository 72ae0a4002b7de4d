/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_MATCHED_MATCHED_FIGURES_H
#define HEATLADDER_REPORTS_MATCHED_MATCHED_FIGURES_H

struct failure;

/* The matched run (solver/time/matched.h): error against counted work beside Song's choice, into `dir`. */
int matched_figures_write(const char *dir, struct failure *why);

#endif
