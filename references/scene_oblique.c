/* SPDX-License-Identifier: GPL-3.0-or-later */
/* oblique: a slab of a crystal with axes oblique to its faces, one insulated and one held.
 *
 *     rho_c dT/dt = k_x T_xx + 2 k_xy T_xy + k_y T_yy  on 0 <= x <= L, periodic along y with the period W,
 *     k_x T_x + k_xy T_y = 0 at x = 0,   T = Tm at x = L
 *
 * With s = y - (k_xy/k_x) x a product X(x) S(s) has the flux -k_x X' S along x, so that an insulated wall is X' = 0
 * and a held one X = 0, and k_xy is left in k_e = k_y - k_xy^2/k_x alone:
 *
 *     T = Tm + A cos(a x) cos(q s + phase) exp(-(k_x a^2 + k_e q^2) t/rho_c),
 *     a = (mode_x - 1/2) pi/L,   q = 2 pi mode_y/W
 *
 * (Carslaw and Jaeger 1959, sections 1.17-20).  At the insulated wall T_x is -(k_xy/k_x) T_y, not 0; at the held wall
 * T_xx is -2 (k_xy/k_x) T_xy, not 0.  The second form is the sum of two plane waves along (a - q k_xy/k_x, q) and
 * (-a - q k_xy/k_x, q), each with the rate of its own q.K q.
 *
 * Restrictions: A < Tm, so that T > 0; modes 1 to 32; k_xy not 0, below sqrt(k_x k_y). */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, W, K_X, K_Y, K_XY, RHO_C, MODE_X, MODE_Y, PHASE, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "thickness of the slab", NULL},
    {"W", 1, "m", "period along y", NULL},
    {"k_x", 0.01, "W/(m K)", "conductivity along x, across the walls", NULL},
    {"k_y", 0.01, "W/(m K)", "conductivity along y", NULL},
    {"k_xy", 0.006, "W/(m K)", "off the diagonal of the tensor, not 0", NULL},
    {"rho_c", 1, "J/(m^3 K)", "heat capacity", NULL},
    {"mode_x", 1, "", "mode across the slab, an integer", NULL},
    {"mode_y", 1, "", "number of waves along y, an integer", NULL},
    {"phase", 0.3, "", "phase of the wave at the origin, rad", NULL},
    {"Tm", 1, "K", "temperature of the held wall", NULL},
    {"A", 0.7, "K", "initial amplitude, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double across(const double *v) {
    return (v[MODE_X] - 0.5) * M_PI / v[L];
}

static double along(const double *v) {
    return 2 * M_PI * v[MODE_Y] / v[W];
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, a = across(v), q = along(v), tilt = v[K_XY] / v[K_X];
    const double rate = (v[K_X] * a * a + (v[K_Y] - v[K_XY] * tilt) * q * q) / v[RHO_C];
    const double gross = (v[K_X] * a * a + 2 * v[K_Y] * q * q) / v[RHO_C], amplitude = v[A] * exp(-rate * t);
    const double phase = q * (x[1] - tilt * x[0]) + v[PHASE], X = cos(a * x[0]), X_x = -a * sin(a * x[0]);
    const double turns = (a + q * fabs(tilt)) * fabs(x[0]) + q * fabs(x[1]) + fabs(v[PHASE]);
    const double rounding = DBL_EPSILON * amplitude * (6 + 3 * turns + 7 * gross * t);
    struct exact e = {.temperature = v[TM] + amplitude * X * cos(phase),
                      .error_bound = rounding + DBL_EPSILON * v[TM]};
    e.gradient[0] = amplitude * (X_x * cos(phase) + X * q * tilt * sin(phase));
    e.gradient[1] = -amplitude * X * q * sin(phase);
    e.gradient_bound[0] = (a + q * fabs(tilt)) * rounding, e.gradient_bound[1] = q * rounding;
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {K_XY, PHASE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    for (int i = MODE_X; i <= MODE_Y; i++)
        if (params_whole(params, p, i, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    if (!(v[K_XY] != 0 && v[K_XY] * v[K_XY] < v[K_X] * v[K_Y]))
        return refuse(why, STATUS_INPUT, "--set k_xy=%g: needs a number between -%g and %g W/(m K) that is not 0",
                      v[K_XY], sqrt(v[K_X] * v[K_Y]), sqrt(v[K_X] * v[K_Y]));
    p->dim = 2;
    params_material(p, v[K_X], v[K_Y], v[RHO_C]);
    p->cross[0] = v[K_XY];
    p->hi[0] = v[L], p->hi[1] = v[W];
    p->side[X_LO] = NEUMANN;
    p->side[X_HI] = DIRICHLET, p->held[X_HI] = v[TM];
    p->side[Y_LO] = p->side[Y_HI] = PERIODIC;
    p->initial = initial;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param, q = along(v);
    double sum = 0, off = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double k = sign * across(v) - q * v[K_XY] / v[K_X], phase = k * x[0] + q * x[1] + v[PHASE];
        const double part[] = {v[K_X] * k * k, 2 * v[K_XY] * k * q, v[K_Y] * q * q};
        const double wave = v[A] / 2 * exp(-(part[0] + part[1] + part[2]) / v[RHO_C] * t);
        sum += wave * cos(phase);
        off += wave * (6 + 3 * (fabs(k * x[0]) + fabs(q * x[1]) + fabs(v[PHASE])) +
                       7 * (part[0] + fabs(part[1]) + part[2]) / v[RHO_C] * t);
    }
    return (struct exact){.temperature = v[TM] + sum, .error_bound = DBL_EPSILON * (v[TM] + off)};
}

const struct scene scene_oblique = {
    .name = "oblique",
    .about = "a slab of a crystal with axes oblique to its faces, one insulated and one held",
    .citation = "Carslaw and Jaeger 1959, sections 1.17-20",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 1.7, 0.017, 0.011, -0.0061, 1.9, 2, 3, 0.37, 1.1, 0.6, 1.4}, 1, 0.01, 0.1},
};
