#ifndef HEATLADDER_VERIFICATION_CHOOSE_H
#define HEATLADDER_VERIFICATION_CHOOSE_H

/* The cheapest run of a scene that reaches an error. */

#include "verification/candidate.h"

enum { CHOOSE_CANDIDATES = 24, CHOOSE_RUNGS = 12 };

struct choose_rung {
    int n;                     /* particles along x */
    double error, once, steps; /* work of setting up and of the steps */
};

struct choose_one {
    const struct candidate *candidate;
    int rungs; /* runs so far, coarsest first */
    struct choose_rung rung[CHOOSE_RUNGS];
    double order, once, steps;              /* error ~ n^-order, work ~ n^once and n^steps; 0 where not fitted */
    int wanted;                             /* particles along x that should reach the error */
    double predicted_error, predicted_work; /* there; infinite work where it cannot be */
    char reason[200];                       /* why it cannot */
};

struct choose {
    double error; /* wanted: E1 */
    int count;
    struct choose_one one[CHOOSE_CANDIDATES]; /* cheapest first once it ends */
    int proofs;                               /* proving runs */
    double rounding; /* least that it leaves of a run foretold to reach the error, where that is more; 0: none */
    int reached;     /* 1: the last of them has the error */
    struct choose_one best; /* what that run was, as foretold before it */
    struct result proof;
};

/* STATUS_OK, STATUS_GATE where the error was not reached (*c then tells the best), or STATUS_INPUT. */
int choose_run(const struct request *r, double error, struct choose *c, struct failure *why);

#endif
