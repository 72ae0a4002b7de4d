/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_RUN_H
#define HEATLADDER_VERIFICATION_RUN_RUN_H

#include "verification/run/result.h"

struct experiment;

/* The result of an experiment that has not run: what was asked for, no failure, time_error NaN. */
struct result run_blank(const struct experiment *e);

/* Runs the experiment and measures it.  *out is always filled; its failure says what went wrong, and its status is
 * returned.  With `field` not NULL the caller owns *field after STATUS_OK. */
int run_experiment(const struct experiment *e, struct result *out, struct field *field);

/* The same, with the error measured against `reference` (of the same points) and not the exact solution; its own
 * error is error, relative as E1 is. */
int run_against(const struct experiment *e, const double *reference, double error, struct result *out);

/* Solves it over and over for 0.1 s: then program and memory are ready, and the processor runs at its full rate. */
int run_warm_up(const struct experiment *e, struct failure *why);

#endif
