/* SPDX-License-Identifier: GPL-3.0-or-later */
/* blast: heat released at a point, on a line or in a plane spreads with k = k_0 T^n behind a sharp front.
 *
 *     rho_c dT/dt = div(k_0 T^n grad T)  on [0, L]^d,   insulated
 *     T = T_c (1 - (r/r_f)^2)^(1/n) for r < r_f, else 0,   r^2 = x^2 (+ y^2 (+ z^2)),
 *     r_f = r0 s^beta,   T_c = T0 s^(-d beta),   s = 1 + t/t0,   beta = 1/(n d + 2),
 *     T0^n = n beta rho_c r0^2/(2 k_0 t0)
 *
 * (Barenblatt 1952; Pattle 1959, Q. J. Mech. Appl. Math. 12:407).  The body is one half, quarter or octant of the
 * whole, since the planes x = 0, y = 0 and z = 0 are planes of symmetry.  The clock starts t0 late, when the front is
 * at r0. The flux -k dT/dr is rho_c T times the velocity beta r/(t + t0) of the points of constant r/r_f, so that
 * each sphere of constant r/r_f keeps its heat: with theta the integral of k, lap theta = -rho_c/r^(d-1) d/dr(r^d
 * beta T/(t + t0)), which is rho_c dT/dt.  n = 5/2 is the conductivity of a plasma (Spitzer and Haerm 1953).  At the
 * front T' is infinite for n > 1 and theta' = 0 for every n.
 *
 * Errors.  With cells or particles dx apart and the mean of k by theta, the layer of O(dx) at the front is off by its
 * own temperature, T_c (dx/r_f)^(1/n), and is a part O(dx/r_f) of the body in any dimension: E1 is of order
 * min(2, 1 + 1/n), 1.4 for n = 5/2; the largest error is of order min(1, 1/n).
 *
 * Second form: r_f from the heat, which is constant, with the integral of the profile by quadrature for end points
 * that are powers (GSL's QAWS); T from the flux, k dT/dr = -rho_c beta r T/(t + t0), whose integral from the front is
 * T^n/n = rho_c beta (r_f^2 - r^2)/(2 k_0 (t + t0)).
 *
 * With r0 > L sqrt(d) the body is behind the front, T is smooth, and the far sides have the exact temperature.
 *
 * Restrictions: the front stays in the body, r_f <= L at the end, or has left it at the start; 1/4 <= n <= 8; T0 from
 * 1e-30 to 1e30 K. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdio.h>

enum { DIM, L, R0, AGE, K_0, N, RHO_C, T_END };

static const struct param params[] = {
    {"dim", 1, "", "1: from a plane, 2: from a line, 3: from a point", NULL},
    {"L", 1, "m", "extent along each axis", NULL},
    {"r0", 0.4, "m", "initial radius of the front", NULL},
    {"t0", 4, "s", "time since the release at the start", NULL},
    {"k_0", 0.02, "W/m/K/K^n", "factor in k = k_0 T^n", NULL},
    {"n", 2.5, "", "exponent in k = k_0 T^n", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"t_end", 20.8, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double beta(const struct problem *p) {
    return 1 / (p->param[N] * p->param[DIM] + 2);
}

/* K */
static double start_centre(const struct problem *p) {
    const double *v = p->param;
    return pow(v[N] * beta(p) * v[RHO_C] * v[R0] * v[R0] / (2 * v[K_0] * v[AGE]), 1 / v[N]);
}

static double front_at(const struct problem *p, double t) {
    return p->param[R0] * pow(1 + t / p->param[AGE], beta(p));
}

static double squared(const struct problem *p, const double *x) {
    double r2 = 0;
    for (int a = 0; a < p->dim; a++) r2 += x[a] * x[a];
    return r2;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, n = v[N], front = front_at(p, t);
    const double centre = start_centre(p) * pow(1 + t / v[AGE], -v[DIM] * beta(p)),
                 u = 1 - squared(p, x) / (front * front);
    const double d = 16 * DBL_EPSILON * (2 - u), T = u > 0 ? centre * pow(u, 1 / n) : 0;
    const double above = centre * pow(fmax(0, u + d), 1 / n), below = centre * pow(fmax(0, u - d), 1 / n);
    struct exact e = {.temperature = T, .error_bound = fmax(above - T, T - below) + 32 * DBL_EPSILON * T};
    for (int a = 0; a < p->dim && u > -d; a++) {
        double steep = 2 * fabs(x[a]) / (n * front * front);
        double slope[3] = {0};
        for (int i = 0; i < 3; i++) {
            double at = u + (i - 1) * d;
            slope[i] = at > 0 ? steep * centre * pow(at, 1 / n - 1) : 0;
        }
        e.gradient[a] = -slope[1];
        e.gradient_bound[a] =
            fmax(fabs(slope[0] - slope[1]), fabs(slope[2] - slope[1])) + 64 * DBL_EPSILON * slope[1];
        if (n > 1 && u <= d) e.gradient_bound[a] = INFINITY;
    }
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX] = {x[0], x[1], x[2]};
    if (p->side[s] == NEUMANN) return 0;
    at[s / 2] = p->hi[s / 2];
    return exact(p, NULL, at, t).temperature;
}

/* dT/dt, by the change of T_c and of r/r_f */
static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    double at[DIM_MAX] = {x[0], x[1], x[2]};
    if (p->side[s] == NEUMANN) return 0;
    at[s / 2] = p->hi[s / 2];
    const double front = front_at(p, t), part = squared(p, at) / (front * front);
    const double of_part = 2 * part / (p->param[N] * (1 - part)) - p->param[DIM];
    return exact(p, NULL, at, t).temperature * beta(p) / (t + p->param[AGE]) * of_part;
}

static int setup(struct problem *p, struct failure *why) {
    const double *v = p->param;
    if (params_start(params, p, NULL, why) || params_whole(params, p, DIM, 1, 3, why)) return STATUS_INPUT;
    if (params_within(params, p, N, 0.25, 8, NULL, why)) return STATUS_INPUT;
    const double T0 = start_centre(p), most = v[K_0] * pow(T0, v[N]);
    if (!(T0 >= 1e-30 && T0 <= 1e30))
        return refuse(why, STATUS_INPUT, "--set k_0=%g: needs a temperature from 1e-30 to 1e30 K at r = 0, not %g K",
                      v[K_0], T0);
    const int left = v[R0] > v[L] * sqrt(v[DIM]);
    if (!left && params_between(params, p, R0, 0, v[L], "the front is in the body, or r0 > L sqrt(dim)", why))
        return STATUS_INPUT;
    const double latest = v[AGE] * (pow(v[L] / v[R0], 1 / beta(p)) - 1);
    if (!left && params_between(params, p, T_END, 0, latest, "the front reaches r = L then", why))
        return STATUS_INPUT;
    p->dim = (int)v[DIM];
    params_material(p, most, most, v[RHO_C]);
    p->material[0].k[2] = most;
    p->k_law = K_POWER;
    p->k_0 = v[K_0], p->k_n = v[N];
    for (int a = 0; a < p->dim; a++) {
        p->hi[a] = v[L];
        p->side[2 * a] = NEUMANN;
        p->side[2 * a + 1] = left ? DIRICHLET : NEUMANN;
    }
    p->initial = initial;
    p->wall = wall;
    if (left) p->wall_rate = wall_rate;
    p->kinked[0] = p->dim == 1 && !left, p->kink[0] = v[R0];
    p->breaks_on_curves = p->dim > 1 && !left;
    return STATUS_OK;
}

static double shell(double s, void *data) {
    const struct problem *p = data;
    return pow(1 + s, 1 / p->param[N]) * pow(s, p->param[DIM] - 1);
}

/* Integral of (1 - s^2)^(1/n) s^(d-1) from 0 to 1. */
static double profile(struct problem *p) {
    enum { PANELS = 100 };
    gsl_integration_workspace *w = gsl_integration_workspace_alloc(PANELS);
    gsl_integration_qaws_table *ends = gsl_integration_qaws_table_alloc(0, 1 / p->param[N], 0, 0);
    gsl_function f = {shell, p};
    double sum = NAN, error;
    gsl_integration_qaws(&f, 0, 1, ends, 0, 1e-13, PANELS, w, &sum, &error);
    gsl_integration_qaws_table_free(ends);
    gsl_integration_workspace_free(w);
    return sum;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    enum { HALVINGS = 200 };
    struct problem copy = *p;
    const double *v = p->param, n = v[N], d = v[DIM], part = profile(&copy), heat = part * start_centre(p);
    const double rise = n * v[RHO_C] * beta(p) / (2 * v[K_0] * (t + v[AGE])); /* T^n = rise (r_f^2 - r^2) */
    double lo = v[R0], hi = v[R0] * (2 + t / v[AGE]);
    for (int i = 0; i < HALVINGS && lo < hi; i++) {
        double front = hi > 2 * lo ? lo * sqrt(hi / lo) : lo + (hi - lo) / 2;
        if (front == lo || front == hi) break;
        *(part * pow(rise * front * front, 1 / n) * pow(front / v[R0], d) < heat ? &lo : &hi) = front;
    }
    double u = hi * hi - squared(p, x), eps = 64 * DBL_EPSILON * hi * hi, T = u > 0 ? pow(rise * u, 1 / n) : 0;
    double apart = fmax(pow(rise * fmax(0, u + eps), 1 / n) - T, T - pow(rise * fmax(0, u - eps), 1 / n));
    return (struct exact){.temperature = T, .error_bound = apart + 64 * DBL_EPSILON * T};
}

const struct scene scene_blast = {
    .name = "blast",
    .about = "heat spreads from a point, a line or a plane with k = k_0 T^n, behind a sharp front",
    .citation = "Barenblatt 1952, Prikl. Mat. Mekh. 16:67; Pattle 1959, Q. J. Mech. Appl. Math. 12:407",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{2, 0.9, 1.7, 5.3, 0.023, 2.7, 1.9, 7}, 1, 0.01, 0.1},
};
