/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exp(dt A) T by Chebyshev's polynomials, for eigenvalues of A on [-bound, 0].
 *
 * With X = 1 + 2 A/bound, whose eigenvalues lie on [-1, 1], and h = dt bound/2,
 *
 *     exp(dt A) = exp(-h) exp(h X) = c_0 + c_1 T_1(X) + c_2 T_2(X) + ...,    c_k = (2 - [k = 0]) exp(-h) I_k(h),
 *
 * I_k the modified Bessel functions (Tal-Ezer 1989, SIAM J. Sci. Stat. Comput. 10; Bergamaschi & Vianello 2000,
 * Numer. Linear Algebra Appl. 7, 27).  The c_k are positive, add up to 1, and exp(-h) I_k(h) is the probability that
 * two Poisson variables of mean h/2 differ by k: what follows degree K is at most 2 exp(h (sqrt(1 + q^2) - 1 - q
 * asinh q)), q = K/h, by Chernoff's bound, and the degree that leaves a rounding error is some sqrt(75 h): with a
 * step as long as the run it takes the square root of the updates of explicit steps, and no time error is left.
 *
 * Clenshaw's recurrence (1955, Math. Tables Aids Comput. 9, 118) sums them: b_k = c_k T + 2 X b_(k+1) - b_(k+2). Here
 * b_k is divided by s_k = c_k + 2 s_(k+1) - s_(k+2), so that coefficients add up to 1 in every update, walls' values
 * and sources of dT/dt = L(T) = A T + g come in as they do in a step of Euler, and every state stays in the range of
 * the data's modes.  A rounding error delta at k comes out as (k + 1) s_k delta or less: added at random, with c_k a
 * half Gaussian of variance h, 0.2 h^(5/4) delta, which is 1e-10 at h = 2^17. */
#include "solver/time/stepper.h"

#include <math.h>
#include <stdlib.h>

static const double H_MAX = 131072;       /* 2^17 */
static const double H_MIN = 1e-6;         /* a shorter step is one in a wider interval */
static const double REST = 37.4299477502; /* 54 log 2: half of a rounding error */

static double half(double dt, double bound) {
    return fmax(H_MIN, dt * bound / 2);
}

static int degree(double dt, double bound) {
    double h = half(dt, bound), k = fmax(2, floor(sqrt(2 * REST * h))); /* of a Gaussian, whose tail is smaller */
    while (h * (hypot(1, k / h) - 1) - k * asinh(k / h) > -REST) k++;
    return (int)k;
}

/* c_0 .. c_degree from above, where the recurrence of I_k is stable (Miller), in units of the last, some 1e23 at
 * most: steps take ratios of them. */
static void expand(double h, int degree, double *c) {
    c[degree + 1] = 0, c[degree] = 1;
    for (int k = degree; k > 0; k--) c[k - 1] = c[k + 1] + 2 * k / h * c[k];
    c[0] /= 2;
}

/* Of a step from T the first update writes y from x = T, the second reads T as Y0 alone and each of the others x, y
 * and Y0 = T. */
static void updates(double dt, double bound, int degree, struct update *u) {
    double h = half(dt, bound), *c = xcalloc((size_t)degree + 2, sizeof *c), s[3] = {0}; /* s_k, s_(k+1), s_(k+2) */
    expand(h, degree, c);
    s[1] = c[degree];
    for (int k = degree - 1; k >= 0; k--, u++) {
        double twice = k > 0 ? 2 : 1;
        s[0] = c[k] + twice * s[1] - s[2];
        double self = twice * s[1] / s[0], old = -s[2] / s[0], start = c[k] / s[0];
        *u = (struct update){.rate = self * dt / h, .self = self, .old = old, .start = start};
        if (k == degree - 1) u->self += start, u->start = 0; /* b_(k+1) is T */
        if (k == degree - 2) u->start += old, u->old = 0;    /* b_(k+2) is T */
        s[2] = s[1], s[1] = s[0];
    }
    free(c);
}

/* Rounding then leaves 1e-10 of the data. */
static double length(double asked, double time, double bound) {
    return fmin(asked > 0 ? asked : time, 2 * H_MAX / bound);
}

const struct stepper stepper_chebyshev = {
    .name = "chebyshev",
    .about = "exp(tA) by polynomials, to rounding; where two runs do not agree, more steps",
    .arrays = 3,
    .count = degree,
    .length = length,
    .updates = updates};
