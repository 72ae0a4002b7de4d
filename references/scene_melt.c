/* SPDX-License-Identifier: GPL-3.0-or-later */
/* melt: a hot wall melts a body, or a cold one freezes it, with a sharp front at the melting point.
 *
 *     rho_c dT/dt = d/dx(k dT/dx) in each phase on [0, L],   T = T_wall at x = 0, T -> T_far as x -> infinity,
 *     T = T_m and k_1 T_x - k_2 T_x = -+ latent ds/dt at x = s(t): - melts (T_wall > T_m > T_far), + freezes
 *
 * (Neumann; Carslaw & Jaeger 1959, section 11.2 II).  Phase 1 is between the wall and the front.  With kappa =
 * k/rho_c, t' = t + t0 and s = 2 lambda sqrt(kappa_1 t'),
 *
 *     T_1 = T_wall + (T_m - T_wall) erf(x/(2 sqrt(kappa_1 t')))/erf(lambda)
 *     T_2 = T_far + (T_m - T_far) erfc(x/(2 sqrt(kappa_2 t')))/erfc(a),   a = lambda sqrt(kappa_1/kappa_2)
 *     k_1 |T_wall - T_m| exp(-lambda^2)/(sqrt(kappa_1) erf(lambda)) - k_2 |T_m - T_far| exp(-a^2)/(sqrt(kappa_2)
 *     erfc(a)) = latent lambda sqrt(pi kappa_1)
 *
 * The left side falls with lambda and the right one grows: one root.  The clock starts t0 late, when the front is at
 * s0; the side x = L has the exact temperature.
 *
 * Errors.  A method by enthalpy has one temperature, T_m, in the cell of the front: T is that of a front up to dx/2
 * away, and its error is of order 1 and depends on the place of the front in its cell.
 *
 * Second form: with x = 2 sqrt(t') u, T_u is -A_i exp(-u^2/kappa_i), by quadrature.  The front is where the heat that
 * entered through the wall, k_1 A_1 sqrt(t'), is the latent and sensible heat of the body.
 *
 * Restrictions: T_m between T_wall and T_far; the front stays in the body; a <= 20, so that erfc is representable. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <gsl/gsl_integration.h>
#include <math.h>

enum { L, S0, K_S, RHO_C_S, K_L, RHO_C_L, LATENT, T_M, T_WALL, T_FAR, T_END };

static const struct param params[] = {
    {"L", 1, "m", "length", NULL},
    {"s0", 0.25, "m", "initial position of the front", NULL},
    {"k_solid", 0.022, "W/m/K", "conductivity of the solid", NULL},
    {"rho_c_solid", 0.9, "J/m^3/K", "heat capacity of the solid", NULL},
    {"k_liquid", 0.012, "W/m/K", "conductivity of the liquid", NULL},
    {"rho_c_liquid", 1.4, "J/m^3/K", "heat capacity of the liquid", NULL},
    {"latent", 1.5, "J/m^3", "latent heat", NULL},
    {"T_melt", 0.3, "K", "melting point", NULL},
    {"T_wall", 1.8, "K", "temperature at x = 0: above T_melt melts, below freezes", NULL},
    {"T_far", -0.4, "K", "temperature far from the wall", NULL},
    {"t_end", 15, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* m^2 s^-1, of the phase at the wall (0) or beyond the front (1) */
static int phase_of(const struct problem *p, int beyond) {
    return (p->param[T_WALL] > p->param[T_M]) != beyond;
}

static double kappa(const struct problem *p, int beyond) {
    const int m = phase_of(p, beyond);
    return p->phase_k[m] / p->phase_rho_c[m];
}

/* W m^-2 s^(1/2): what the fluxes of the front leave over for latent heat, times sqrt(pi t') */
static double excess(const struct problem *p, double lambda) {
    const double *v = p->param, near = sqrt(kappa(p, 0)), far = sqrt(kappa(p, 1)), a = lambda * near / far;
    const double in = p->phase_k[phase_of(p, 0)] * fabs(v[T_WALL] - v[T_M]) * exp(-lambda * lambda) / near;
    const double out = p->phase_k[phase_of(p, 1)] * fabs(v[T_M] - v[T_FAR]) * exp(-a * a) / far;
    return in / erf(lambda) - out / erfc(a) - v[LATENT] * lambda * sqrt(M_PI) * near;
}

/* Lambda by bisection to rounding; the terms of `excess` balance there, so that it is off by a few eps. */
static double find_root(const struct problem *p) {
    enum { HALVINGS = 2000 };
    double lo = 0, hi = 20 * fmin(1, sqrt(kappa(p, 1) / kappa(p, 0)));
    for (int i = 0; i < HALVINGS; i++) {
        double middle = lo + (hi - lo) / 2;
        if (middle == lo || middle == hi) break;
        *(excess(p, middle) > 0 ? &lo : &hi) = middle;
    }
    return hi;
}

/* s^(1/2): sqrt(t + t0) */
static double root_age(const struct problem *p, double t) {
    return sqrt(t + pow(p->param[S0] / (2 * p->root), 2) / kappa(p, 0));
}

static double front_at(const struct problem *p, double t) {
    return 2 * p->root * sqrt(kappa(p, 0)) * root_age(p, t);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, apart = x[0] - front_at(p, t), age = root_age(p, t);
    const int beyond = apart > 0;
    const double width = 2 * sqrt(kappa(p, beyond)) * age, z = x[0] / width;
    const double whole = beyond ? erfc(p->root * sqrt(kappa(p, 0) / kappa(p, 1))) : erf(p->root);
    const double from = beyond ? v[T_FAR] : v[T_WALL], size = fabs(v[T_WALL]) + fabs(v[T_M]) + fabs(v[T_FAR]);
    const double slope = (v[T_M] - from) / whole * M_2_SQRTPI * exp(-z * z) / width * (beyond ? -1 : 1);
    struct exact e = {.temperature = from + (v[T_M] - from) * (beyond ? erfc(z) : erf(z)) / whole,
                      .error_bound = 128 * DBL_EPSILON * size,
                      .gradient = {slope},
                      .gradient_bound = {128 * DBL_EPSILON * (size / width + (1 + z * z) * fabs(slope))}};
    if (fabs(apart) < 128 * DBL_EPSILON * (fabs(x[0]) + v[S0])) e.gradient_bound[0] = INFINITY;
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)x;
    return exact(p, NULL, s == X_LO ? p->lo : p->hi, t).temperature;
}

/* T is a function of x/sqrt(t'). */
static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)x;
    const double *at = s == X_LO ? p->lo : p->hi, age = root_age(p, t);
    return -at[0] / (2 * age * age) * exact(p, NULL, at, t).gradient[0];
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T_M, T_WALL, T_FAR, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (!((v[T_WALL] - v[T_M]) * (v[T_M] - v[T_FAR]) > 0))
        return refuse(why, STATUS_INPUT, "--set T_melt=%g: needs a temperature between T_wall = %g and T_far = %g K",
                      v[T_M], v[T_WALL], v[T_FAR]);
    if (params_between(params, p, S0, 0, v[L], "the front is in the body", why)) return STATUS_INPUT;
    p->dim = 1;
    p->hi[0] = v[L];
    p->k_law = K_PHASES;
    p->k_ref = v[T_M], p->latent = v[LATENT];
    p->phase_k[0] = v[K_S], p->phase_k[1] = v[K_L];
    p->phase_rho_c[0] = v[RHO_C_S], p->phase_rho_c[1] = v[RHO_C_L];
    const int fast = v[K_L] * v[RHO_C_S] > v[K_S] * v[RHO_C_L];
    params_material(p, p->phase_k[fast], p->phase_k[fast], p->phase_rho_c[fast]);
    p->root = find_root(p);
    if (!(excess(p, p->root * 0.999) > 0 && p->root < 19.9 * fmin(1, sqrt(kappa(p, 1) / kappa(p, 0)))))
        return refuse(why, STATUS_INPUT,
                      "--set latent=%g: the front is outside 20 diffusion lengths; use more latent heat", v[LATENT]);
    const double latest = (pow(v[L] / v[S0], 2) - 1) * pow(root_age(p, 0), 2);
    if (params_between(params, p, T_END, 0, latest, "the front reaches x = L then", why)) return STATUS_INPUT;
    p->initial = initial;
    p->kinked[0] = 1, p->kink[0] = v[S0];
    p->wall = wall;
    p->wall_rate = wall_rate;
    return STATUS_OK;
}

/* ---- Second form ---- */

/* exp(-(u^2 - from^2)/kappa), times u if `moment` */
struct integrand {
    double kappa, from;
    int moment;
};

static double bell(double u, void *data) {
    const struct integrand *g = data;
    return (g->moment ? u : 1) * exp(-(u - g->from) * (u + g->from) / g->kappa);
}

/* From lo to hi, or over the seven widths beyond lo. */
static double integral(double kappa_of, double lo, double hi, double from, int moment) {
    enum { PANELS = 50 };
    double sum = NAN, error;
    struct integrand g = {kappa_of, from, moment};
    gsl_function f = {bell, &g};
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(PANELS);
    gsl_integration_qag(&f, lo, fmin(hi, lo + 7 * sqrt(kappa_of)), 0, 2e-14, PANELS, GSL_INTEG_GAUSS41, w, &sum,
                        &error);
    gsl_integration_workspace_free(w);
    return sum;
}

/* J m^-2 s^(-1/2): heat that entered less heat of the body, both in units of sqrt(t'), for a front at u */
static double surplus(const struct problem *p, double u) {
    const double *v = p->param, sign = v[T_WALL] > v[T_M] ? 1 : -1, near = kappa(p, 0), far = kappa(p, 1);
    const double rho_c[2] = {p->phase_rho_c[phase_of(p, 0)], p->phase_rho_c[phase_of(p, 1)]};
    const double A = sign * (v[T_WALL] - v[T_M]) / integral(near, 0, u, 0, 0);
    const double B = sign * (v[T_M] - v[T_FAR]) / integral(far, u, INFINITY, u, 0);
    const double beyond = B * (integral(far, u, INFINITY, u, 1) - u * integral(far, u, INFINITY, u, 0));
    const double body = rho_c[0] * A * integral(near, 0, u, 0, 1) + v[LATENT] * u +
                        rho_c[1] * (sign * (v[T_M] - v[T_FAR]) * u + beyond);
    return p->phase_k[phase_of(p, 0)] * A - 2 * body;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    double lo = 0, hi = 19.9 * sqrt(fmin(kappa(p, 0), kappa(p, 1)));
    for (int i = 0; i < 60; i++) {
        double u = lo + (hi - lo) / 2;
        *(surplus(p, u) > 0 ? &lo : &hi) = u;
    }
    const double front = hi, u = x[0] / (2 * sqrt(t + pow(v[S0] / (2 * front), 2)));
    const int beyond = u > front;
    const double from = beyond ? v[T_FAR] : v[T_WALL], k = kappa(p, beyond);
    double part = beyond ? integral(k, u, INFINITY, front, 0) / integral(k, front, INFINITY, front, 0)
                         : integral(k, 0, u, 0, 0) / integral(k, 0, front, 0, 0);
    if (u == 0) part = 0;
    return (struct exact){.temperature = from + (v[T_M] - from) * part,
                          .error_bound = 1e-12 * (fabs(v[T_WALL]) + fabs(v[T_M]) + fabs(v[T_FAR]))};
}

const struct scene scene_melt = {
    .name = "melt",
    .about = "a wall melts or freezes a rod, with latent heat at a front: Neumann's two-phase Stefan problem",
    .citation = "Carslaw and Jaeger 1959, section 11.2 II",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.37, 0.023, 0.9, 0.014, 1.7, 1.1, 2.3, 0.6, 3.1, 11}, 2, 0.005, 0.1},
};
