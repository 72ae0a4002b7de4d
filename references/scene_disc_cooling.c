/* SPDX-License-Identifier: GPL-3.0-or-later */
/* disc-cooling: an initially warm disc cooled by the surrounding air.
 *
 *     rho_c dT/dt = k lap T  in r < R,   k dT/dr = b (T_a - T) at r = R,   T(r, 0) = T0
 *
 * With B = b R/k, s = sqrt(4 k/rho_c t) and the positive roots lambda_n of lambda J_1 = B J_0 (Carslaw and Jaeger
 * 1959, section 7.7),
 *
 *     series:   T = T_a + (T0 - T_a) sum_n 2 J_1(lambda_n)/(lambda_n (J_0(lambda_n)^2 + J_1(lambda_n)^2))
 *                                          J_0(lambda_n r/R) exp(-(lambda_n s/(2 R))^2)
 *     Laplace:  T = T0 + (T_a - T0) inverse of (1/z) b I_0(q r)/(k q I_1(q R) + b I_0(q R)),   q = sqrt(z rho_c/k)
 *
 * Root n is between root n - 1 of J_1 (0 for n = 1) and root n of J_0.  The series is used for s >= R/25, where 110
 * modes leave a truncation error of exp(-41.5), and the transform at earlier times.  The second form is the other
 * one of the two, with up to 600 modes in the series.
 *
 * Restrictions: 1e-12 <= b R/k <= 1e12. */
#include "references/bessel.h"
#include "references/params.h"
#include "references/roots.h"
#include "references/talbot.h"

#include "solver/status.h"
#include "solver/shape.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_sf_bessel.h>

enum { R, K, RHO_C, T0, T_A, B, T_END };

static const struct param params[] = {
    {"radius", 1, "m", "radius of the disc", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1, "J/m^3/K", "heat capacity", NULL},
    {"T0", 1, "K", "initial temperature", NULL},
    {"T_a", 0, "K", "temperature of the air", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

enum { MODES = 600 };
static const double early = 0.04, last_exponent = 41.5;

struct shared {
    int is_series, modes;
    double lambda[MODES], size[MODES];
    double complex q[TALBOT_NODES], part[TALBOT_NODES]; /* q R; weight/z b/(k q I_1 + b I_0), scaled by exp(q R) */
    double error[2];                                    /* K, K m^-1 */
};

/* Increases from -B J_0 at a root of J_1 to z J_1 at the next root of J_0; their sign alternates with n. */
struct condition {
    double biot;
    int sign;
};

static double excess(double z, const void *data) {
    const struct condition *c = data;
    return c->sign * (z * gsl_sf_bessel_J1(z) - c->biot * gsl_sf_bessel_J0(z)) / (1 + c->biot);
}

static double root(int n, double biot) {
    struct condition c = {biot, n % 2 ? 1 : -1};
    double lo = n > 1 ? gsl_sf_bessel_zero_J1((unsigned)n - 1) : 0, hi = gsl_sf_bessel_zero_J0((unsigned)n);
    return roots_increasing(excess, &c, lo, hi);
}

/* 2 J_1/(lambda (J_0^2 + J_1^2)).  The condition lambda J_1 = B J_0 eliminates J_0 or J_1, whichever is near its
 * root and would be mostly round-off.  The first root is not near one of J_1. */
static double mode_size(int n, double lambda, double biot) {
    double J0 = gsl_sf_bessel_J0(lambda), J1 = gsl_sf_bessel_J1(lambda), both = lambda * lambda + biot * biot;
    if (biot >= lambda) return 2 * biot / lambda * biot / (J1 * both);
    return n == 1 ? 2 * J1 / (lambda * (J0 * J0 + J1 * J1)) : 2 * biot / (J0 * both);
}

static void prepare_series(const double *v, double s, struct shared *g) {
    double scale = fabs(v[T0] - v[T_A]);
    for (int n = 1; n <= MODES; n++) {
        double lambda = root(n, v[B] * v[R] / v[K]), exponent = pow(lambda * s / (2 * v[R]), 2);
        if (exponent > last_exponent) break;
        double size = mode_size(n, lambda, v[B] * v[R] / v[K]) * exp(-exponent);
        g->lambda[g->modes] = lambda;
        g->size[g->modes++] = (v[T0] - v[T_A]) * size;
        double rounding = DBL_EPSILON * scale * fabs(size) * (12 + 8 * exponent);
        g->error[0] += rounding;
        g->error[1] += rounding * lambda / v[R];
    }
    g->error[0] += DBL_EPSILON * ((1 + g->modes / 2) * scale + fabs(v[T_A]) + fabs(v[T0])) + 1e-17 * scale;
    g->error[1] += 1e-16 * scale / s;
    if (g->modes == MODES) g->error[0] = g->error[1] = INFINITY;
}

/* Rounding of r by eps R changes T by eps R/s of the temperature difference. */
static void prepare_transform(const double *v, double s, struct shared *g) {
    double biot = v[B] * v[R] / v[K], scale = fabs(v[T_A] - v[T0]);
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z, weight;
        talbot_node(j, &z, &weight);
        g->q[j] = csqrt(z) * (2 * v[R] / s);
        g->part[j] = weight / z * (v[T_A] - v[T0]) * biot /
                     (g->q[j] * bessel_scaled(1, g->q[j]) + biot * bessel_scaled(0, g->q[j]));
    }
    g->error[0] = (2e-13 + 2 * DBL_EPSILON * v[R] / s) * scale + DBL_EPSILON * (fabs(v[T0]) + fabs(v[T_A]));
    g->error[1] = (1e-12 + 4 * DBL_EPSILON * v[R] / s) * scale * fmin(1 / s, v[B] / v[K]) + 4e-16 * scale / s;
}

static struct shared *prepare_form(const struct problem *p, double t, int other) {
    struct shared *g = xcalloc(1, sizeof *g);
    double s = sqrt(4 * p->param[K] / p->param[RHO_C] * t);
    g->is_series = (s >= early * p->param[R]) != other;
    if (t > 0) (g->is_series ? prepare_series : prepare_transform)(p->param, s, g);
    return g;
}

static void *prepare(const struct problem *p, double t) {
    return prepare_form(p, t, 0);
}

static double sum_series(const double *v, const struct shared *g, double r, double *slope) {
    double sum = 0; /* summed without T_a, so that each mode is rounded relative to T0 - T_a */
    for (int n = 0; n < g->modes; n++) {
        double z = g->lambda[n] * r / v[R];
        sum += g->size[n] * gsl_sf_bessel_J0(z);
        *slope -= g->size[n] * g->lambda[n] / v[R] * gsl_sf_bessel_J1(z);
    }
    return v[T_A] + sum;
}

static double sum_transform(const double *v, const struct shared *g, double r, double *slope) {
    double sum = 0;
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z = g->q[j] * (r / v[R]), rise = g->q[j] * ((v[R] - r) / v[R]),
                       falling = g->part[j] * cexp(-rise);
        if (creal(rise) > 60) continue;
        sum += cimag(falling * bessel_scaled(0, z));
        *slope += cimag(falling * g->q[j] / v[R] * bessel_scaled(1, z));
    }
    return v[T0] + sum;
}

static struct exact prepared(const struct problem *p, const void *shared, const double x[2], double t) {
    const struct shared *g = shared;
    const double *v = p->param;
    double r = hypot(x[0], x[1]), slope = 0;
    struct exact e = {.temperature = v[T0], .error_bound = g->error[0], .gradient_bound = {g->error[1], g->error[1]}};
    if (t == 0) return e;
    e.temperature = (g->is_series ? sum_series : sum_transform)(v, g, r, &slope);
    for (int a = 0; a < 2 && r > 0; a++) e.gradient[a] = slope * x[a] / r;
    return e;
}

static struct exact second(const struct problem *p, const double x[2], double t) {
    struct shared *g = prepare_form(p, t, 1);
    struct exact e = prepared(p, g, x, t);
    free(g);
    return e;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T0, T_A, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, B, 1e-12 * v[K] / v[R], 1e12 * v[K] / v[R], "b radius/k of 1e-12 to 1e12", why))
        return STATUS_INPUT;
    shape_round(p, 0, v[R]);
    params_material(p, v[K], v[K], v[RHO_C]);
    p->side[X_HI] = ROBIN;
    p->robin[X_HI] = v[B];
    p->start = v[T0];
    p->held[X_HI] = v[T_A];
    return STATUS_OK;
}

const struct scene scene_disc_cooling = {
    .name = "disc-cooling",
    .about = "an initially warm disc cooled by the surrounding air",
    .citation = "Carslaw and Jaeger 1959, section 7.7",
    .params = params,
    .odd = {{1.3, 0.017, 1.9, 0.97, 0.21, 0.037, 11}, 1, 0.02, 3},
    .setup = setup,
    .prepare = prepare,
    .prepared = prepared,
    .second = second,
};
