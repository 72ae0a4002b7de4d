/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runge-Kutta-Legendre super-time-stepping with s stages, second order (Meyer, Balsara & Aslam 2014, eqs. 16-18),
 * stable for dt <= (s^2 + s - 2) / (2 |lambda|_max).
 *
 * The stages are Y_j = (1 - b_j) Y_0 + b_j u_j with u_j = P_j(1 + w dt L) T, Legendre's polynomial P_j, w = 4 /
 * (s^2 + s - 2) and b_j = (j^2 + j - 2) / (2 j (j + 1)).  For a linear operator the u_j need neither Y_0 nor L(Y_0),
 * only the recurrence of the polynomials (source and wall values are part of L because its coefficients sum to 1):
 *
 *     u_j = (2j - 1)/j (u_{j-1} + w dt L(u_{j-1})) - (j - 1)/j u_{j-2},   T becomes (1 - b_s) T + b_s u_s.
 *
 * Each stage uses two states instead of four.  The time c of stage Y_j is the derivative of its polynomial at 0,
 *
 *     c = (j^2 + j - 2)/(s^2 + s - 2),   of Y_1: 4/(3 (s^2 + s - 2)),
 *
 * and u_j of a linear L has the time c/b_j: in terms of the u_j the method (eq. 17) adds g_0 + (g(c) - g_0)/b_j,
 * which is g(c/b_j) for data linear in time.
 *
 * For an L that is not linear (`stage`), with b_0 = b_1 = b_2 = 1/3,
 *
 *     Y_1 = Y_0 + m_1 dt L_0,   m_1 = w b_1,
 *     Y_j = a_j Y_(j-1) + n_j Y_(j-2) + (1 - a_j - n_j) Y_0 + m_j dt (L_(j-1) - (1 - b_(j-1)) L_0),
 *     a_j = (2j - 1)/j b_j/b_(j-1),   n_j = -(j - 1)/j b_j/b_(j-2),   m_j = w a_j.
 *
 * If L depends on time, t joins the unknowns with the rate 1, and a stage has the time above.  The conditions for
 * order 2 are the same for linear and nonlinear L, so order 2 holds with data that change.
 *
 * RKL2 multiplies stiff modes by only 1 - b_s, one half, per step, so modes excited by a jump need twenty steps to
 * decay, however small the error of each step.  If the data have a jump, the first half of the first step is
 * replaced by two quarter steps with Gegenbauer polynomials of parameter 5/2.  These are first order and have no
 * such term, like the implicit half steps with which Rannacher starts the Crank-Nicolson method:
 *
 *     T becomes C_s(1 + w (dt/4) L) T / C_s(1),   w = 6 / (s (s + 5)),
 *     u_n = (2n + 3)/(n + 4) (u_{n-1} + w (dt/4) L(u_{n-1})) - (n - 1)/(n + 4) u_{n-2}.
 *
 * Two steps with an error O(dt^2) keep second order: they add (lambda dt)^2 / 64 to RKL2's lambda t (lambda dt)^2 /
 * 18, with the opposite sign. |C_s(x) / C_s(1)| decreases as 1 / (1 - x^2) away from x = 1 but is 1 at x = -1, so x
 * stays 12 / s^2 away from -1: stable and damping for dt/4 <= (s^2 + 5s - 6) / (3 |lambda|_max).
 *
 * Amplification factor: 1 - b + b P_s(1 + w z), with w and b = b_s as above (eqs. 11, 13, 15). */
#include "solver/time/stepper.h"

#include <math.h>

/* An odd number of stages; above STEPPER_STAGES_MAX if that many do not suffice. */
static int count(double dt, double bound) {
    double s = ceil((sqrt(9 + 8 * dt * bound) - 1) / 2 - 1e-9);
    return s < 3                    ? 3
           : s > STEPPER_STAGES_MAX ? STEPPER_STAGES_MAX + 1
                                    : (int)s | 1; /* odd: even counts damp the highest modes less */
}

static void first(double dt, double bound, int stages[2]) {
    double s = fmax(2, ceil((sqrt(49 + 3 * dt * bound) - 5) / 2));
    stages[0] = s > STEPPER_STAGES_MAX ? STEPPER_STAGES_MAX + 1 : (int)s;
    stages[1] = count(dt / 2, bound);
}

/* The step length that makes full use of the s^2 stages. */
static double length(double asked, double time, double bound) {
    return asked > 0 ? asked : sqrt(time / bound);
}

static void updates(double dt, double bound, int s, struct update *u) {
    (void)bound;
    double all = (double)s * s + s, w = 4 / (all - 2), b = (all - 2) / (2 * all);
    u[0] = (struct update){.rate = w * dt, .self = 1};
    for (int j = 2; j <= s; j++) {
        double self = (2.0 * j - 1) / j, part = j == s ? b : 1;
        struct update *to = &u[j - 1];
        *to = (struct update){.rate = part * self * w * dt, .self = part * self, .old = part * (1 - self)};
        if (j == 2) to->start = to->old, to->old = 0; /* u_0 */
        if (j == s) to->start = 1 - b;
    }
}

static double b_of(int j) {
    return j < 2 ? 1. / 3 : ((double)j * j + j - 2) / (2 * j * (j + 1.0));
}

static struct stage stage(int s, int j) {
    double all = (double)s * s + s - 2, w = 4 / all;
    if (j == 1) return (struct stage){.rate = w * b_of(1)};
    double a = (2.0 * j - 1) / j * b_of(j) / b_of(j - 1), n = -(j - 1.0) / j * b_of(j) / b_of(j - 2);
    double time = j == 2 ? w * b_of(1) : ((j - 1.0) * (j - 1) + j - 3) / all;
    return (struct stage){.newer = a, .older = n, .rate = w * a, .first = 1 - b_of(j - 1), .time = time};
}

static void damp(double dt, int s, struct update *u) {
    double w = 6 / ((double)s * (s + 5.0));
    for (int j = 1; j <= s; j++) {
        double self = (2.0 * j + 3) / (j + 4);
        u[j - 1] = (struct update){.rate = self * w * dt, .self = self, .old = 1 - self};
    }
}

static double complex legendre(int s, double complex x) {
    double complex older = 1, newer = x;
    for (int j = 2; j <= s; j++) {
        double complex next = ((2 * j - 1) * x * newer - (j - 1) * older) / j;
        older = newer, newer = next;
    }
    return s == 0 ? 1 : newer;
}

static double complex amplification(int stages, double complex z) {
    double s = stages, m = s * s + s - 2, b = m / (2 * s * (s + 1));
    return 1 - b + b * legendre(stages, 1 + 4 / m * z);
}

static double interval(int stages) {
    double s = stages;
    return (s * s + s - 2) / 2;
}

static double error(int stages) {
    double s = stages;
    return stages > 2 ? 1 + 8 / (s * s + s - 2) : 1;
}

const struct stepper stepper_rkl2 = {.name = "rkl2",
                                     .about = "Runge-Kutta-Legendre: s stages for s^2/4 Euler steps",
                                     .order = 2,
                                     .arrays = 3,
                                     .count = count,
                                     .error = error,
                                     .length = length,
                                     .updates = updates,
                                     .stage = stage,
                                     .damped = 7,
                                     .first = first,
                                     .damp = damp,
                                     .amplification = amplification,
                                     .interval = interval};
