/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_RUN_H
#define HEATLADDER_VERIFICATION_RUN_RUN_H

#include "verification/run/result.h"

struct experiment;
struct time_step; /* verification/run/time_step.h */

/* The result of an experiment that has not run: what was asked for, no failure, time_error NaN. */
struct result run_blank(const struct experiment *e);

/* Runs the experiment and measures it.  *out is always filled; its failure says what went wrong, and its status is
 * returned.  With `field` not NULL the caller owns *field after STATUS_OK. */
int run_experiment(const struct experiment *e, struct result *out, struct field *field);

/* Solves by e->program, which takes a time step of its own (experiment_solve).  Its number of steps is a claim: at
 * most the square of time_step_weights count for rounding, more than an explicit scheme needs. */
int run_program(struct experiment *e, struct field *f, struct time_step *step, struct failure *why);

/* The same, with the error measured against `reference` (of the same points) and not the exact solution; its own
 * error is error, relative as E1 is. */
int run_against(const struct experiment *e, const double *reference, double error, struct result *out);

/* Solves it over and over for 0.1 s: then program and memory are ready, and the processor runs at its full rate. */
int run_warm_up(const struct experiment *e, struct failure *why);

#endif
