#ifndef HEATLADDER_VERIFICATION_CHOOSE_EXTRAPOLATION_H
#define HEATLADDER_VERIFICATION_CHOOSE_EXTRAPOLATION_H

/* What a few coarse runs of one candidate foretell of finer ones. */

#include "verification/choose/candidate.h"

enum { PROSPECT_RUNGS = 12 };

struct extrapolation_rung {
    struct candidate_size size;
    double error; /* E1 */
};

struct extrapolation {
    const struct candidate *candidate;
    int rungs; /* runs so far, coarsest first */
    struct extrapolation_rung rung[PROSPECT_RUNGS];
    double order;                           /* error ~ n^-order; 0 where not fitted */
    double time_constant;                   /* E1 of N time steps is this over N^2; 0 where they are not open */
    struct candidate_size wanted;           /* that should reach the error */
    double predicted_error, predicted_work; /* there; infinite work where it cannot be */
    double rounding;                        /* that it leaves, where that is more than the error; else 0 */
    char reason[200];                       /* why it cannot */
};

/* What a forecast is for. */
struct extrapolation_goal {
    const struct experiment *experiment;
    double error;    /* E1 */
    double work_max; /* pairs (candidate.h) that a run may take */
    int unit;        /* candidate_unit */
};

/* Runs the coarse rungs and foretells from them. */
void extrapolation_calibrate(struct extrapolation *c, const struct extrapolation_goal *goal);

/* Where what is wanted lies far beyond the rungs: one more, on the way there.  1 where there is one more. */
int extrapolation_scout(struct extrapolation *c, const struct extrapolation_goal *goal);

/* Takes up what the run *size measured instead of what was foretold, and foretells again. */
void extrapolation_learn(struct extrapolation *c, const struct extrapolation_goal *goal, struct candidate_size size,
                         double foretold, double measured);

/* The finest run, by tenths, that the work and the memory allow and that rounding does not spoil, and what it should
 * reach: *wanted and its forecasts are set to it.  1, or 0 where nothing finer than the rungs can be foretold. */
int extrapolation_finest(struct extrapolation *c, const struct extrapolation_goal *goal);

void extrapolation_rule_out(struct extrapolation *c, const char *reason);

#endif
