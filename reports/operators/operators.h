/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_OPERATORS_H
#define HEATLADDER_REPORTS_OPERATORS_OPERATORS_H

#include "solver/options.h"

#include <stdio.h>

struct failure;

/* The discrete Laplacians side by side into `dir`: operators.md and .html (which to take; orders on every cloud and
 * scene), operators_error.csv (error against neighbours), operators_work.csv, operators_growth.csv.  Progress goes to
 * standard output. */
int operators_write(const char *dir, struct failure *why);

/* ---- Between the files of this folder ---- */

struct cloud_kind {
    const char *name, *options;
    enum layout_name layout;
    double jitter;
};

struct candidate_operator {
    const char *method, *options;
    int materials; /* materials in the test problems */
};

enum { CLOUDS = 5, OPERATORS = 15 };
extern const struct cloud_kind operators_clouds[CLOUDS];
extern const struct candidate_operator operators[OPERATORS];

/* Jittered clouds on which a mode grows. */
struct growth_count {
    int growing, draws;
};

/* Counts them for each operator, and writes every kind of cloud to `figure`. */
void operators_growth(struct growth_count count[OPERATORS], FILE *figure);

#endif
