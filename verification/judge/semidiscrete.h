/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_SEMIDISCRETE_H
#define HEATLADDER_VERIFICATION_JUDGE_SEMIDISCRETE_H

#include "solver/method.h"

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
