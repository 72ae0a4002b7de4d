#ifndef HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H
#define HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H

#include "solver/method.h"

struct experiment;

/* The reference of a ladder in time: the semi-discrete equations of the same particles, solved without time error. */

struct semidiscrete {
    struct field field; /* owned: field_free */
    long long steps;    /* of the midpoint rule; 0 where field is exact in time */
    double error;       /* the time error of field, estimated: sum w|error| / sum w|T|; 0 where exact */
};

/* The exact stepper's field, or where there is none the midpoint rule's, at steps that suit *e, the finest rung.
 * STATUS_OK; STATUS_NOT_APPLICABLE for what is no particle method; STATUS_UNSTABLE where the equations themselves
 * are. */
int semidiscrete_solve(const struct experiment *e, struct semidiscrete *s, struct failure *why);

#endif
