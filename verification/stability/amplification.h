/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_AMPLIFICATION_H
#define HEATLADDER_VERIFICATION_STABILITY_AMPLIFICATION_H

/* Amplification of dT/dt = lambda T in one step, T -> G(dt lambda) T, from closed forms independent of the steppers'
 * updates. */

#include "solver/method.h"

#include <complex.h>

struct amplification {
    enum stepper_name stepper; /* a stepper with an amplification factor */
    int stages;                /* number of stages, if it can be chosen */
};

/* G(z), z = dt lambda, dimensionless. */
double complex amplification_factor(const struct amplification *a, double complex z);

/* Theoretical stability interval: |G| <= 1 for 0 <= -z <= interval. */
double amplification_interval(const struct amplification *a);

/* The largest -z such that |G| <= 1 on all of [z, 0]. */
double amplification_reach(const struct amplification *a);

/* The largest dt such that |G(t lambda)| <= 1 for all t in [0, dt]; 0 if there is none. reach:
 * amplification_reach(a). */
double amplification_limit(const struct amplification *a, double reach, double complex lambda);

#endif
