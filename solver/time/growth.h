/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_GROWTH_H
#define HEATLADDER_SOLVER_TIME_GROWTH_H

#include "solver/space/operator.h"

/* The rate of the fastest growing mode of dT/dt = A T, s^-1, to some per cent; 0 where none grows by more than a
 * tenth within `time` (s), or weights show that none can (all >= 0).  bound, s^-1: of the spectrum of A
 * (operator_bound). Walls and sources play no part.  Costs four times the stages that RKL2 needs for one step of
 * `time`. */
double growth_rate(const struct heat_operator *a, double bound, double time);

#endif
