/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_TIME_STEP_H
#define HEATLADDER_VERIFICATION_RUN_TIME_STEP_H

#include <stddef.h>

struct failure;
struct field;
struct options;
struct experiment;

#define TIME_STEP_UPDATES_MAX 2e10 /* a minute or so; past it the 1 % rule lets a time error stand */

/* The order of o->stepper, which is neither exact nor matched. */
int time_step_order(const struct options *o);

/* Steps of the first run of a search. */
double time_step_first(const struct experiment *e);

/* How many steps time_step_solve will take where *e leaves them open, the stepper is not the exact one, `space` is E1
 * without time error and `time` / steps^p what the steps add, p the stepper's order.  0: out of reach. */
double time_step_forecast(const struct experiment *e, double particles, double time, double space);

/* Bytes held beside a run while its time step is searched for, of n points and `answer` bytes a run: the exact
 * temperatures and the run before; by polynomials the run before alone; for --time-error two runs and the
 * temperatures without time error too. */
size_t time_step_bytes(const struct experiment *e, size_t n, size_t answer);

struct time_step {
    double time_error; /* the part of E1 that the time step makes up: 0 for the exact stepper, measured where the step
                          was chosen, NaN where it was given */
    long long updates; /* of the runs that it took to choose the step, the one that counts left out */
};

/* Solves e->problem by e->method and chooses what *e leaves open: the stepper, and a time step whose error
 * is at most 1 % of the whole.  On return e->options.stepper is the one that was used.  A status of solver/status.h;
 * on STATUS_OK the caller owns *f. */
int time_step_solve(struct experiment *e, struct field *f, struct time_step *stepping, struct failure *why);

#endif
