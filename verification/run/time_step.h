/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_TIME_STEP_H
#define HEATLADDER_VERIFICATION_RUN_TIME_STEP_H

struct failure;
struct field;
struct experiment;

#define TIME_STEP_UPDATES_MAX 2e10 /* a minute or so; past it the 1 % rule lets a time error stand */

struct time_step {
    double time_error; /* the part of E1 that the time step makes up: 0 for the exact stepper, measured where the step
                          was chosen, NaN where it was given */
    double rounding;   /* the part of E1 that rounding can make up */
    long long updates; /* of the runs that it took to choose the step, the one that counts left out */
};

/* Rounding of the weights over a run, in units of eps: each is of size kappa/dx^2 and wrong by eps of that, the same
 * at every step: 4 dim kappa t/dx^2. */
double time_step_weights(const struct experiment *e);

/* Solves e->problem by e->method and chooses what *e leaves open: the stepper, and a time step whose error
 * is at most 1 % of the whole.  On return e->options.stepper is the one that was used.  A status of solver/status.h;
 * on STATUS_OK the caller owns *f. */
int time_step_solve(struct experiment *e, struct field *f, struct time_step *stepping, struct failure *why);

#endif
