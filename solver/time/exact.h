/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_EXACT_H
#define HEATLADDER_SOLVER_TIME_EXACT_H

#include "solver/space/operator.h"

/* Whether the walls of a lattice mirror (sign -1 or +1), so that there is a transform; else STATUS_NOT_APPLICABLE. */
int exact_check(const struct lattice *l, struct failure *why);

/* exp(tA) on such a lattice: T, in the particles' order, is taken from 0 to t (s) without any time error. */
void exact_evolve(const struct heat_operator *a, double t, double *T);

#endif
