#ifndef HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H
#define HEATLADDER_VERIFICATION_RUN_SEMIDISCRETE_H

#include "solver/method.h"

struct experiment;

/* What the rungs of a ladder in time are measured against: the same particles' equations, solved without time error.
 */

struct semidiscrete {
    struct field field; /* owned: field_free */
    long long steps;    /* of the midpoint rule; 0 where field is exact in time */
    double error;       /* the time error of field, estimated: sum w|error| / sum w|T|; 0 where exact */
};

/* The exact stepper's field, or where that is refused the midpoint rule's, at steps that suit the rung `finest`.
 * STATUS_OK; STATUS_INPUT for what is no particle method or is refused by either; STATUS_NUMERICAL where the
 * equations themselves are unstable. */
int semidiscrete_solve(const struct experiment *e, struct semidiscrete *truth, struct failure *why);

#endif
