/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_TIME_STEP_H
#define HEATLADDER_VERIFICATION_JUDGE_TIME_STEP_H

#include "solver/method.h"

struct failure;
struct field;
struct experiment;

#define TIME_STEP_UPDATES_MAX 2e10 /* about a minute; beyond it a time error above 1 % is accepted */

struct time_step {
    double time_error; /* share of the time step in E1: 0 for the exact stepper, measured if the step was chosen, NaN
                          if it was given */
    double rounding;   /* possible share of rounding in E1 */
    long long updates; /* updates of the other runs of the search for the step */
};

/* Rounding of the weights over a run in units of eps.  Each weight is of size kappa/dx^2 with a relative error eps,
 * the same in every step: 4 dim kappa t/dx^2. */
double time_step_weights(const struct experiment *e);

/* Solves e->problem by e->method and chooses the open options of *e: the stepper, and a time step with at most 1 %
 * of the total error.  On return e->options.stepper is the one used.  Returns a status of solver/status.h; if
 * STATUS_OK, the caller owns *f. */
int time_step_solve(struct experiment *e, struct field *f, struct time_step *stepping, struct failure *why);

struct experiment;

/* The reference of a ladder in time: the semi-discrete equations of the same particles, without time error. */

struct semidiscrete {
    struct field field; /* owned: field_free */
    long long steps;    /* steps of the polynomials; 0 for the exact stepper */
    long long updates;  /* updates of the preceding runs */
    double error; /* error of field: sum w|difference| / sum w|T| to the run with half the steps; 0 for the exact
                     stepper */
};

/* Solves by the exact stepper, or if that does not apply by polynomials.  Returns STATUS_OK; STATUS_NOT_APPLICABLE
 * for other than particle methods; STATUS_UNSTABLE if the equations themselves are unstable. */
int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why);

/* Solves by polynomials, for any method that can step. */
int semidiscrete_polynomials(const struct experiment *e, struct semidiscrete *s, struct failure *why);

#endif
