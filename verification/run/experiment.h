/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_EXPERIMENT_H
#define HEATLADDER_VERIFICATION_RUN_EXPERIMENT_H

/* One experiment: a problem, a method and their options. */

#include "solver/method.h"
#include "solver/problem.h"
#include "references/quantity.h"
#include "verification/foreign/program.h"

struct experiment;
struct failure;
struct field;
struct time_step; /* verification/run/time_step.h */

/* Solves e->problem and resolves what *e leaves open.  A status of solver/status.h; on STATUS_OK the caller owns *f.
 */
typedef int experiment_solve(struct experiment *e, struct field *f, struct time_step *step, struct failure *why);

struct experiment {
    const struct scene *scene;
    const struct method *method;
    struct problem problem; /* set up from the scene and its parameters */
    struct options options;
    double memory;       /* GB that a run may take; 0: what is there */
    int growth;          /* 1: growing modes are looked for */
    const char *derived; /* the quantity that is measured beside the field, as typed; NULL for none */
    struct quantity quantity;
    experiment_solve *solve; /* NULL: time_step_solve, by the method; run_program: by `program` */
    struct program program;  /* of run_program */
};

#endif
