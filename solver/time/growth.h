/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_GROWTH_H
#define HEATLADDER_SOLVER_TIME_GROWTH_H

#include "solver/space/operator.h"

/* Rate of the fastest growing mode of dT/dt = A T, s^-1, to a few per cent.  Returns 0 if no mode grows by more than
 * 10 % within `time` (s), or if all weights are >= 0, which excludes growth. bound, s^-1: spectral bound of A
 * (operator_bound).  Wall values and sources do not enter.  Cost: four times the stages of one RKL2 step of length
 * `time`. */
double growth_rate(const struct heat_operator *a, double bound, double time);

/* For real lambda, RKL2 multiplies modes that decay within a step of dt (s) by at most 0.66, because P_s <= 0.3 to
 * the left of its first minimum.  For complex lambda |P_s| > 1, and the factor of s stages is about
 * exp(2 s |Im lambda| / bound) / sqrt(s).  Returns this factor, to a few per cent, for the slowest decaying mode if
 * it is above 0.8; else 0.  Cost: about 25 steps, and never more than `steps` + 5. */
double growth_by_steps(const struct heat_operator *a, double bound, double dt, double steps);

#endif
