/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_EXPERIMENT_H
#define HEATLADDER_VERIFICATION_SOLVE_EXPERIMENT_H

/* One experiment: a problem, a method and their options. */

#include "solver/method.h"
#include "solver/problem.h"
#include "references/quantity.h"
#include "verification/solve/program.h"

struct experiment;
struct failure;
struct field;
struct time_step;

/* Solves e->problem and fills in the open options of *e.  Returns a status of solver/status.h; if STATUS_OK, the
 * caller owns *f. */
typedef int experiment_solve(struct experiment *e, struct field *f, struct time_step *step, struct failure *why);

struct experiment {
    const struct scene *scene;
    const struct method *method;
    struct problem problem; /* set up from the scene and its parameters */
    struct options options;
    double memory;       /* GB, memory limit of a run; 0: the available memory */
    int growth;          /* 1: search for growing modes */
    const char *derived; /* the quantity measured in addition to the field, as typed; NULL for none */
    struct quantity quantity;
    experiment_solve *solve; /* NULL: time_step_solve, by the method; run_program: by `program` */
    struct program program;  /* for run_program */
};

#endif
