/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_CHOOSE_H
#define HEATLADDER_VERIFICATION_CHOOSE_CHOOSE_H

/* The cheapest run of a scene that reaches an error. */

#include "verification/choose/extrapolation.h"
#include "verification/choose/forewarn.h"

enum { CHOOSE_CANDIDATES = 32 };

extern const double choose_work_max; /* pairs: a minute or so */

struct choose {
    double error; /* wanted: E1 */
    int count;
    struct extrapolation one[CHOOSE_CANDIDATES]; /* cheapest first once it ends */
    int proofs;                                  /* proving runs */
    double rounding;                             /* smallest rounding error among runs limited by rounding; 0: none */
    int reached;                                 /* 1: the proof has the error */
    struct extrapolation best;                   /* what that run was, as predicted before it */
    struct result proof;                         /* the best of the proving runs */
    double between;                              /* its E1 half-way between the particles */
    struct forewarned forewarned;                /* of the proving runs */
};

/* No run takes more than work_max.  STATUS_OK; STATUS_GATE where the error was not reached (the best is in *c); or
 * STATUS_INPUT. */
int choose_run(const struct experiment *e, double error, double work_max, struct choose *c, struct failure *why);

#endif
