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
    int materials; /* how many it knows */
};

enum { CLOUDS = 6, OPERATORS = 15 };
extern const struct cloud_kind operators_clouds[CLOUDS];
extern const struct candidate_operator operators[OPERATORS];

/* Each operator of one material by itself on each cloud: least weight, largest stable step, neighbours, assembly. */
void operators_traits(FILE *csv, FILE *md);

#endif
