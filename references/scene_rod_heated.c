/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-heated: a rod with a uniform source and a given flux at both ends.
 *
 *     rho_c dT/dt = k d2T/dx2 + G  on [0, L],   -k dT/dx = q at x = 0 and q + G L at x = L
 *     T(x, t) = Tm + S(x) + A cos(w x) exp(-k w^2 t/rho_c),   w = mode pi/L
 *     S = -(q (x - L/2) + G (x^2 - L^2/3)/2)/k
 *
 * The heat that enters at x = 0 and that of the source leave at x = L, so that S, with mean 0, is the steady part,
 * and a mode of the insulated rod remains (Carslaw and Jaeger 1959, sections 3.13 and 3.14).  Central differences are
 * exact for S: the error of a correct code is that of the mode.
 *
 * Second form: the mode from its expansion by FFTW; S from its value in the middle, G L^2/(24 k), and the mean of the
 * fluxes there and at x.
 *
 * Restrictions: mode <= 32. */
#include "references/params.h"
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, K, RHO_C, MODE, TM, A, Q, G, T_END };

static const struct param params[] = {
    {"L", 1, "m", "length of the rod, ends at 0 and L", NULL},
    {"k", 0.02, "W/m/K", "conductivity", NULL},
    {"rho_c", 1.6, "J/m^3/K", "heat capacity", NULL},
    {"mode", 2, "", "number of half waves along the rod, an integer", NULL},
    {"Tm", 2, "K", "mean temperature", NULL},
    {"A", 0.6, "K", "initial amplitude of the wave", NULL},
    {"q", 0.011, "W/m^2", "flux into the rod at x = 0", NULL},
    {"G", 0.03, "W/m^3", "source", NULL},
    {"t_end", 2, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double wave_number(const struct problem *p) {
    return p->param[MODE] * M_PI / p->param[L];
}

static double steady(const struct problem *p, double x) {
    const double *v = p->param;
    return -(v[Q] * (x - v[L] / 2) + v[G] * (x * x - v[L] * v[L] / 3) / 2) / v[K];
}

/* Rounding: 4 eps relative in the rate, 2 eps relative in the phase; 4 eps of the largest parts of S. */
static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, w = wave_number(p), rate = fmin(v[K] / v[RHO_C] * w * w * t, 800);
    double amplitude = v[A] * exp(-rate), flux = v[Q] + v[G] * x[0];
    double size = (fabs(v[Q]) + fabs(v[G]) * v[L]) * v[L] / v[K];
    double rounding = DBL_EPSILON * fabs(amplitude) * (4 + 2 * w * fabs(x[0]) + 5 * rate);
    return (struct exact){.temperature = v[TM] + steady(p, x[0]) + amplitude * cos(w * x[0]),
                          .error_bound = rounding + DBL_EPSILON * (fabs(v[TM]) + 4 * size),
                          .gradient = {-flux / v[K] - amplitude * w * sin(w * x[0])},
                          .gradient_bound = {w * rounding + 4 * DBL_EPSILON * size / v[L]}};
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)x, (void)t;
    return s == X_LO ? p->param[Q] : -(p->param[Q] + p->param[G] * p->param[L]);
}

static double source(const struct problem *p, const double *x) {
    (void)x;
    return p->param[G];
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE, TM, A, Q, G, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE, 1, 32, why)) return STATUS_INPUT;
    p->dim = 1;
    p->hi[0] = p->param[L];
    params_material(p, p->param[K], p->param[K], p->param[RHO_C]);
    for (int s = X_LO; s <= Y_HI; s++) p->side[s] = NEUMANN;
    p->initial = initial;
    p->wall = wall;
    if (p->param[G] != 0) p->source = source;
    return STATUS_OK;
}

static double mode(const struct problem *p, const double *x) {
    return p->param[A] * cos(wave_number(p) * x[0]);
}

static struct exact second(const struct problem *p, const double *x, double t) {
    static const int n[2] = {128, 1}; /* four times the highest mode */
    const double *v = p->param, middle = v[L] / 2;
    struct spectral *s = spectral_alloc(p, n, mode);
    struct exact e = spectral_at(s, x, t);
    spectral_free(s);
    double flux = v[Q] + v[G] * (x[0] + middle) / 2; /* the mean from the middle to x */
    e.temperature += v[TM] + v[G] * v[L] * v[L] / (24 * v[K]) - flux * (x[0] - middle) / v[K];
    e.error_bound += 2 * exact(p, NULL, x, t).error_bound;
    return e;
}

const struct scene scene_rod_heated = {
    .name = "rod-heated",
    .about = "a rod with a uniform source and a given flux at both ends: smooth data",
    .citation = "Carslaw and Jaeger 1959, sections 3.13 and 3.14",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 1.7, 3, 2.1, 0.7, 0.0023, -0.0031, 1.9}, 1, 0.02, 0.1},
};
