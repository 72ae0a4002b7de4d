/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An initially warm disc or ball cooled by the surrounding air: disc-cooling and ball-cooling.
 *
 *     rho_c dT/dt = k lap T  in r < R,   k dT/dr = b (T_a - T) at r = R,   T(r, 0) = T0
 *
 * With B = b R/k, s = sqrt(4 k/rho_c t) and the positive roots lambda_n of lambda J_1 = B J_0, for a disc (Carslaw
 * and Jaeger 1959, section 7.7),
 *
 *     series:   T = T_a + (T0 - T_a) sum_n 2 J_1(lambda_n)/(lambda_n (J_0(lambda_n)^2 + J_1(lambda_n)^2))
 *                                          J_0(lambda_n r/R) exp(-(lambda_n s/(2 R))^2)
 *     Laplace:  T = T0 + (T_a - T0) inverse of (1/z) b I_0(q r)/(k q I_1(q R) + b I_0(q R)),   q = sqrt(z rho_c/k)
 *
 * Root n is between root n - 1 of J_1 (0 for n = 1) and root n of J_0.
 *
 * For a ball r T obeys the equation of a rod with b - k/R in place of b (section 9.4).  All formulas remain, with the
 * spherical functions j_0 = sin z/z, j_1 = -j_0', i_0 = sinh z/z and i_1 = i_0': lambda j_1 = B j_0 is lambda cot
 * lambda = 1 - B, with root n between (n - 1) pi and n pi.  There j_0(lambda_n) = (-1)^(n-1)/N, N = sqrt(lambda^2 +
 * (1 - B)^2), so mode n has the coefficient
 *
 *     (integral of r^2 j_0)/(integral of r^2 j_0^2) = (-1)^(n-1) 2 B N/(lambda^2 + B^2 - B)
 *
 * The series is used for s >= R/25, where 110
 * modes leave a truncation error of exp(-41.5), and the transform at earlier times.  The second form is the other
 * one of the two, with up to 600 modes in the series.
 *
 * Restrictions: 1e-12 <= b R/k <= 1e12. */
#include "references/params.h"
#include "references/roots.h"
#include "references/talbot.h"

#include "solver/status.h"
#include "solver/shape.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_sf_bessel.h>

enum { R, K, RHO_C, T0, T_A, B }; /* the scenes' tables begin with these */

enum { MODES = 600 };
static const double early = 0.04, last_exponent = 41.5;

struct shared {
    int is_series, modes;
    double lambda[MODES], size[MODES];
    double complex q[TALBOT_NODES], part[TALBOT_NODES]; /* q R; weight/z b/(k q I_1 + b I_0), scaled by exp(q R) */
    double error[2];                                    /* K, K m^-1 */
};

/* ---- Modified Bessel functions ---- */

/* Scaled modified Bessel functions of a complex argument on Talbot's contour.
 *
 * For |z| <= 30: the mean over tau of exp(z (cos tau - 1)) cos(n tau) by the trapezoidal rule.  Its terms are at
 * most 1; N points give the aliasing error exp(-z) I_(N-n)(z).  For |z| > 30: both parts of Hankel's series
 * (Abramowitz and Stegun 1964, 9.7.1 and 9.2.5).  For Im z >= 0
 *
 *     exp(-z) I_n = (S(-1/z) + i^(1 + 2n) exp(-2 z) S(1/z))/sqrt(2 pi z)
 *
 * and the smallest term of S is below exp(-2 |z|). */

static double complex by_integral(int n, double complex z) {
    enum { N = 96 };
    double complex sum = 0;
    for (int k = 0; k <= N / 2; k++) {
        double tau = 2 * M_PI * k / N, c = cos(tau);
        sum += (k == 0 || k == N / 2 ? 1 : 2) * cexp(z * (c - 1)) * (n ? c : 1);
    }
    return sum / N;
}

static double complex by_hankel(int n, double complex z) {
    enum { TERMS = 22 };
    double complex term = 1, even = 1, odd = 0, second = 0;
    for (int k = 1; k <= TERMS; k++) {
        term *= (4 * n * n - (2 * k - 1) * (2 * k - 1)) / (8.0 * k * z);
        if (k % 2)
            odd += term;
        else
            even += term;
    }
    if (creal(z) < 20) second = (cimag(z) < 0 ? -I : I) * (n ? -1 : 1) * cexp(-2 * z) * (even + odd);
    return (even - odd + second) / csqrt(2 * M_PI * z);
}

/* exp(-z) I_n(z) for n = 0 or 1, Re z >= 0 and |arg z| < 1.4.  Error: about 1e-15 of exp(-z) I_0(z). */
static double complex bessel_scaled(int n, double complex z) {
    return cabs(z) <= 30 ? by_integral(n, z) : by_hankel(n, z);
}

/* ---- The functions of a disc and of a ball ---- */

struct family {
    double (*J[2])(double z);
    double (*end)(int n, int upper); /* bounds of root n */
    double (*size)(int n, double lambda, double biot);
    double complex (*scaled)(int n, double complex z); /* exp(-z) I_n(z) */
};

static double disc_end(int n, int upper) {
    return upper ? gsl_sf_bessel_zero_J0((unsigned)n) : n > 1 ? gsl_sf_bessel_zero_J1((unsigned)n - 1) : 0;
}

/* 2 J_1/(lambda (J_0^2 + J_1^2)).  The condition lambda J_1 = B J_0 eliminates J_0 or J_1, whichever is near its
 * root and would be mostly round-off.  The first root is not near one of J_1. */
static double disc_size(int n, double lambda, double biot) {
    double J0 = gsl_sf_bessel_J0(lambda), J1 = gsl_sf_bessel_J1(lambda), both = lambda * lambda + biot * biot;
    if (biot >= lambda) return 2 * biot / lambda * biot / (J1 * both);
    return n == 1 ? 2 * J1 / (lambda * (J0 * J0 + J1 * J1)) : 2 * biot / (J0 * both);
}

static double ball_end(int n, int upper) {
    return (n - 1 + upper) * M_PI;
}

static double ball_size(int n, double lambda, double biot) {
    return (n % 2 ? 2 : -2) * biot * hypot(lambda, 1 - biot) / (lambda * lambda + biot * (biot - 1));
}

/* i_1 by its power series where its two parts cancel. */
static double complex ball_scaled(int n, double complex z) {
    double complex e = cexp(-z), term = z / 3, sum = term;
    if (n == 0) return z == 0 ? 1 : talbot_one_less(z, e) / (2 * z);
    if (cabs(z) >= 1) return ((1 + e * e) - talbot_one_less(z, e) / z) / (2 * z);
    for (int k = 1; k < 10; k++) sum += term *= z * z / (2 * k * (2 * k + 3));
    return e * sum;
}

static const struct family families[] = {
    {{gsl_sf_bessel_J0, gsl_sf_bessel_J1}, disc_end, disc_size, bessel_scaled},
    {{gsl_sf_bessel_j0, gsl_sf_bessel_j1}, ball_end, ball_size, ball_scaled},
};

static const struct family *family_of(const struct problem *p) {
    return &families[p->dim - 2];
}

/* ---- Both forms ---- */

/* Increases from -B J_0 at a root of J_1 to z J_1 at the next root of J_0; their sign alternates with n. */
struct condition {
    const struct family *f;
    double biot;
    int sign;
};

static double excess(double z, const void *data) {
    const struct condition *c = data;
    return c->sign * (z * c->f->J[1](z) - c->biot * c->f->J[0](z)) / (1 + c->biot);
}

static double root(const struct family *f, int n, double biot) {
    struct condition c = {f, biot, n % 2 ? 1 : -1};
    return roots_increasing(excess, &c, f->end(n, 0), f->end(n, 1));
}

static void prepare_series(const struct problem *p, double s, struct shared *g) {
    const struct family *f = family_of(p);
    const double *v = p->param;
    double scale = fabs(v[T0] - v[T_A]);
    for (int n = 1; n <= MODES; n++) {
        double lambda = root(f, n, v[B] * v[R] / v[K]), exponent = pow(lambda * s / (2 * v[R]), 2);
        if (exponent > last_exponent) break;
        double size = f->size(n, lambda, v[B] * v[R] / v[K]) * exp(-exponent);
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
static void prepare_transform(const struct problem *p, double s, struct shared *g) {
    const struct family *f = family_of(p);
    const double *v = p->param;
    double biot = v[B] * v[R] / v[K], scale = fabs(v[T_A] - v[T0]);
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z, weight;
        talbot_node(j, &z, &weight);
        g->q[j] = csqrt(z) * (2 * v[R] / s);
        g->part[j] =
            weight / z * (v[T_A] - v[T0]) * biot / (g->q[j] * f->scaled(1, g->q[j]) + biot * f->scaled(0, g->q[j]));
    }
    g->error[0] =
        (2e-13 * (p->dim - 1) + 2 * DBL_EPSILON * v[R] / s) * scale + DBL_EPSILON * (fabs(v[T0]) + fabs(v[T_A]));
    g->error[1] = (1e-12 + 4 * DBL_EPSILON * v[R] / s) * scale * fmin(1 / s, v[B] / v[K]) + 4e-16 * scale / s;
}

static struct shared *prepare_form(const struct problem *p, double t, int other) {
    struct shared *g = xcalloc(1, sizeof *g);
    double s = sqrt(4 * p->param[K] / p->param[RHO_C] * t);
    g->is_series = (s >= early * p->param[R]) != other;
    if (t > 0) (g->is_series ? prepare_series : prepare_transform)(p, s, g);
    return g;
}

static void *prepare(const struct problem *p, double t) {
    return prepare_form(p, t, 0);
}

static double sum_series(const struct problem *p, const struct shared *g, double r, double *slope) {
    const struct family *f = family_of(p);
    const double *v = p->param;
    double sum = 0; /* summed without T_a, so that each mode is rounded relative to T0 - T_a */
    for (int n = 0; n < g->modes; n++) {
        double z = g->lambda[n] * r / v[R];
        sum += g->size[n] * f->J[0](z);
        *slope -= g->size[n] * g->lambda[n] / v[R] * f->J[1](z);
    }
    return v[T_A] + sum;
}

static double sum_transform(const struct problem *p, const struct shared *g, double r, double *slope) {
    const struct family *f = family_of(p);
    const double *v = p->param;
    double sum = 0;
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z = g->q[j] * (r / v[R]), rise = g->q[j] * ((v[R] - r) / v[R]),
                       falling = g->part[j] * cexp(-rise);
        if (creal(rise) > 60) continue;
        sum += cimag(falling * f->scaled(0, z));
        *slope += cimag(falling * g->q[j] / v[R] * f->scaled(1, z));
    }
    return v[T0] + sum;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    const struct shared *g = shared;
    const double *v = p->param;
    double r = hypot(x[0], x[1]), slope = 0;
    struct exact e = {.temperature = v[T0], .error_bound = g->error[0]};
    if (p->dim == 3) r = hypot(r, x[2]);
    if (t > 0) e.temperature = (g->is_series ? sum_series : sum_transform)(p, g, r, &slope);
    for (int a = 0; a < p->dim; a++) {
        e.gradient[a] = r > 0 ? slope * x[a] / r : 0;
        e.gradient_bound[a] = g->error[1];
    }
    return e;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    struct shared *g = prepare_form(p, t, 1);
    struct exact e = exact(p, g, x, t);
    free(g);
    return e;
}

static int setup(const struct param *params, int dim, struct problem *p, struct failure *why) {
    static const int any[] = {T0, T_A, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, B, 1e-12 * v[K] / v[R], 1e12 * v[K] / v[R], "b radius/k of 1e-12 to 1e12", why))
        return STATUS_INPUT;
    if (dim == 3)
        shape_make_ball(p, v[R]);
    else
        shape_round(p, 0, v[R]);
    params_material(p, v[K], v[K], v[RHO_C]);
    if (dim == 3) p->material[0].k[2] = v[K];
    p->side[X_HI] = ROBIN;
    p->robin[X_HI] = v[B];
    p->start = v[T0];
    p->held[X_HI] = v[T_A];
    return STATUS_OK;
}

/* ---- The two scenes ---- */

static const struct param disc_params[] = {
    {"radius", 1, "m", "radius of the disc", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1, "J/m^3/K", "heat capacity", NULL},
    {"T0", 1, "K", "initial temperature", NULL},
    {"T_a", 0, "K", "temperature of the air", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int disc_setup(struct problem *p, struct failure *why) {
    return setup(disc_params, 2, p, why);
}

const struct scene scene_disc_cooling = {
    .name = "disc-cooling",
    .about = "an initially warm disc cooled by the surrounding air",
    .citation = "Carslaw and Jaeger 1959, section 7.7",
    .params = disc_params,
    .odd = {{1.3, 0.017, 1.9, 0.97, 0.21, 0.037, 11}, 1, 0.02, 3},
    .setup = disc_setup,
    .prepare = prepare,
    .exact = exact,
    .second = second,
};

static const struct param ball_params[] = {
    {"radius", 1, "m", "radius of the ball", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"T0", 1, "K", "initial temperature", NULL},
    {"T_a", 0, "K", "temperature of the air", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int ball_setup(struct problem *p, struct failure *why) {
    return setup(ball_params, 3, p, why);
}

const struct scene scene_ball_cooling = {
    .name = "ball-cooling",
    .about = "an initially warm ball cooled by the surrounding air",
    .citation = "Carslaw and Jaeger 1959, section 9.4",
    .params = ball_params,
    .odd = {{1.3, 0.017, 1.9, 0.97, 0.21, 0.037, 11}, 1, 0.02, 3},
    .setup = ball_setup,
    .prepare = prepare,
    .exact = exact,
    .second = second,
};
