/* Explicit steppers for dT/dt = L(T) = A T + g.
 *
 * euler  T += dt L(T)                                                                         (Song eqs. 31, 37)
 * rk2    H = T + dt/2 L(T),  T += dt L(H): the midpoint rule                                   (Pamplona section 3.3)
 * rkl2   Runge-Kutta-Legendre super-time-stepping with s stages, second order    (Meyer, Balsara & Aslam 2014, eqs.
 *        16-18):  Y_1 = Y_0 + mu~_1 dt L_0,
 *        Y_j = mu_j Y_{j-1} + nu_j Y_{j-2} + (1 - mu_j - nu_j) Y_0 + mu~_j dt L(Y_{j-1}) + gamma~_j dt L_0,
 *        stable for dt <= (s^2 + s - 2) / (2 |lambda|_max). */
#include "solver/time/stepper.h"
#include "solver/time/state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    TOGETHER = 32, /* updates that the operator is handed at once; steps from look to look */
    SHARED = 10000 /* doubles in a state from which threads pay */
};

int stepper_stages(double dt, double bound) {
    double s = ceil((sqrt(9 + 8 * dt * bound) - 1) / 2 - 1e-9);
    return s < 3                    ? 3
           : s > STEPPER_STAGES_MAX ? STEPPER_STAGES_MAX + 1
                                    : (int)s | 1; /* odd: even counts damp the highest modes less */
}

/* Whether the run has left its bounds. */
static int look(const struct march *m, const struct heat_operator *a, const double *state, long long step,
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
    return refuse(
        why, STATUS_UNSTABLE,
        "unstable: at step %lld of %lld (t = %.6g s) particle %zu%s has %.4g K, the data lie in [%.4g, %.4g] K; "
        "dt = %.6g s is too large",
        step, m->steps, dt * (double)step, i, where, value, m->lo, m->hi, dt);
}

static double b_of(double j) { /* b_j of RKL2, with b_0 = b_1 = b_2 */
    j = j < 2 ? 2 : j;
    return (j * j + j - 2) / (2 * j * (j + 1));
}

/* One super step: Y[0] holds T on entry and exit. */
static void rkl2_step(const struct heat_operator *a, int s, double dt, double *Y[4]) {
    int threads = a->threads > 1 && a->state > SHARED ? a->threads : 1;
    double *Y0 = Y[0], *L0 = Y[1], *turn[2] = {Y[2], Y[3]}, w1 = 4.0 / ((double)s * s + s - 2);
    state_update(a, &(struct update){.rate = 1}, 1, (double *[2]){Y0, L0});
#pragma omp parallel for num_threads(threads)
    for (size_t i = 0; i < a->state; i++) {
        turn[0][i] = Y0[i] + b_of(1) * w1 * dt * L0[i]; /* Y_1 */
        turn[1][i] = Y0[i];
    }
    struct update u[TOGETHER];
    for (int j = 2, n = 0; j <= s; j++) {
        double mu = (2.0 * j - 1) / j * b_of(j) / b_of(j - 1), nu = -(j - 1.0) / j * b_of(j) / b_of(j - 2);
        double gamma = -(1 - b_of(j - 1)) * mu * w1;
        u[n++] = (struct update){.rate = mu * w1 * dt,
                                 .self = mu,
                                 .old = nu,
                                 .start = 1 - mu - nu,
                                 .start_rate = gamma * dt,
                                 .Y0 = Y0,
                                 .L0 = L0};
        if (n < TOGETHER && j < s) continue;
        state_update(a, u, n, turn);
        n = 0;
    }
    Y[0] = turn[0], Y[2] = Y0, Y[3] = turn[1];
}

/* `count` steps that follow step `done`. */
static void euler_steps(const struct heat_operator *a, const struct march *m, long long done, int count,
                        double *Y[]) {
    struct update u[TOGETHER];
    double dt = m->time / (double)m->steps;
    for (int k = 0; k < count; k++)
        u[k] = (struct update){.rate = dt * ((done + k) % 2 ? 1 - m->uneven : 1 + m->uneven), .self = 1};
    state_update(a, u, count, Y);
}

static void rk2_steps(const struct heat_operator *a, const struct march *m, int count, double *Y[]) {
    struct update u[2 * TOGETHER];
    double dt = m->time / (double)m->steps;
    for (int k = 0; k < count; k++) {
        u[2 * k] = (struct update){.rate = dt / 2, .self = 1};
        u[2 * k + 1] = (struct update){.rate = dt, .old = 1};
    }
    state_update(a, u, 2 * count, Y);
}

int stepper_arrays(enum stepper stepper) {
    return stepper == STEPPER_RKL2 ? 4 : 2;
}

int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why) {
    int arrays = stepper_arrays(m->stepper), status = STATUS_OK;
    double *Y[4] = {NULL};
    for (int k = 0; k < arrays; k++) Y[k] = xcalloc(a->state, sizeof *Y[k]);
    *bytes += (size_t)arrays * a->state * sizeof **Y;
    state_load(a, T, Y[0]);
    for (long long done = 0; done < m->steps && !status; done += TOGETHER) {
        int count = m->steps - done < TOGETHER ? (int)(m->steps - done) : TOGETHER;
        if (m->stepper == STEPPER_EULER)
            euler_steps(a, m, done, count, Y);
        else if (m->stepper == STEPPER_RK2)
            rk2_steps(a, m, count, Y);
        else
            for (int k = 0; k < count; k++) rkl2_step(a, m->stages, m->time / (double)m->steps, Y);
        status = look(m, a, Y[0], done + count, why);
    }
    state_store(a, Y[0], T);
    for (int k = 0; k < arrays; k++) free(Y[k]);
    return status;
}
