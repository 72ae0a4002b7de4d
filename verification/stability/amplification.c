/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stability intervals, from the amplification factors of the steppers. */
#include "verification/stability/amplification.h"

#include "solver/time/stepper.h"

#include <math.h>

double complex amplification_factor(const struct amplification *a, double complex z) {
    return stepper_of(a->stepper)->amplification(a->stages, z);
}

double amplification_interval(const struct amplification *a) {
    return stepper_of(a->stepper)->interval(a->stages);
}

static int stable(const struct amplification *a, double complex z) {
    return cabs(amplification_factor(a, z)) <= 1 + 1e-12; /* round-off: |G| may reach 1 inside its interval */
}

/* Limit along a ray from 0: steps fine enough for every lobe of P_s, then bisection. */
static double reach_along(const struct amplification *a, double complex direction) {
    double most = 1.5 * amplification_interval(a), step = most / (200 + 20 * a->stages * a->stages), in = 0,
           out = step;
    while (out < most && stable(a, out * direction)) in = out, out += step;
    for (int i = 0; i < 60; i++) {
        double middle = (in + out) / 2;
        *(stable(a, middle * direction) ? &in : &out) = middle;
    }
    return in;
}

double amplification_reach(const struct amplification *a) {
    return reach_along(a, -1);
}

double amplification_limit(const struct amplification *a, double reach, double complex lambda) {
    double size = cabs(lambda), along = creal(lambda);
    if (along >= 0) return 0;
    if (fabs(cimag(lambda)) <= 1e-12 * size) return reach / size;
    if (stepper_of(a->stepper)->order != 1) return reach_along(a, lambda / size) / size;
    return -2 * along / (size * size); /* the circle |1 + z| = 1 */
}
