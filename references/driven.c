/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A slab driven periodically at one end (Carslaw and Jaeger 1959, sections 2.6 and 3.6).
 *
 * The drive sends the damped wave F exp(-p x) into the slab.  The far end reflects it with the factor f, the driven
 * end with r:
 *
 *     X = F sum_k (r f)^k (exp(-p (2 k L + x)) + f exp(-p (2 (k + 1) L - x)))
 *       = F exp(-p x) (1 + f exp(-2 p (L - x)))/(1 - r f exp(-2 p L))
 *
 * With r = f = -1 this is F sinh(p (L - x))/sinh(p L).  No exponent is positive, and 1 - exp(-2 u) is evaluated
 * without cancellation.  Since 1 - r f and 1 - exp(-2 p L) have arguments within a right angle of each other, the
 * denominator does not cancel either.  The remainder of the sum after n reflections is at most
 * 2 |F| |r exp(-2 p L)|^n/(1 - |r exp(-2 p L)|). */
#include "references/driven.h"
#include "references/talbot.h"

#include <float.h>
#include <math.h>

double complex driven_at(const struct driven *d, double x, double complex *slope) {
    double y = d->L - x;
    double complex wave = cexp(-d->p * x), there = cexp(-d->p * y), through = cexp(-d->p * d->L);
    double complex less = talbot_one_less(d->p * y, there), more = 1 + there * there;
    double complex whole = talbot_one_less(d->p * d->L, through) + d->loss * through * through;
    *slope = -d->p * d->size * wave * (d->far > 0 ? less : more) / whole;
    return d->size * wave * (d->far > 0 ? more : less) / whole;
}

struct curve driven_now(const struct driven *d, double x, double a, double turns) {
    double complex slope, X = driven_at(d, x, &slope), turn = cos(a) + I * sin(a);
    double rounding = DBL_EPSILON * (30 + 8 * cabs(d->p) * x + 2 * turns);
    return (struct curve){{creal(X * turn), rounding * cabs(X)}, {creal(slope * turn), rounding * cabs(slope)}};
}

struct approx driven_reflected(const struct driven *d, double x, double a, double turns) {
    enum { MOST = 4096 };
    const double damping = creal(d->p), wave_number = cimag(d->p), size = cabs(d->size);
    const double complex r = 1 - d->loss;
    double factor = 1, kept = cabs(r) * exp(-2 * damping * d->L), sum = 0, all = 0;
    a += carg(d->size);
    for (int k = 0; k < MOST && factor > DBL_EPSILON / 16 * (1 - kept); k++, factor *= kept) {
        double there = x, back = 2 * (d->L - x), fall = factor * exp(-damping * x),
               again = fall * exp(-damping * back);
        double phase = a + k * (carg(r) - 2 * wave_number * d->L) - wave_number * there;
        sum += fall * cos(phase) + d->far * again * cos(phase - wave_number * back);
        all += (fall + again) * (30 + 4 * turns + (2 * k + 4) * (4 + 4 * cabs(d->p) * d->L));
    }
    return (struct approx){size * sum, size * (DBL_EPSILON * all + 2 * factor / (1 - kept))};
}
