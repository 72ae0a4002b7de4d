/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_STATE_H
#define HEATLADDER_SOLVER_SWEEP_STATE_H

#include "solver/space/operator.h"

/* The temperatures that an operator works on: `state` doubles, rows of particles with their ghosts. */

/* Between the n particles' own order and a state. */
void state_load(const struct heat_operator *a, const double *T, double *state);
void state_store(const struct heat_operator *a, const double *state, double *T);
/* The first particle that is not in [lo, hi] (NaN is not), or n. */
size_t state_find_outside(const struct heat_operator *a, const double *state, double lo, double hi);

/* y = rate (A x + g) + self x + old y + start Y0, states all; Y0 may be NULL. */
struct update {
    double rate, self, old, start;
    const double *Y0;
};

/* The updates u[0] .. u[count - 1], one after the other: the first takes x = Y[0] to y = Y[1], the next Y[1] to Y[0]
 * and so on.  Ghosts are refreshed on the way.  The two swap names where count is odd, so that Y[0] is what was
 * written last. */
void state_update(const struct heat_operator *a, const struct update *u, int count, double *Y[2]);

#endif
