/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wave: one oblique wave on a periodic square or cube, which has no walls.
 *
 *     dT/dt = kappa_x d2T/dx2 + kappa_y d2T/dy2  on [0, L]^2, periodic in x and y,
 *     T(x, y, 0) = Tm + A cos(q_x x + q_y y + phase),   q_x = 2 pi mode_x/L,   q_y = 2 pi mode_y/L
 *
 * and with mode_z > 0 the same on [0, L]^3 with kappa_z and q_z = 2 pi mode_z/L.
 *
 * The wave is an eigenfunction of the operator with the eigenvalue -(kappa_x q_x^2 + kappa_y q_y^2 + kappa_z q_z^2):
 *
 *     T = Tm + A cos(q_x x + q_y y + q_z z + phase) exp(-(kappa_x q_x^2 + kappa_y q_y^2 + kappa_z q_z^2) t)
 *
 * (Carslaw and Jaeger 1959, section 2.2).  The second form convolves the initial data with the free-space Gaussian
 * by the trapezoidal rule, without the eigenfunction.
 *
 * Restrictions: A < Tm, so that T > 0; modes 0 to 32, mode_x and mode_y not both 0. */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, KAPPA_X, KAPPA_Y, KAPPA_Z, MODE_X, MODE_Y, MODE_Z, PHASE, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "period along each axis", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.01, "m^2/s", "diffusivity along y", NULL},
    {"kappa_z", 0.01, "m^2/s", "diffusivity along z, if mode_z is positive", NULL},
    {"mode_x", 1, "", "number of waves along x, an integer", NULL},
    {"mode_y", 2, "", "number of waves along y, an integer", NULL},
    {"mode_z", 0, "", "number of waves along z, an integer; 0: a square", NULL},
    {"phase", 0.3, "", "phase of the wave at the origin, rad", NULL},
    {"Tm", 1, "K", "mean temperature", NULL},
    {"A", 0.7, "K", "initial amplitude of the wave, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    double q[DIM_MAX] = {0}, rate = 0, phase = 0, turns = 0;
    for (int a = 0; a < p->dim; a++) {
        q[a] = 2 * M_PI * v[MODE_X + a] / v[L];
        rate += v[KAPPA_X + a] * q[a] * q[a];
        phase += q[a] * x[a];
        turns += q[a] * fabs(x[a]);
    }
    phase += v[PHASE], turns += fabs(v[PHASE]);
    double amplitude = v[A] * exp(-rate * t), rounding = DBL_EPSILON * amplitude * (4 + 3 * turns + 7 * rate * t);
    struct exact e = {.temperature = v[TM] + amplitude * cos(phase), .error_bound = rounding + DBL_EPSILON * v[TM]};
    for (int a = 0; a < p->dim; a++) {
        e.gradient[a] = -amplitude * q[a] * sin(phase);
        e.gradient_bound[a] = q[a] * rounding;
    }
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE_X, MODE_Y, MODE_Z, PHASE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    for (int a = 0; a < 3; a++)
        if (params_whole(params, p, MODE_X + a, 0, 32, why)) return STATUS_INPUT;
    if (v[MODE_X] == 0 && params_whole(params, p, MODE_Y, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = v[MODE_Z] > 0 ? 3 : 2;
    params_material(p, v[KAPPA_X], v[KAPPA_Y], 1);
    if (p->dim == 3) p->material[0].k[2] = v[KAPPA_Z];
    for (int a = 0; a < p->dim; a++) {
        p->hi[a] = v[L];
        p->side[2 * a] = p->side[2 * a + 1] = PERIODIC;
    }
    p->initial = initial;
    return STATUS_OK;
}

/* Weighted mean of the initial data at x + s u by axis, s = sqrt(4 kappa t), with the weight exp(-|u|^2)/pi^(dim/2).
 * The quadrature error of a step du is exp(-(pi/du - q s/2)^2) of the wave: at most exp(-38). */
static struct exact second(const struct problem *p, const double *x, double t) {
    static const double reach = 6.2;                          /* limit of u */
    const double *v = p->param, most = p->dim > 2 ? 7.7 : 19; /* limit of q s */
    const int points = p->dim > 2 ? 40 : 64;
    double s[DIM_MAX], q[DIM_MAX], du = 2 * reach / points, sum = 0, slab = 0, turns = fabs(v[PHASE]);
    int all = 1;
    for (int a = 0; a < p->dim; a++) {
        s[a] = sqrt(4 * v[KAPPA_X + a] * t), q[a] = 2 * M_PI * v[MODE_X + a] / v[L];
        if (q[a] * s[a] > most) return (struct exact){.temperature = NAN, .error_bound = INFINITY};
        turns += q[a] * (fabs(x[a]) + s[a]);
        all *= points;
    }
    for (int k = 0; k < all; k++) {
        double place[DIM_MAX], square = 0;
        for (int a = 0, rest = k; a < p->dim; a++, rest /= points) {
            double u = du * (rest % points + 0.5) - reach;
            place[a] = x[a] + (q[a] > 0 ? s[a] * u : 0);
            square += u * u;
        }
        slab += exp(-square) * (initial(p, place) - v[TM]);
        if ((k + 1) % (points * points)) continue;
        sum += slab, slab = 0;
    }
    double unit = p->dim > 2 ? du / sqrt(M_PI) : 1;
    return (struct exact){.temperature = v[TM] + sum * du * du / M_PI * unit,
                          .error_bound = DBL_EPSILON * (v[A] * (20 + 4 * turns) + 3 * v[TM])};
}

const struct scene scene_wave = {
    .name = "wave",
    .about = "one oblique wave on a periodic square or cube: no walls",
    .citation = "Carslaw and Jaeger 1959, section 2.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 0.011, 0.0083, 2, 1, 0, 0.37, 1.1, 0.6, 1.7}, 1, 0.01, 0.1},
};
