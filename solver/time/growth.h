/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_GROWTH_H
#define HEATLADDER_SOLVER_TIME_GROWTH_H

#include "solver/space/operator.h"

/* The rate of the fastest growing mode of dT/dt = A T, s^-1, to some per cent; 0 where none grows by more than a
 * tenth within `time` (s), or weights show that none can (all >= 0).  bound, s^-1: of the spectrum of A
 * (operator_bound). Walls and sources play no part.  Costs four times the stages that RKL2 needs for one step of
 * `time`. */
double growth_rate(const struct heat_operator *a, double bound, double time);

/* RKL2 multiplies what decays within a step of dt (s) by 0.66 or less where the eigenvalue lambda is real, since
 * P_s <= 0.3 left of its first minimum.  Where it is not, |P_s| > 1, and the factor of s stages is some
 * exp(2 s |Im lambda| / bound) / sqrt(s).  Returns the factor, to some per cent, of the mode that decays least so
 * where that is above 0.8; else 0.  Costs some 25 steps, and never more than `steps` and five. */
double growth_by_steps(const struct heat_operator *a, double bound, double dt, double steps);

#endif
