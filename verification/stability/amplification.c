/* Amplification factors of the steppers, z = dt lambda:
 *
 *   euler  1 + z                       rk2  1 + z + z^2/2
 *   rkl2   a + b P_s(1 + w z), w = 4/(s^2 + s - 2), b = (s^2 + s - 2)/(2 s (s + 1)), a = 1 - b, with P_s the Legendre
 *          polynomial (Meyer, Balsara & Aslam 2014, eqs. 11, 13, 15)
 *
 * On the real axis |G| <= 1 from 0 to -2, to -2 and at least to -(s^2 + s - 2)/2. */
#include "verification/stability/amplification.h"

#include <math.h>

static double complex legendre(int s, double complex x) {
    double complex older = 1, newer = x;
    for (int j = 2; j <= s; j++) {
        double complex next = ((2 * j - 1) * x * newer - (j - 1) * older) / j;
        older = newer, newer = next;
    }
    return s == 0 ? 1 : newer;
}

double complex amplification_factor(const struct amplification *a, double complex z) {
    if (a->stepper == STEPPER_RK2) return 1 + z + z * z / 2;
    if (a->stepper != STEPPER_RKL2) return 1 + z;
    double s = a->stages, m = s * s + s - 2, b = m / (2 * s * (s + 1));
    return 1 - b + b * legendre(a->stages, 1 + 4 / m * z);
}

double amplification_interval(const struct amplification *a) {
    double s = a->stages;
    return a->stepper == STEPPER_RKL2 ? (s * s + s - 2) / 2 : 2;
}

static int stable(const struct amplification *a, double complex z) {
    return cabs(amplification_factor(a, z)) <= 1 + 1e-12; /* rounding: G touches 1 inside of the interval of RKL2 */
}

/* Along a ray from 0: steps fine enough for every lobe of P_s, then bisection. */
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
    if (a->stepper == STEPPER_RK2 || a->stepper == STEPPER_RKL2) return reach_along(a, lambda / size) / size;
    return -2 * along / (size * size);
}
