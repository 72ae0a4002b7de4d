/* SPDX-License-Identifier: GPL-3.0-or-later */
/* annulus: a ring with a Dirichlet condition on its inner wall and a given flux on its outer wall, both of them
 * functions of the angle.
 *
 *     rho_c dT/dt = k lap T + G  in r1 < r < r2,   T = S at r1,   k dT/dr = k dS/dr at r2,   G = -k lap S,
 *     T(r, theta, 0) = S + A C_m(lambda r) cos(m theta),   S = Tm + B (r/r2)^3 cos(2 theta + phase),
 *     C_m(lambda r) = J_m(lambda r) Y_m(lambda r1) - Y_m(lambda r) J_m(lambda r1),   dC_m/dr = 0 at r2
 *
 * For the first positive lambda, C_m(lambda r) cos(m theta) is an eigenfunction (Carslaw and Jaeger 1959, section
 * 7.10):
 *
 *     T = S + A C_m(lambda r) cos(m theta) exp(-k lambda^2 t/rho_c),   lap S = 5 B r/r2^3 cos(2 theta + phase)
 *
 * In u = ln(r/r1), C'' = (m^2 - lambda^2 r^2) C with C = 0 and C' = -2/pi at u = 0 (the Wronskian of J and Y).  C'
 * is negative up to u if lambda r2 <= m, so the search for lambda starts at m/r2.  The second form integrates this
 * equation by its Taylor series and takes its own lambda from the result.
 *
 * Restrictions: 0.1 <= r1/r2 <= 0.9; mode <= 12; the sum of B and A |C_m(lambda r2)| is below Tm, so that T > 0. */
#include "references/params.h"
#include "references/roots.h"

#include "solver/status.h"
#include "solver/shape.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_sf_bessel.h>

enum { R1, R2, K, RHO_C, TM, B, A, MODE, PHASE, T_END, LAMBDA }; /* LAMBDA: m^-1, computed by setup */

static const struct param params[] = {
    {"r1", 0.4, "m", "radius of the inner wall (Dirichlet)", NULL},
    {"r2", 1, "m", "radius of the outer wall (Neumann)", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"Tm", 2, "K", "mean temperature", NULL},
    {"B", 0.5, "K", "amplitude of the steady part at the outer wall", NULL},
    {"A", 0.7, "K", "initial amplitude of the mode, factor of C_m", NULL},
    {"mode", 3, "", "number of waves around the ring, an integer", NULL},
    {"phase", 0.3, "", "phase of the steady part, rad", NULL},
    {"t_end", 2, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

struct cross {
    double value, slope; /* C, dC/du */
    double size[2];      /* sum of the magnitudes of the terms, for rounding */
};

/* z f' = m f - z f_(m+1) for f = J, Y */
static struct cross cross(int m, double lambda, double r1, double r) {
    double z = lambda * r, J = gsl_sf_bessel_Jn(m, z), Y = gsl_sf_bessel_Yn(m, z);
    double J1 = gsl_sf_bessel_Jn(m, lambda * r1), Y1 = gsl_sf_bessel_Yn(m, lambda * r1);
    double dJ = m * J - z * gsl_sf_bessel_Jn(m + 1, z), dY = m * Y - z * gsl_sf_bessel_Yn(m + 1, z);
    return (struct cross){
        J * Y1 - Y * J1, dJ * Y1 - dY * J1, {fabs(J * Y1) + fabs(Y * J1), fabs(dJ * Y1) + fabs(dY * J1)}};
}

/* The same in steps of u over which m u and lambda r u change by at most 1; the truncation error is 1/24!. */
static struct cross march(int m, double lambda, double r1, double r) {
    enum { ORDER = 24 };
    double end = log(r / r1), c[ORDER + 2] = {0, -2 / M_PI}, size = 0;
    int steps = 1 + (int)ceil(end * fmax(m, lambda * r));
    for (int s = 0; s < steps; s++) {
        double h = end / steps, growth = 1, value = 0, slope = 0, e[ORDER];
        for (int k = 0; k < ORDER; k++, growth *= 2.0 / k) e[k] = growth * pow(lambda * r1 * exp(s * h), 2);
        for (int k = 0; k < ORDER; k++) {
            double sum = m * m * c[k];
            for (int j = 0; j <= k; j++) sum -= e[j] * c[k - j];
            c[k + 2] = sum / ((k + 1) * (k + 2));
        }
        for (int k = ORDER + 1; k >= 0; k--) {
            slope = slope * h + value;
            value = value * h + c[k];
        }
        c[0] = value, c[1] = slope;
        size = fmax(size, fabs(value) + fabs(slope));
    }
    return (struct cross){c[0], c[1], {size, size}};
}

struct condition {
    int m;
    double r1, r2;
    struct cross (*C)(int m, double lambda, double r1, double r);
};

static double slope_at_outer(double lambda, const void *data) {
    const struct condition *c = data;
    return c->C(c->m, lambda, c->r1, c->r2).slope;
}

/* Roots are about pi/(r2 - r1) apart; steps of half a radian find the first one. */
static double first_root(const struct problem *p, struct cross (*C)(int m, double lambda, double r1, double r)) {
    const double *v = p->param;
    struct condition c = {(int)v[MODE], v[R1], v[R2], C};
    double step = 0.5 / (v[R2] - v[R1]), lo = fmax(c.m, 1e-3) / v[R2], hi = lo + step;
    while (slope_at_outer(hi, &c) < 0) lo = hi, hi += step;
    return roots_increasing(slope_at_outer, &c, lo, hi);
}

static double steady(const double *v, double r, double theta) {
    return v[TM] + v[B] * pow(r / v[R2], 3) * cos(2 * theta + v[PHASE]);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    int m = (int)v[MODE];
    double r = hypot(x[0], x[1]), theta = atan2(x[1], x[0]), decay = v[K] / v[RHO_C] * v[LAMBDA] * v[LAMBDA] * t;
    struct cross C = cross(m, v[LAMBDA], v[R1], r);
    double amplitude = v[A] * exp(-decay), cubic = v[B] * pow(r / v[R2], 3);
    double along = amplitude * C.slope * cos(m * theta) + 3 * cubic * cos(2 * theta + v[PHASE]); /* r d/dr */
    double across = -amplitude * m * C.value * sin(m * theta) - 2 * cubic * sin(2 * theta + v[PHASE]);
    double most = fmax(C.size[0], C.size[1]);
    double rounding = DBL_EPSILON * amplitude * (12 + 4 * m + 8 * decay) * C.size[0];
    double slope_rounding = DBL_EPSILON * amplitude * (16 + 8 * m + 8 * decay) * (m + 1) * most;
    double cubic_rounding = DBL_EPSILON * fabs(cubic) * (8 + fabs(v[PHASE]));
    double gradient_bound = (slope_rounding + 4 * cubic_rounding) / r;
    return (struct exact){
        .temperature = steady(v, r, theta) + amplitude * C.value * cos(m * theta),
        .error_bound = rounding + cubic_rounding + 2 * DBL_EPSILON * v[TM],
        .gradient = {(along * cos(theta) - across * sin(theta)) / r, (along * sin(theta) + across * cos(theta)) / r},
        .gradient_bound = {gradient_bound, gradient_bound}};
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    const double *v = p->param;
    double theta = atan2(x[1], x[0]);
    return s == X_LO ? steady(v, v[R1], theta) : 3 * v[K] * v[B] / v[R2] * cos(2 * theta + v[PHASE]);
}

static double source(const struct problem *p, const double *x) {
    const double *v = p->param;
    double r = hypot(x[0], x[1]) / v[R2];
    return -5 * v[K] * v[B] / (v[R2] * v[R2]) * r * cos(2 * atan2(x[1], x[0]) + v[PHASE]);
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {B, MODE, PHASE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_within(params, p, R1, 0.1 * v[R2], 0.9 * v[R2], "r1 of 0.1 r2 to 0.9 r2", why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE, 0, 12, why) || params_between(params, p, PHASE, -100, 100, NULL, why))
        return STATUS_INPUT;
    if (params_between(params, p, B, -v[TM], v[TM], "the temperature stays positive, |B| < Tm", why))
        return STATUS_INPUT;
    p->param[LAMBDA] = first_root(p, cross);
    double most = (v[TM] - fabs(v[B])) / fabs(cross((int)v[MODE], v[LAMBDA], v[R1], v[R2]).value);
    if (params_between(params, p, A, 0, most, "the temperature stays positive", why)) return STATUS_INPUT;
    shape_round(p, v[R1], v[R2]);
    params_material(p, v[K], v[K], v[RHO_C]);
    p->side[X_LO] = DIRICHLET;
    p->side[X_HI] = NEUMANN;
    p->initial = initial;
    p->wall = wall;
    p->source = source;
    return STATUS_OK;
}

/* cos(2 theta + phase) r^2 is a polynomial in x and y. */
static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    int m = (int)v[MODE];
    double lambda = first_root(p, march), r = hypot(x[0], x[1]), decay = v[K] / v[RHO_C] * lambda * lambda * t;
    double amplitude = v[A] * exp(-decay), R = v[R2];
    double part = (x[0] - x[1]) * (x[0] + x[1]) * cos(v[PHASE]) - 2 * x[0] * x[1] * sin(v[PHASE]);
    struct cross C = r > v[R1] ? march(m, lambda, v[R1], r) : (struct cross){0};
    return (struct exact){
        .temperature = v[TM] + v[B] * r / R * part / (R * R) + amplitude * C.value * cos(m * atan2(x[1], x[0])),
        .error_bound =
            DBL_EPSILON * (amplitude * (64 + 16 * m + 64 * decay) * fmax(1, C.size[0]) + 16 * fabs(v[B]) + v[TM])};
}

const struct scene scene_annulus = {
    .name = "annulus",
    .about = "a ring with a varying temperature on its concave wall and a varying flux on its convex wall",
    .citation = "Carslaw and Jaeger 1959, section 7.10, with a steady part from a source",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.5, 1.3, 0.017, 1.9, 2.1, 0.6, 0.7, 2, 0.37, 1.7}, 1, 0.01, 0.1},
};
