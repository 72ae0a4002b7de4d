/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H
#define HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H

#include "solver/method.h"

struct experiment;

/* The reference of a ladder in time: the semi-discrete equations of the same particles, solved without time error. */

struct semidiscrete {
    struct field field; /* owned: field_free */
    long long steps;    /* by polynomials; 0 where field is the exact stepper's */
    long long updates;  /* of the runs before this one */
    double error;       /* of field: sum w|difference| / sum w|T| of it and of half as many steps; 0 where exact */
};

/* The exact stepper's field, or where there is none that of polynomials.  STATUS_OK; STATUS_NOT_APPLICABLE for
 * what is no particle method; STATUS_UNSTABLE where the equations themselves are. */
int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why);

/* By polynomials wherever the method can step. */
int semidiscrete_polynomials(const struct experiment *e, struct semidiscrete *s, struct failure *why);

#endif
