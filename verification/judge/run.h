/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_RUN_H
#define HEATLADDER_VERIFICATION_JUDGE_RUN_H

#include "verification/judge/result.h"

struct experiment;
struct time_step; /* verification/judge/time_step.h */

/* The result of an experiment that has not run: its options, no failure, time_error NaN. */
struct result run_blank(const struct experiment *e);

/* Runs the experiment and measures it. *out is always set; its failure has the reason, and its status is returned.
 * If `field` is not NULL, the caller owns *field after STATUS_OK. */
int run_experiment(const struct experiment *e, struct result *out, struct field *field);

/* Solves by e->program, which chooses its own time step.  Its reported number of steps counts for
 * rounding up to the square of time_step_weights, more than an explicit scheme needs.  It rounds temperatures of the
 * case: an offset (mapping.h) raises the rounding in terms of E1. */
int run_program(struct experiment *e, struct field *f, struct time_step *step, struct failure *why);

/* The same, with the error relative to `reference` (on the same points) instead of the exact solution; its own
 * relative error is `error`, in terms of E1. */
int run_against(const struct experiment *e, const double *reference, double error, struct result *out);

/* Solves repeatedly for 0.1 s, to warm up program, memory and processor. */
int run_warm_up(const struct experiment *e, struct failure *why);

#endif
