/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exp(dt A) T by Chebyshev polynomials, for eigenvalues of A in [-bound, 0].
 *
 * With X = 1 + 2 A/bound, whose eigenvalues are in [-1, 1], and h = dt bound/2,
 *
 *     exp(dt A) = exp(-h) exp(h X) = c_0 + c_1 T_1(X) + c_2 T_2(X) + ...,    c_k = (2 - [k = 0]) exp(-h) I_k(h),
 *
 * with the modified Bessel functions I_k (Tal-Ezer 1989, SIAM J. Sci. Stat. Comput. 10; Bergamaschi & Vianello
 * 2000, Numer. Linear Algebra Appl. 7, 27).  The c_k are positive and their sum is 1. exp(-h) I_k(h) is the
 * probability that two Poisson variables of mean h/2 differ by k, so by Chernoff's bound the terms beyond degree K
 * sum to at most 2 exp(h (sqrt(1 + q^2) - 1 - q asinh q)), q = K/h.  The truncation error falls to round-off at a
 * degree of about sqrt(75 h).  A single step for the whole run thus needs the square root of the number of updates
 * of explicit steps, and has no time error.
 *
 * Data that change in time are of degree 4 within a step, which gives order 5: there is no other time error.
 *
 * Clenshaw's recurrence (1955, Math. Tables Aids Comput. 9, 118) evaluates the sum: b_k = c_k T + 2 X b_(k+1) -
 * b_(k+2).  Here b_k is divided by s_k = c_k + 2 s_(k+1) - s_(k+2).  The coefficients of every update then sum to 1,
 * wall values and sources of dT/dt = L(T) = A T + g enter as in an Euler step, and every state stays in the range of
 * the data's modes.  A rounding error delta at k contributes at most (k + 1) s_k delta to the result.  Random
 * errors, with c_k a half Gaussian of variance h, add up to 0.2 h^(5/4) delta, which is 1e-10 at h = 2^17. */
#include "solver/time/stepper.h"

#include <math.h>
#include <stdlib.h>

static const double H_MAX = 131072;       /* 2^17 */
static const double H_MIN = 1e-6;         /* a shorter step uses a wider interval */
static const double REST = 37.4299477502; /* 54 log 2: exp(-REST) is half a rounding error */

static double half(double dt, double bound) {
    return fmax(H_MIN, dt * bound / 2);
}

static int degree(double dt, double bound) {
    double h = half(dt, bound), k = fmax(2, floor(sqrt(2 * REST * h))); /* for a Gaussian, whose tail is smaller */
    while (h * (hypot(1, k / h) - 1) - k * asinh(k / h) > -REST) k++;
    return (int)k;
}

/* c_0 .. c_degree by downward recurrence, in which the I_k are stable (Miller), in units of the last.  They reach
 * about 1e23; the steps use only their ratios. */
static void expand(double h, int degree, double *c) {
    c[degree + 1] = 0, c[degree] = 1;
    for (int k = degree; k > 0; k--) c[k - 1] = c[k + 1] + 2 * k / h * c[k];
    c[0] /= 2;
}

/* Updates of one step from T.  The first writes y from x = T, the second reads T as Y0 only, and each later one
 * reads x, y and Y0 = T. */
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

/* Limits the step so that rounding stays below 1e-10 of the data. */
static double length(double asked, double time, double bound) {
    return fmin(asked > 0 ? asked : time, 2 * H_MAX / bound);
}

const struct stepper stepper_chebyshev = {
    .name = "chebyshev",
    .about = "exp(tA) by Chebyshev polynomials, to round-off; use more steps if two runs differ",
    .arrays = 3,
    .degree = 4,
    .count = degree,
    .length = length,
    .updates = updates};
