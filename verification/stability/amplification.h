/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_AMPLIFICATION_H
#define HEATLADDER_VERIFICATION_STABILITY_AMPLIFICATION_H

/* What a stepper makes of dT/dt = lambda T in one step: T -> G(dt lambda) T, from closed forms that share nothing
 * with its updates. */

#include "solver/method.h"

#include <complex.h>

struct amplification {
    enum stepper_name stepper; /* one that has an amplification */
    int stages;                /* where it has them to choose */
};

/* G(z), z = dt lambda, without a unit. */
double complex amplification_factor(const struct amplification *a, double complex z);

/* The stability interval as theory states it: |G| <= 1 for -z in [0, it]. */
double amplification_interval(const struct amplification *a);

/* The largest -z with |G| <= 1 on all of [z, 0]: where |G| = 1. */
double amplification_reach(const struct amplification *a);

/* The largest dt with |G(t lambda)| <= 1 for all t in [0, dt]; 0 where there is none.  reach: amplification_reach(a).
 */
double amplification_limit(const struct amplification *a, double reach, double complex lambda);

#endif
