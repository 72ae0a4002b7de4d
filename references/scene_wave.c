/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wave: one oblique wave on a periodic square, which has no walls.
 *
 *     dT/dt = kappa_x d2T/dx2 + kappa_y d2T/dy2  on [0, L]^2, periodic in x and y,
 *     T(x, y, 0) = Tm + A cos(q_x x + q_y y + phase),   q_x = 2 pi mode_x/L,   q_y = 2 pi mode_y/L
 *
 * The wave is an eigenfunction of the operator with the eigenvalue -(kappa_x q_x^2 + kappa_y q_y^2):
 *
 *     T = Tm + A cos(q_x x + q_y y + phase) exp(-(kappa_x q_x^2 + kappa_y q_y^2) t)
 *
 * (Carslaw and Jaeger 1959, section 2.2).  The second form convolves the initial data with the free-space Gaussian
 * by the trapezoidal rule, without the eigenfunction.
 *
 * Restrictions: A < Tm, so that T > 0; modes 0 to 32, not both 0. */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, KAPPA_X, KAPPA_Y, MODE_X, MODE_Y, PHASE, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "period along x and y", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.01, "m^2/s", "diffusivity along y", NULL},
    {"mode_x", 1, "", "number of waves along x, an integer", NULL},
    {"mode_y", 2, "", "number of waves along y, an integer", NULL},
    {"phase", 0.3, "", "phase of the wave at the origin, rad", NULL},
    {"Tm", 1, "K", "mean temperature", NULL},
    {"A", 0.7, "K", "initial amplitude of the wave, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static struct exact exact(const struct problem *p, const double x[2], double t) {
    const double *v = p->param;
    double q[2] = {2 * M_PI * v[MODE_X] / v[L], 2 * M_PI * v[MODE_Y] / v[L]};
    double rate = v[KAPPA_X] * q[0] * q[0] + v[KAPPA_Y] * q[1] * q[1], phase = q[0] * x[0] + q[1] * x[1] + v[PHASE];
    double amplitude = v[A] * exp(-rate * t);
    double turns = q[0] * fabs(x[0]) + q[1] * fabs(x[1]) + fabs(v[PHASE]);
    double rounding = DBL_EPSILON * amplitude * (4 + 3 * turns + 7 * rate * t);
    return (struct exact){.temperature = v[TM] + amplitude * cos(phase),
                          .error_bound = rounding + DBL_EPSILON * v[TM],
                          .gradient = {-amplitude * q[0] * sin(phase), -amplitude * q[1] * sin(phase)},
                          .gradient_bound = {q[0] * rounding, q[1] * rounding}};
}

static double initial(const struct problem *p, const double x[2]) {
    return exact(p, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE_X, MODE_Y, PHASE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE_X, 0, 32, why) || params_whole(params, p, MODE_Y, 0, 32, why))
        return STATUS_INPUT;
    if (v[MODE_X] == 0 && params_whole(params, p, MODE_Y, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = 2;
    p->hi[0] = p->hi[1] = v[L];
    params_material(p, v[KAPPA_X], v[KAPPA_Y], 1);
    for (int s = X_LO; s <= Y_HI; s++) p->side[s] = PERIODIC;
    p->initial = initial;
    return STATUS_OK;
}

/* Weighted mean of the initial data at (x + s_x u, y + s_y v), s = sqrt(4 kappa t), with the weight
 * exp(-u^2 - v^2)/pi.  The quadrature error of a step du is exp(-(pi/du - q s/2)^2) of the wave. */
static struct exact second(const struct problem *p, const double x[2], double t) {
    enum { POINTS = 64 };
    static const double reach = 6.2, most = 19; /* limits of u and of q s */
    const double *v = p->param;
    double s[2] = {sqrt(4 * v[KAPPA_X] * t), sqrt(4 * v[KAPPA_Y] * t)}, du = 2 * reach / POINTS, sum = 0;
    double q[2] = {2 * M_PI * v[MODE_X] / v[L], 2 * M_PI * v[MODE_Y] / v[L]}, turns = fabs(v[PHASE]);
    for (int a = 0; a < 2; a++) {
        if (q[a] * s[a] > most) return (struct exact){.temperature = NAN, .error_bound = INFINITY};
        turns += q[a] * (fabs(x[a]) + s[a]);
    }
    for (int j = 0; j < POINTS; j++)
        for (int i = 0; i < POINTS; i++) {
            double at[2] = {du * (i + 0.5) - reach, du * (j + 0.5) - reach};
            double place[2] = {x[0] + (q[0] > 0 ? s[0] * at[0] : 0), x[1] + (q[1] > 0 ? s[1] * at[1] : 0)};
            sum += exp(-at[0] * at[0] - at[1] * at[1]) * (initial(p, place) - v[TM]);
        }
    return (struct exact){.temperature = v[TM] + sum * du * du / M_PI,
                          .error_bound = DBL_EPSILON * (v[A] * (20 + 4 * turns) + 3 * v[TM])};
}

const struct scene scene_wave = {
    .name = "wave",
    .about = "one oblique wave on a periodic square: no walls",
    .citation = "Carslaw and Jaeger 1959, section 2.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 0.011, 2, 1, 0.37, 1.1, 0.6, 1.7}, 1, 0.01, 0.1},
};
