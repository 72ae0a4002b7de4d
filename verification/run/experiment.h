/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_EXPERIMENT_H
#define HEATLADDER_VERIFICATION_RUN_EXPERIMENT_H

/* One experiment: what is solved, by whom, and how.  Data only; a run, a ladder and a gate are given one. */

#include "solver/method.h"
#include "solver/problem.h"
#include "references/quantity.h"
#include "verification/foreign/program.h"

struct experiment {
    const struct scene *scene;
    const struct method *method;
    struct problem problem; /* set up from the scene and its parameters */
    struct options options;
    double memory;       /* GB that a run may take; 0: what is there */
    int growth;          /* 1: growing modes are looked for */
    const char *derived; /* the quantity that is measured beside the field, as typed; NULL for none */
    struct quantity quantity;
    struct program program; /* that stands in for the method, where it has a command or results */
};

#endif
