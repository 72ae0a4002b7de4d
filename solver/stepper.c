/* Explicit steppers for dT/dt = L(T) = A T + g.
 *
 * euler  T += dt L(T)                                                                         (Song eqs. 31, 37)
 * rk2    H = T + dt/2 L(T),  T += dt L(H): the midpoint rule                                   (Pamplona section 3.3)
 * rkl2   Runge-Kutta-Legendre super-time-stepping with s stages, second order                  (Meyer, Balsara &
 * Aslam 2014, eqs. 16-18): Y_1 = Y_0 + mu~_1 dt L_0, Y_j = mu_j Y_{j-1} + nu_j Y_{j-2} + (1 - mu_j - nu_j) Y_0 +
 * mu~_j dt L(Y_{j-1}) + gamma~_j dt L_0, stable for dt <= (s^2 + s - 2) / (2 |lambda|_max). */
#include "solver/stepper.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int stepper_stages(double dt, double bound) {
    int s = (int)ceil((sqrt(9 + 8 * dt * bound) - 1) / 2 - 1e-9);
    return s < 3 ? 3 : s | 1; /* odd: even counts damp the highest modes less */
}

/* Where a run has left its bounds: its particle, or n. */
static size_t find_escape(const struct march *m, const double *T, size_t n) {
    double half = fmax((m->hi - m->lo) / 2, 1e-6 * fmax(fabs(m->lo), fabs(m->hi)));
    double lo = m->lo - half, hi = m->hi + half;
    for (size_t i = 0; i < n; i++)
        if (!(T[i] >= lo && T[i] <= hi)) return i;
    return n;
}

static int look(const struct march *m, const struct heat_operator *a, const double *state, double *T, long long step,
                struct failure *why) {
    operator_store(a, state, T);
    size_t i = find_escape(m, T, a->n);
    if (i == a->n) return STATUS_OK;
    double dt = m->time / (double)m->steps;
    char where[64] = "";
    if (m->x) snprintf(where, sizeof where, " at (%.6g, %.6g) m", m->x[i], m->y ? m->y[i] : 0);
    return fail(
        why, STATUS_NUMERICAL,
        "unstable: at step %lld of %lld (t = %.6g s) particle %zu%s has %.4g K, the data lie in [%.4g, %.4g] K; "
        "dt = %.6g s is too large",
        step, m->steps, dt * (double)step, i, where, T[i], m->lo, m->hi, dt);
}

static double b_of(int j) { /* b_j of RKL2, with b_0 = b_1 = b_2 */
    j = j < 2 ? 2 : j;
    return (double)(j * j + j - 2) / (2.0 * j * (j + 1));
}

/* One super step: Y[0] holds T on entry and exit. */
static void rkl2_step(const struct heat_operator *a, int s, double dt, double *Y[5]) {
    double *Y0 = Y[0], *L0 = Y[1], *older = Y[2], *newer = Y[3], w1 = 4.0 / ((double)s * s + s - 2);
    operator_update(a, &(struct update){.rate = 1}, Y0, L0);
    operator_update(a, &(struct update){.self = 1}, Y0, older); /* Y_0 */
    operator_update(a, &(struct update){.self = 1, .start_rate = b_of(1) * w1 * dt, .L0 = L0}, Y0, newer);
    for (int j = 2; j <= s; j++) {
        double mu = (2.0 * j - 1) / j * b_of(j) / b_of(j - 1), nu = -(j - 1.0) / j * b_of(j) / b_of(j - 2);
        double gamma = -(1 - b_of(j - 1)) * mu * w1;
        struct update u = {.rate = mu * w1 * dt,
                           .self = mu,
                           .old = nu,
                           .start = 1 - mu - nu,
                           .start_rate = gamma * dt,
                           .Y0 = Y0,
                           .L0 = L0};
        operator_update(a, &u, newer, older);
        double *swap = older;
        older = newer, newer = swap;
    }
    Y[0] = newer, Y[2] = older, Y[3] = Y0;
}

int stepper_arrays(enum stepper stepper) {
    return stepper == STEPPER_RKL2 ? 4 : 2;
}

int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why) {
    int arrays = stepper_arrays(m->stepper), status = STATUS_OK;
    double *Y[5] = {NULL}, dt = m->time / (double)m->steps;
    for (int k = 0; k < arrays; k++) Y[k] = xcalloc(a->state, sizeof *Y[k]);
    *bytes += (size_t)arrays * a->state * sizeof **Y;
    operator_load(a, T, Y[0]);
    for (long long step = 1; step <= m->steps && !status; step++) {
        if (m->stepper == STEPPER_EULER) {
            double part = dt * (step % 2 ? 1 + m->uneven : 1 - m->uneven);
            operator_update(a, &(struct update){.rate = part, .self = 1}, Y[0], Y[1]);
            double *swap = Y[0];
            Y[0] = Y[1], Y[1] = swap;
        } else if (m->stepper == STEPPER_RK2) {
            operator_update(a, &(struct update){.rate = dt / 2, .self = 1}, Y[0], Y[1]);
            operator_update(a, &(struct update){.rate = dt, .old = 1}, Y[1], Y[0]);
        } else {
            rkl2_step(a, m->stages, dt, Y);
        }
        if (step % 32 == 0 || step == m->steps) status = look(m, a, Y[0], T, step, why);
    }
    for (int k = 0; k < arrays; k++) free(Y[k]);
    return status;
}
