/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plate-cooling: a plate with one hot, one insulated and two cooled sides (NAFEMS T4).
 *
 *     rho_c dT/dt = k (d2T/dx2 + d2T/dy2)  on [0, width] x [0, height],   T = T0 at t = 0
 *     T = T1 at y = 0,   dT/dx = 0 at x = 0,   -k dT/dn = b (T - T_a) at x = width and y = height
 *
 * The benchmark is the steady state at the default parameters: 18.25 K above 0 at (0.6, 0.2) m (The Standard NAFEMS
 * Benchmarks, 1990, test T4; Cameron, Casey, Simpson 1986).  It specifies no heat capacity and no initial data; this
 * scene uses steel and the temperature of the air.  At the defaults the slowest mode decays in 5000 s, and the plate
 * is steady to round-off after 210000 s (--t-end 2.5e5).
 *
 * The solution is the response to the hot side plus the decay of the initial data (cooled_plate.c: early half lines
 * and modes).  The second form is a steady series along x or y minus the double series of the transient.
 * The temperature is continuous at t > 0; its gradient has a logarithmic singularity at
 * (width, 0).
 *
 * Restrictions: isotropic; b >= 0; extents within a factor of 10 of each other. */
#include "references/cooled_plate.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { WIDTH, HEIGHT, K, RHO_C, T1, T0, B, T_A, T_END };

static const struct param params[] = {
    {"width", 0.6, "m", "extent along x, from the insulated side to a cooled one", NULL},
    {"height", 1.0, "m", "extent along y, from the hot side to a cooled one", NULL},
    {"k", 52, "W/m/K", "conductivity", NULL},
    {"rho_c", 3.6e6, "J/m^3/K", "heat capacity", NULL},
    {"T1", 100, "K", "temperature of the side y = 0", NULL},
    {"T0", 0, "K", "initial temperature", NULL},
    {"b", 750, "W/m^2/K", "heat transfer coefficient of the sides x = width and y = height, 0 or more", NULL},
    {"T_a", 0, "K", "temperature of the air", NULL},
    {"t_end", 6000, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T1, T0, B, T_A, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (!(p->param[B] >= 0))
        return refuse(why, STATUS_INPUT, "--set b=%g: needs a finite number, 0 W/m^2/K (insulated) or more",
                      p->param[B]);
    double ratio = p->param[HEIGHT] / p->param[WIDTH];
    if (ratio < 0.1 || ratio > 10)
        return refuse(why, STATUS_INPUT, "--set height=%g: needs %g to %g m, a tenth to ten times the width",
                      p->param[HEIGHT], 0.1 * p->param[WIDTH], 10 * p->param[WIDTH]);
    p->dim = 2;
    p->hi[0] = p->param[WIDTH];
    p->hi[1] = p->param[HEIGHT];
    params_material(p, p->param[K], p->param[K], p->param[RHO_C]);
    p->side[X_LO] = NEUMANN;
    p->side[X_HI] = p->side[Y_HI] = ROBIN;
    p->robin[X_HI] = p->robin[Y_HI] = p->param[B];
    p->start = p->param[T0];
    p->held[Y_LO] = p->param[T1];
    p->held[X_HI] = p->held[Y_HI] = p->param[T_A];
    return STATUS_OK;
}

static double width_at(const double *v, double t) {
    return sqrt(4 * v[K] / v[RHO_C] * t);
}

static void *prepare(const struct problem *p, double t) {
    const double *v = p->param;
    if (t == 0) return NULL;
    return cooled_plate(v[WIDTH], v[HEIGHT], v[B] / v[K], v[T1] - v[T_A], v[T0] - v[T_A], width_at(v, t));
}

static double rounding_of(const double *v) {
    return 2 * DBL_EPSILON * (fabs(v[T1]) + fabs(v[T0]) + fabs(v[T_A]));
}

static void at_points(const struct problem *p, const void *shared, size_t n, const double *const *x, double t,
                      struct exact *e) {
    const double *v = p->param;
    struct surface *T = xcalloc(n, sizeof *T);
    if (t > 0) cooled_plate_at(shared, n, x[0], x[1], T);
    for (size_t i = 0; i < n; i++) {
        e[i] = (struct exact){.temperature = v[T0]};
        if (t == 0) continue;
        e[i] = (struct exact){.temperature = v[T_A] + T[i].at.value,
                              .error_bound = T[i].at.error + rounding_of(v),
                              .gradient = {T[i].slope[0].value, T[i].slope[1].value},
                              .gradient_bound = {T[i].slope[0].error, T[i].slope[1].error}};
    }
    free(T);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    struct exact e;
    at_points(p, shared, 1, (const double *const[]){&x[0], &x[1]}, t, &e);
    return e;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    if (t == 0) return (struct exact){.temperature = v[T0]};
    struct approx T =
        cooled_plate_series(v[WIDTH], v[HEIGHT], v[B] / v[K], v[T1] - v[T_A], v[T0] - v[T_A], width_at(v, t), x);
    return (struct exact){.temperature = v[T_A] + T.value, .error_bound = T.error + rounding_of(v)};
}

const struct scene scene_plate_cooling = {
    .name = "plate-cooling",
    .about = "a plate with one hot, one insulated and two air-cooled sides: NAFEMS T4 and its transient",
    .citation = "NAFEMS benchmark T4 (Cameron, Casey, Simpson 1986); transient from Duhamel's integral and modes",
    .params = params,
    .odd = {{0.53, 0.91, 41, 2.9e6, 83, 29, 630, 7, 5000}, 80, 0.008, 2500},
    .setup = setup,
    .prepare = prepare,
    .exact = exact,
    .at_points = at_points,
    .second = second,
};
