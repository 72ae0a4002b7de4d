/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_CANDIDATES_H
#define HEATLADDER_REPORTS_OPERATORS_CANDIDATES_H

/* The clouds and the operators that the study puts side by side. */

#include "solver/options.h"

#include <stdio.h>

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
