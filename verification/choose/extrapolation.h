/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_EXTRAPOLATION_H
#define HEATLADDER_VERIFICATION_CHOOSE_EXTRAPOLATION_H

/* Error and work of finer runs, extrapolated from a few coarse runs of one candidate. */

#include "verification/choose/candidate.h"

enum { EXTRAPOLATION_RUNGS = 12 };

struct extrapolation_rung {
    int n;        /* particles along x */
    double error; /* E1 */
};

struct extrapolation {
    const struct candidate *candidate;
    int rungs; /* runs so far, coarsest first */
    struct extrapolation_rung rung[EXTRAPOLATION_RUNGS];
    double order;                           /* error ~ n^-order; 0 where not fitted */
    int wanted;                             /* particles along x that should reach the error */
    double predicted_error, predicted_work; /* there; infinite work where it cannot be */
    double rounding;                        /* rounding error, where it exceeds the error wanted; else 0 */
    char reason[200];                       /* why it cannot */
};

/* What is to be predicted. */
struct extrapolation_goal {
    const struct experiment *experiment;
    double error;    /* E1 */
    double work_max; /* pairs (candidate.h) that a run may take */
    int unit;        /* candidate_unit */
};

/* Runs the coarse rungs and predicts from them. */
void extrapolation_calibrate(struct extrapolation *c, const struct extrapolation_goal *goal);

/* If the predicted size is far beyond the last rung, runs one between; 1 if added. */
int extrapolation_scout(struct extrapolation *c, const struct extrapolation_goal *goal);

/* Adds the measured error of n particles along x to the rungs and predicts again. */
void extrapolation_learn(struct extrapolation *c, const struct extrapolation_goal *goal, int n, double measured);

/* Sets *wanted and its predictions to the finest run, in steps of a tenth, within the limits of work, memory and
 * rounding.  1, or 0 where nothing finer than the rungs can be predicted. */
int extrapolation_finest(struct extrapolation *c, const struct extrapolation_goal *goal);

/* No run of it is wanted: infinite work, and the reason. */
void extrapolation_rule_out(struct extrapolation *c, const char *reason);

#endif
