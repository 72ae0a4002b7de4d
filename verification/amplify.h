#ifndef HEATLADDER_VERIFICATION_AMPLIFY_H
#define HEATLADDER_VERIFICATION_AMPLIFY_H

/* What a stepper makes of dT/dt = lambda T in one step: T -> G(dt lambda) T, from closed forms that share nothing
 * with solver/stepper.c. */

#include "solver/method.h"

#include <complex.h>

struct amplify {
    enum stepper stepper; /* STEPPER_EULER, STEPPER_RK2 or STEPPER_RKL2 */
    int stages;           /* STEPPER_RKL2 */
};

double complex amplify_factor(const struct amplify *a, double complex z);

/* The stability interval as theory states it: |G| <= 1 for -z in [0, it]. */
double amplify_interval(const struct amplify *a);

/* The largest -z with |G| <= 1 on all of [z, 0]: where |G| = 1 in truth. */
double amplify_reach(const struct amplify *a);

/* The largest dt with |G(t lambda)| <= 1 for all t in [0, dt]; 0 where there is none.  reach: amplify_reach(a). */
double amplify_limit(const struct amplify *a, double reach, double complex lambda);

#endif
