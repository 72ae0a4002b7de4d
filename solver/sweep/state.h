/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_STATE_H
#define HEATLADDER_SOLVER_SWEEP_STATE_H

#include "solver/sweep/sweep.h"

/* The temperatures as an operator stores them: `state` doubles, rows of particles with their ghosts. */

/* Conversion between the order of the n particles and a state; T may be the start of the state.  Ghosts are 0. */
void state_load(const struct heat_operator *a, const double *T, double *state);
void state_store(const struct heat_operator *a, const double *state, double *T);
/* The first particle outside [lo, hi] (a NaN is outside), or n. */
size_t state_find_outside(const struct heat_operator *a, const double *state, double lo, double hi);

/* Applies the updates u[0] .. u[count - 1] in order: the first from x = Y[0] to y = Y[1], the next from Y[1] to
 * Y[0], and so on, refreshing the ghosts.  If count is odd, Y[0] and Y[1] are exchanged, so that Y[0] is the latest
 * state. */
void state_update(const struct heat_operator *a, const struct update *u, int count, double *Y[2]);

#endif
