/* SPDX-License-Identifier: GPL-3.0-or-later */
/* disc-mode and ball-mode: one mode of a disc or a ball with a Dirichlet, Neumann or Robin wall.
 *
 *     rho_c dT/dt = k lap T  in r < R,   T = Tm + A J(lambda r/R) S at t = 0,
 *     wall = 1 (Dirichlet): T = Tm,   2 (Neumann): k dT/dr = 0,   3 (Robin): k dT/dr = b (Tm - T)  at r = R
 *
 * with J S = J_m cos(m theta) in a disc and j_l Y_lm in a ball.  It is an eigenfunction if lambda is a root of J, of
 * J', or of lambda J' + (b R/k) J (Carslaw and Jaeger 1959, sections 7.6, 7.7, and 9.4 for l = 0; roots.c).  The
 * scenes use the first positive root:
 *
 *     T = Tm + A J(lambda r/R) S exp(-k lambda^2 t/(rho_c R^2))
 *
 * Disc: the second form evaluates J_m by Bessel's integral with the trapezoidal rule and computes its own root from
 * it.
 *
 * Ball: Y_lm = N P_l^m(cos theta) cos(m phi) is the real spherical harmonic without the factor (-1)^m, normalised to
 * 1 over the unit sphere, z = r cos theta.  It is evaluated without angles, and so also at r = 0 and on the axis: r^l
 * Y_lm is the real part of N H_lm, H_lm = (x + i y)^m times a polynomial in z and r^2, with (d/dx + i d/dy) H_lm =
 * -H_(l-1)(m+1), (d/dx - i d/dy) H_lm = (l + m) (l + m - 1) H_(l-1)(m-1) and dH_lm/dz = (l + m) H_(l-1)m (Hobson
 * 1931, section 90), and f_l = j_l(s)/s^l is a power series in s^2 with f_l' = -s f_(l+1).  The second form is a
 * superposition of plane waves over all directions u (Funk and Hecke),
 *
 *     4 pi i^l j_l(q r) Y_lm(x/r) = integral of exp(i q x.u) Y_lm(u) over the unit sphere
 *
 * by a product rule, with GSL's Legendre functions and its own root from Poisson's integral for j_l.
 *
 * Restrictions: A < Tm, so that T > 0 (|J S| <= 1); in a disc m = mode <= 20, in a ball m <= l <= 8; 1e-12 <= b R/k
 * <= 1e12. */
#include "references/params.h"
#include "references/roots.h"

#include "solver/shape.h"
#include "solver/status.h"

#include <complex.h>
#include <float.h>
#include <math.h>

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_legendre.h>

/* DEGREE: waves around a disc, l of a ball.  ORDER: m of a ball.  LAMBDA: computed by setup. */
enum { R, K, RHO_C, DEGREE, TM, A, WALL, B, ORDER, LAMBDA = 10 };

/* First positive root for the wall of the body; J: J_m of a disc, j_l of a ball. */
static double first_root(const struct problem *p, double (*J)(int degree, double z)) {
    const double *v = p->param;
    return roots_round(J, (int)v[DEGREE], p->dim == 3, p->side[X_HI], p->robin[X_HI] * v[R] / v[K]);
}

static int setup(const struct param *table, int dim, int most, double (*J)(int degree, double z), struct problem *p,
                 struct failure *why) {
    static const int any[][4] = {{DEGREE, WALL, -1}, {DEGREE, WALL, ORDER, -1}};
    static const enum side_kind kind[] = {DIRICHLET, NEUMANN, ROBIN};
    const double *v = p->param;
    if (params_start(table, p, any[dim == 3], why)) return STATUS_INPUT;
    if (params_whole(table, p, DEGREE, 0, most, why) || params_whole(table, p, WALL, 1, 3, why)) return STATUS_INPUT;
    if (dim == 3 && params_whole(table, p, ORDER, 0, (int)v[DEGREE], why)) return STATUS_INPUT;
    if (params_between(table, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    if (params_between(table, p, B, 1e-12 * v[K] / v[R], 1e12 * v[K] / v[R], "b radius/k of 1e-12 to 1e12", why))
        return STATUS_INPUT;
    if (dim == 3)
        shape_make_ball(p, v[R]);
    else
        shape_round(p, 0, v[R]);
    params_material(p, v[K], v[K], v[RHO_C]);
    if (dim == 3) p->material[0].k[2] = v[K];
    p->side[X_HI] = kind[(int)v[WALL] - 1];
    p->robin[X_HI] = v[WALL] == 3 ? v[B] : 0;
    p->param[LAMBDA] = first_root(p, J);
    p->held[X_HI] = v[WALL] == 2 ? 0 : v[TM];
    return STATUS_OK;
}

/* ---- A disc ---- */

static const struct param disc_params[] = {
    {"radius", 1, "m", "radius of the disc", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1, "J/m^3/K", "heat capacity", NULL},
    {"mode", 2, "", "number of waves around the disc, an integer", NULL},
    {"Tm", 2, "K", "mean temperature, also that of the wall or the air", NULL},
    {"A", 1, "K", "initial amplitude of the mode, below Tm", NULL},
    {"wall", 1, "", "boundary condition: 1 Dirichlet, 2 Neumann, 3 Robin", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient for wall=3", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* |J_m|, |J_m'| and |z J_m'|/(m + 1) are at most 1.  Errors: a few eps in J_m (GSL), m eps in the phase. */
static struct exact disc_exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    int m = (int)v[DEGREE];
    double unit = v[LAMBDA] / v[R], z = unit * hypot(x[0], x[1]), theta = atan2(x[1], x[0]);
    double decay = v[K] * unit * unit / v[RHO_C] * t, amplitude = v[A] * exp(-decay);
    double J = gsl_sf_bessel_Jn(m, z), above = gsl_sf_bessel_Jn(m + 1, z);
    double below = m > 0 ? gsl_sf_bessel_Jn(m - 1, z) : -above;
    double along = unit * (below - above) / 2 * cos(m * theta);               /* d/dr */
    double across = m > 0 ? -unit * (below + above) / 2 * sin(m * theta) : 0; /* 1/r d/dtheta */
    double rounding = DBL_EPSILON * amplitude * (8 + 4 * m + 8 * decay);
    return (struct exact){.temperature = v[TM] + amplitude * J * cos(m * theta),
                          .error_bound = rounding + DBL_EPSILON * v[TM],
                          .gradient = {amplitude * (along * cos(theta) - across * sin(theta)),
                                       amplitude * (along * sin(theta) + across * cos(theta))},
                          .gradient_bound = {unit * 2 * rounding, unit * 2 * rounding}};
}

static double disc_initial(const struct problem *p, const double *x) {
    return disc_exact(p, NULL, x, 0).temperature;
}

static double bessel(int m, double z) {
    return gsl_sf_bessel_Jn(m, z);
}

/* J_m(z) = mean over tau of cos(m tau - z sin tau).  N points alias J_(N-m)(z), negligible for z + m < N/2. */
static double disc_bessel_integral(int m, double z) {
    enum { N = 128 };
    double sum = 0;
    for (int k = 0; k < N; k++) {
        double tau = 2 * M_PI * k / N;
        sum += cos(m * tau - z * sin(tau));
    }
    return sum / N;
}

static struct exact disc_second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    int m = (int)v[DEGREE];
    double lambda = first_root(p, disc_bessel_integral), z = lambda * hypot(x[0], x[1]) / v[R];
    double decay = v[K] * lambda * lambda / (v[RHO_C] * v[R] * v[R]) * t, amplitude = v[A] * exp(-decay);
    return (struct exact){.temperature = v[TM] + amplitude * disc_bessel_integral(m, z) * cos(m * atan2(x[1], x[0])),
                          .error_bound = DBL_EPSILON * (amplitude * (16 + 8 * m + 32 * decay) + v[TM])};
}

static int disc_setup(struct problem *p, struct failure *why) {
    int status = setup(disc_params, 2, 20, bessel, p, why);
    p->initial = disc_initial;
    return status;
}

const struct scene scene_disc_mode = {
    .name = "disc-mode",
    .about = "one mode of a disc with a Dirichlet, insulated or cooled wall",
    .citation = "Carslaw and Jaeger 1959, sections 7.6 and 7.7",
    .params = disc_params,
    .setup = disc_setup,
    .exact = disc_exact,
    .second = disc_second,
    .odd = {{1.3, 0.017, 1.9, 3, 2.1, 1.2, 3, 0.031, 1.7}, 1, 0.01, 0.1},
};

/* ---- A ball ---- */

static const struct param ball_params[] = {
    {"radius", 1, "m", "radius of the ball", NULL},
    {"k", 0.01, "W/m/K", "conductivity", NULL},
    {"rho_c", 1, "J/m^3/K", "heat capacity", NULL},
    {"l", 2, "", "degree of the spherical harmonic, an integer", NULL},
    {"Tm", 2, "K", "mean temperature, also that of the wall or the air", NULL},
    {"A", 1, "K", "initial amplitude of the mode, below Tm", NULL},
    {"wall", 1, "", "boundary condition: 1 Dirichlet, 2 Neumann, 3 Robin", NULL},
    {"b", 0.02, "W/m^2/K", "heat transfer coefficient for wall=3", NULL},
    {"m", 1, "", "order of the spherical harmonic, an integer up to l", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* r^l P_l^|m| exp(i m phi), by the recurrence of the Legendre functions in l; 0 for l < |m|. */
static double complex solid(int l, int m, const double *x) {
    int order = m < 0 ? -m : m;
    double complex sector = 1;
    double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], before = 0, P = 1;
    if (l < order) return 0;
    for (int k = 1; k <= order; k++) sector *= (2 * k - 1) * (x[0] + (m < 0 ? -I : I) * x[1]);
    for (int k = order + 1; k <= l; k++) {
        double next = ((2 * k - 1) * x[2] * P - (k + order - 1) * square * before) / (k - order);
        before = P, P = next;
    }
    return sector * P;
}

/* f_l(s) = j_l(s)/s^l; below 1 by its power series, at most 1/(2 l + 1)!!. */
static double radial(int l, double s) {
    double term = 1, sum = 1;
    if (s >= 1) return gsl_sf_bessel_jl(l, s) / pow(s, l);
    for (int k = 1; k <= 2 * l + 1; k += 2) term /= k;
    sum = term;
    for (int k = 1; k < 10; k++) sum += term *= -s * s / (2 * k * (2 * (l + k) + 1));
    return sum;
}

/* N, with the integral of Y_lm^2 over the unit sphere equal to 1. */
static double normal(int l, int m) {
    double N = (2 * l + 1) / (m > 0 ? 2 * M_PI : 4 * M_PI);
    for (int k = l - m + 1; k <= l + m; k++) N /= k;
    return sqrt(N);
}

/* d/dx for axis 0, d/dy for 1, d/dz for 2, of the real part of H_lm. */
static double solid_slope(int l, int m, const double *x, int axis) {
    double complex up = -solid(l - 1, m + 1, x), down = (l + m) * (l + m - 1) * solid(l - 1, m - 1, x);
    if (m == 0) down = conj(up);
    return axis == 2 ? (l + m) * creal(solid(l - 1, m, x)) : creal(axis == 0 ? up + down : (up - down) / I) / 2;
}

/* |j_l|, |j_l'| and |Y_lm|/sqrt(l + 1) are at most 1. */
static struct exact ball_exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, unit = v[LAMBDA] / v[R];
    int l = (int)v[DEGREE], m = (int)v[ORDER];
    double at[3] = {x[0] * unit, x[1] * unit, x[2] * unit}, s = hypot(hypot(at[0], at[1]), at[2]);
    double decay = v[K] * unit * unit / v[RHO_C] * t, amplitude = v[A] * exp(-decay) * normal(l, m);
    double f = radial(l, s), change = -radial(l + 1, s), H = creal(solid(l, m, at));
    double rounding = DBL_EPSILON * v[A] * exp(-decay) * (16 + 8 * l + 8 * decay);
    struct exact e = {.temperature = v[TM] + amplitude * f * H, .error_bound = rounding + DBL_EPSILON * v[TM]};
    for (int a = 0; a < 3; a++) {
        e.gradient[a] = amplitude * unit * (f * solid_slope(l, m, at, a) + change * at[a] * H);
        e.gradient_bound[a] = unit * 2 * rounding;
    }
    return e;
}

static double ball_initial(const struct problem *p, const double *x) {
    return ball_exact(p, NULL, x, 0).temperature;
}

enum {
    NODES = 64
}; /* along cos theta and around the axis: exact to degree 63 - l; j_n(lambda) is negligible there */

static double node(size_t i, double *weight) {
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(NODES);
    double mu;
    gsl_integration_glfixed_point(-1, 1, i, &mu, weight, rule);
    gsl_integration_glfixed_table_free(rule);
    return mu;
}

/* The real part of (-i)^l exp(i phase). */
static double plane_wave(int l, double phase) {
    double wave = l % 2 ? sin(phase) : cos(phase);
    return l % 4 < 2 ? wave : -wave;
}

/* 2 i^l j_l(z) = integral of exp(i z mu) P_l(mu) from -1 to 1. */
static double ball_bessel_integral(int l, double z) {
    double sum = 0;
    for (size_t i = 0; i < NODES; i++) {
        double weight, mu = node(i, &weight);
        sum += weight * plane_wave(l, z * mu) * gsl_sf_legendre_Pl(l, mu);
    }
    return sum / 2;
}

static struct exact ball_second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    int l = (int)v[DEGREE], m = (int)v[ORDER];
    double unit = first_root(p, ball_bessel_integral) / v[R], sum = 0;
    for (size_t i = 0; i < NODES; i++) {
        double weight, mu = node(i, &weight), across = sqrt(1 - mu * mu), ring = 0;
        for (int k = 0; k < NODES; k++) {
            double phi = 2 * M_PI * k / NODES;
            double phase = unit * (across * (x[0] * cos(phi) + x[1] * sin(phi)) + mu * x[2]);
            ring += plane_wave(l, phase) * cos(m * phi);
        }
        sum += weight * ring * gsl_sf_legendre_sphPlm(l, m, mu); /* has the factor (-1)^m */
    }
    double decay = v[K] * unit * unit / v[RHO_C] * t, amplitude = v[A] * exp(-decay), Y = m > 0 ? sqrt(2) : 1;
    return (struct exact){.temperature = v[TM] + amplitude * (m % 2 ? -Y : Y) * sum / (2 * NODES),
                          .error_bound = DBL_EPSILON * (amplitude * (32 + 8 * l + 64 * decay) + v[TM])};
}

static int ball_setup(struct problem *p, struct failure *why) {
    int status = setup(ball_params, 3, 8, gsl_sf_bessel_jl, p, why);
    p->initial = ball_initial;
    return status;
}

const struct scene scene_ball_mode = {
    .name = "ball-mode",
    .about = "one mode of a ball with a Dirichlet, insulated or cooled wall",
    .citation = "Carslaw and Jaeger 1959, section 9.4; spherical harmonics: Hobson 1931",
    .params = ball_params,
    .setup = ball_setup,
    .exact = ball_exact,
    .second = ball_second,
    .odd = {{1.3, 0.017, 1.9, 3, 2.1, 1.2, 3, 0.031, 2, 1.7}, 1, 0.01, 0.1},
};
