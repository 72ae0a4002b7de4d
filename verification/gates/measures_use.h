#ifndef HEATLADDER_VERIFICATION_GATES_MEASURES_USE_H
#define HEATLADDER_VERIFICATION_GATES_MEASURES_USE_H

#include "verification/gates/measures.h"

/* Updates of the whole scene over those of the part that is computed for it.  The error beside it: how far the two
 * fields are apart, K. */
void measures_use_fold(const struct request *r, double lo, double hi, struct measured *m);

/* Updates planned over those of the run.  The error beside it: bytes, steps and particles that were planned and are
 * not, or the other way round. */
void measures_use_plan(const struct request *r, double lo, double hi, struct measured *m);

/* E1 of a run from the exact solution in time of the same particles' equations, over the --time-error asked for. */
void measures_use_time_error(const struct request *r, double lo, double hi, struct measured *m);

/* E1 of the run that `choose` proves, over the --error asked for. */
void measures_use_choose(const struct request *r, double lo, double hi, struct measured *m);

/* 1 where a claim's verdict is the expected one; gates.c has a gate for every row of claims.def. */
void measures_use_claim(const struct request *r, double lo, double hi, struct measured *m);

#endif
