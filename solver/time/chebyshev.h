/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_CHEBYSHEV_H
#define HEATLADDER_SOLVER_TIME_CHEBYSHEV_H

#include "solver/sweep/state.h"

/* exp(dt L) to rounding, for a spectrum on [-bound, 0] (s^-1). */

/* The longest step (s): rounding then leaves 1e-10 of the data. */
double chebyshev_longest(double bound);

/* Updates that a step of dt (s) takes, at least 2. */
int chebyshev_degree(double dt, double bound);

/* Those updates, into u (degree of them), Y0 aside: of a step from T, the first writes y from x = T, the second reads
 * T as Y0 alone and each of the others x, y and Y0 = T. */
void chebyshev_updates(double dt, double bound, int degree, struct update *u);

#endif
