/* Explicit steppers for dT/dt = L(T) = A T + g.
 *
 * euler  T += dt L(T)                                                                         (Song eqs. 31, 37)
 * rk2    H = T + dt/2 L(T),  T += dt L(H): the midpoint rule                                   (Pamplona section 3.3)
 * rkl2   Runge-Kutta-Legendre super-time-stepping with s stages, second order    (Meyer, Balsara & Aslam 2014, eqs.
 *        16-18), stable for dt <= (s^2 + s - 2) / (2 |lambda|_max).
 *
 * RKL2's stages are Y_j = (1 - b_j) Y_0 + b_j u_j with u_j = P_j(1 + w dt L) T, P_j Legendre's polynomial,
 * w = 4 / (s^2 + s - 2) and b_j = (j^2 + j - 2) / (2 j (j + 1)).  For a linear operator the u_j need neither Y_0 nor
 * L(Y_0), but the recurrence of the polynomials alone (source and walls' values are a part of L, since its
 * coefficients add up to 1):
 *        u_j = (2j - 1)/j (u_{j-1} + w dt L(u_{j-1})) - (j - 1)/j u_{j-2},   T becomes (1 - b_s) T + b_s u_s,
 * two states in place of four in each stage.
 *
 * RKL2 multiplies what is stiff by 1 - b_s, a half, a step: what a jump sets in motion takes twenty steps to go,
 * however small the error of each.  Where there is one, two quarters of the first step are taken by Gegenbauer's
 * polynomials with parameter 5/2, of first order, which have no such term (as Rannacher starts the method of Crank
 * and Nicolson by implicit half steps), and its other half by RKL2:
 *        T becomes C_s(1 + w (dt/4) L) T / C_s(1),   w = 6 / (s (s + 5)),
 *        u_n = (2n + 3)/(n + 4) (u_{n-1} + w (dt/4) L(u_{n-1})) - (n - 1)/(n + 4) u_{n-2}.
 * Two steps of error O(dt^2) leave the order at 2: they add (lambda dt)^2 / 64 to RKL2's lambda t (lambda dt)^2 / 18,
 * of the other sign.  |C_s(x) / C_s(1)| falls as 1 / (1 - x^2) away from x = 1, but is 1 at x = -1, so that x stays
 * 12 / s^2 away from -1: stable and damping for dt/4 <= (s^2 + 5s - 6) / (3 |lambda|_max).
 *
 * chebyshev  exp(dt L) to rounding, for a spectrum near the real axis (chebyshev.c) */
#include "solver/time/stepper.h"
#include "solver/time/chebyshev.h"
#include "solver/sweep/state.h"
#include "solver/team.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    TOGETHER = 32, /* updates that the operator is handed at once; steps between checks of the bounds */
    FIRST = 8      /* of one thread, twice: before one is woken, and before others are tried */
};

int stepper_stages(double dt, double bound) {
    double s = ceil((sqrt(9 + 8 * dt * bound) - 1) / 2 - 1e-9);
    return s < 3                    ? 3
           : s > STEPPER_STAGES_MAX ? STEPPER_STAGES_MAX + 1
                                    : (int)s | 1; /* odd: even counts damp the highest modes less */
}

void stepper_start(double dt, double bound, int stages[2]) {
    double s = fmax(2, ceil((sqrt(49 + 3 * dt * bound) - 5) / 2));
    stages[0] = s > STEPPER_STAGES_MAX ? STEPPER_STAGES_MAX + 1 : (int)s;
    stages[1] = stepper_stages(dt / 2, bound);
}

long long stepper_applications(const struct march *m) {
    return m->steps * m->stages + (m->start[0] > 0 ? 2LL * m->start[0] + m->start[1] - m->stages : 0);
}

/* Whether the run has left its bounds. */
static int check_bounds(const struct march *m, const struct heat_operator *a, const double *state, long long step,
                        struct failure *why) {
    double half = fmax((m->hi - m->lo) / 2, 1e-6 * fmax(fabs(m->lo), fabs(m->hi)));
    size_t i = state_find_outside(a, state, m->lo - half, m->hi + half);
    if (i == a->n) return STATUS_OK;
    double dt = m->time / (double)m->steps, *T = xcalloc(a->n, sizeof *T), value;
    char where[64] = "";
    state_store(a, state, T);
    value = T[i];
    free(T);
    if (m->x) snprintf(where, sizeof where, " at (%.6g, %.6g) m", m->x[i], m->y ? m->y[i] : 0);
    const char *reason = m->stepper == STEPPER_CHEBYSHEV ? "a mode grows, or the spectrum is not near the real axis"
                         : dt * m->bound <= 2
                             ? "dt is too large, or a mode grows at any step (heatladder limit tells)"
                             : "dt is too large";
    return refuse(
        why, STATUS_UNSTABLE,
        "unstable: at step %lld of %lld (t = %.6g s) particle %zu%s has %.4g K, the data lie in [%.4g, %.4g] K; "
        "dt = %.6g s: %s",
        step, m->steps, dt * (double)step, i, where, value, m->lo, m->hi, dt, reason);
}

/* One super step: Y[0] holds T on entry and exit.  The first stage and the rest apart, so that T stays for u_2 and
 * for the end. */
static void rkl2_step(const struct heat_operator *a, int s, double dt, double *Y[3]) {
    double all = (double)s * s + s, w = 4 / (all - 2), b = (all - 2) / (2 * all), *T = Y[0], *turn[2] = {Y[1], Y[2]};
    struct update u[TOGETHER];
    state_update(a, &(struct update){.rate = w * dt, .self = 1}, 1, (double *[2]){T, Y[1]});
    for (int j = 2, n = 0; j <= s; j++) {
        double self = (2.0 * j - 1) / j, part = j == s ? b : 1;
        struct update *to = &u[n++];
        *to = (struct update){.rate = part * self * w * dt, .self = part * self, .old = part * (1 - self)};
        if (j == 2) to->start = to->old, to->old = 0, to->Y0 = T; /* u_0 */
        if (j == s) to->start = 1 - b, to->Y0 = T;
        if (n < TOGETHER && j < s) continue;
        state_update(a, u, n, turn);
        n = 0;
    }
    Y[0] = turn[0], Y[1] = turn[1], Y[2] = T;
}

/* A step of first order that damps, by `s` stages: Y[0] holds T on entry and exit. */
static void damping_step(const struct heat_operator *a, int s, double dt, double *Y[2]) {
    struct update u[TOGETHER];
    double w = 6 / ((double)s * (s + 5.0));
    for (int j = 1, n = 0; j <= s; j++) {
        double self = (2.0 * j + 3) / (j + 4);
        u[n++] = (struct update){.rate = self * w * dt, .self = self, .old = 1 - self};
        if (n < TOGETHER && j < s) continue;
        state_update(a, u, n, Y);
        n = 0;
    }
}

static void rkl2_steps(struct heat_operator *a, struct team *team, const struct march *m, long long done, int count,
                       double *Y[3]) {
    double dt = m->time / (double)m->steps;
    for (int k = 0; k < count; k++) {
        if (m->start[0] == 0 || done + k > 0) {
            rkl2_step(a, m->stages, dt, Y);
            a->threads = team_size(team, m->stages);
            continue;
        }
        for (int quarter = 0; quarter < 2; quarter++) damping_step(a, m->start[0], dt / 4, Y);
        rkl2_step(a, m->start[1], dt / 2, Y);
        a->threads = team_size(team, 2 * m->start[0] + m->start[1]);
    }
}

static void chebyshev_step(struct heat_operator *a, struct team *team, const struct march *m, double *Y[3]) {
    double *T = Y[0], *turn[2] = {Y[1], Y[2]};
    struct update *u = xcalloc((size_t)m->stages, sizeof *u);
    chebyshev_updates(m->time / (double)m->steps, m->bound, m->stages, u);
    state_update(a, u, 1, (double *[2]){T, Y[1]});
    for (int k = 1, count; k < m->stages; k += count) {
        count = m->stages - k < TOGETHER ? m->stages - k : TOGETHER;
        for (int n = k; n < k + count; n++) u[n].Y0 = T;
        state_update(a, u + k, count, turn);
        a->threads = team_size(team, count);
    }
    free(u);
    Y[0] = turn[0], Y[1] = turn[1], Y[2] = T;
}

/* `count` steps that follow step `done`. */
static void euler_steps(const struct heat_operator *a, const struct march *m, long long done, int count,
                        double *Y[2]) {
    struct update u[TOGETHER];
    double dt = m->time / (double)m->steps;
    for (int k = 0; k < count; k++)
        u[k] = (struct update){.rate = dt * ((done + k) % 2 ? 1 - m->alternation : 1 + m->alternation), .self = 1};
    state_update(a, u, count, Y);
}

static void rk2_steps(const struct heat_operator *a, const struct march *m, int count, double *Y[2]) {
    struct update u[2 * TOGETHER];
    double dt = m->time / (double)m->steps;
    for (int k = 0; k < count; k++) {
        u[2 * k] = (struct update){.rate = dt / 2, .self = 1};
        u[2 * k + 1] = (struct update){.rate = dt, .old = 1};
    }
    state_update(a, u, 2 * count, Y);
}

int stepper_arrays(enum stepper stepper) {
    return stepper == STEPPER_RKL2 || stepper == STEPPER_CHEBYSHEV ? 3 : 2;
}

int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why) {
    int arrays = stepper_arrays(m->stepper), status = STATUS_OK;
    double *Y[3] = {NULL};
    for (int k = 0; k < arrays; k++) Y[k] = xcalloc(a->state, sizeof *Y[k]);
    if (a->threads > 1) memset(Y[1], 0, a->state * sizeof **Y); /* memory is there when updates are timed */
    *bytes += (size_t)arrays * a->state * sizeof **Y;
    state_load(a, T, Y[0]);
    struct heat_operator own = *a;
    struct team team = team_start(a->threads, (double)(arrays == 3 ? stepper_applications(m) : m->steps));
    own.threads = team_size(&team, 0);
    for (long long done = 0, count; done < m->steps && !status; done += count) {
        count = done < 2 * FIRST ? FIRST : TOGETHER;
        if (count > m->steps - done) count = m->steps - done;
        if (m->stepper == STEPPER_CHEBYSHEV) count = 1;
        if (m->stepper == STEPPER_EULER)
            euler_steps(&own, m, done, (int)count, Y);
        else if (m->stepper == STEPPER_RK2)
            rk2_steps(&own, m, (int)count, Y);
        else if (m->stepper == STEPPER_CHEBYSHEV)
            chebyshev_step(&own, &team, m, Y);
        else
            rkl2_steps(&own, &team, m, done, (int)count, Y);
        if (arrays == 2) own.threads = team_size(&team, (double)count);
        status = check_bounds(m, a, Y[0], done + count, why);
    }
    team_end(&team);
    state_store(a, Y[0], T);
    for (int k = 0; k < arrays; k++) free(Y[k]);
    return status;
}
