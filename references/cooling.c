/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slabs and half lines with a cooled end.
 *
 * Modes: z = q L solves z cot z = -biot or z tan z = biot, with biot = h L.  The equation itself gives sin z and cos
 * z without cancellation near their zeros: sin z cos z = -z biot/(z^2 + biot^2) if the other end is held at zero,
 * and the opposite sign if it is insulated.  The integral of the squared mode is L/2 (1 + biot/(z^2 + biot^2)) in
 * both cases (Carslaw and Jaeger 1959, section 3.9).
 *
 * Half line: T = erf(d/s) + exp(h d + (h s/2)^2) erfc(d/s + h s/2)  (section 2.7).  The second term is evaluated as
 * exp(-(d/s)^2) erfcx(d/s + h s/2), with erfcx(y) = exp(y^2) erfc(y), which does not overflow. */
#include "references/cooling.h"

#include "references/roots.h"

#include <math.h>

struct cooling_mode cooling_mode(int n, int insulated, double L, double h) {
    double biot = h * L, z = roots_cooled(n, insulated, biot), size = hypot(z, biot), sign = n % 2 ? 1 : -1;
    if (z == 0) return (struct cooling_mode){0, L, L, 1}; /* no cooling: the mode is constant */
    struct cooling_mode m = {.q = z / L, .norm = L / 2 * (1 + biot / (size * size))};
    m.end_cosine = insulated ? sign * z / size : -sign * biot / size;
    m.integral = (insulated ? sign * biot / size : 1 - m.end_cosine) / m.q;
    return m;
}

/* Direct for y < 5, where rounding of the exponent costs 25 eps; else by its continued fraction, with an error below
 * eps at 20 levels (Abramowitz and Stegun 1964, 7.1.14). */
double cooling_erfcx(double y) {
    if (y < 5) return exp(y * y) * erfc(y);
    double fraction = y;
    for (int k = 20; k > 0; k--) fraction = y + k / 2.0 / fraction;
    return 1 / (sqrt(M_PI) * fraction);
}

struct cooling_half cooling_half(double d, double h, double s) {
    double z = d / s, fall = exp(-z * z), end = fall * cooling_erfcx(z + h * s / 2);
    return (struct cooling_half){erf(z) + end, h * end, h * (h * s / 2 * end - fall / sqrt(M_PI)), end};
}
