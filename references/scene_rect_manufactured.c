/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rect-manufactured: a rectangle in which every term of the equation is active: source, anisotropy, varying wall
 * temperatures and fluxes.
 *
 *     rho_c dT/dt = k_x d2T/dx2 + k_y d2T/dy2 + G(x, y)  on [0, width] x [0, height]
 *
 * Source and walls follow from a chosen solution (method of manufactured solutions, Roache 2002):
 *
 *     T(x, y, t) = S(x, y) + Z(x, y) exp(-lambda t)
 *     S = 1 + 1/2 exp(0.8 x/width) cos(1.1 y/height + 0.4)                            K
 *     Z = A sin(2 pi x/width) cos(pi y/height)                                        K
 *     lambda = (k_x (2 pi/width)^2 + k_y (pi/height)^2)/rho_c
 *     G = -(k_x S_xx + k_y S_yy) = ((1.1/height)^2 k_y - (0.8/width)^2 k_x)(S - 1)     W m^-3
 *
 * The eigenfunction Z vanishes on the x sides and has zero slope on the y sides, so the boundary data are those of S
 * and steady: T = S on the x sides, the flux k_y dS/dn on the y sides.  S is not a polynomial, so no operator is
 * exact for it by accident.  At the defaults Z decays to 0.35 of its initial amplitude.  Initial and boundary data
 * are compatible, corners included: the solution is smooth everywhere.
 *
 * With `rise` r > 0 the source depends on time, and T has the additional part
 *
 *     r t R(x),  R = sin(pi x/width) - 1/10 sin(3 pi x/width) >= 0
 *     G has the additional terms r (rho_c R - k_x t R_xx)
 *
 * This part is linear in t, so the error of a first-order time step in it comes only from the time at which G is
 * evaluated.  R is not an eigenfunction.  A shifted evaluation of G therefore leaves an error r (R - exp(tL) R),
 * which differs in shape from dT/dt = r R, the error of a shifted end time.
 *
 * The second form evolves T(0) - S by FFTW, without Z or lambda, and the additional part of G by Duhamel's integral
 * with Gauss quadrature.
 *
 * Restrictions: |A| <= 1 and r >= 0, so that T > 0. */
#include "references/params.h"
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <gsl/gsl_integration.h>
#include <math.h>

enum { WIDTH, HEIGHT, K_X, K_Y, RHO_C, A, RISE, T_END };

static const struct param params[] = {
    {"width", 1.0, "m", "extent along x, between two Dirichlet walls", NULL},
    {"height", 0.7, "m", "extent along y, between two Neumann walls", NULL},
    {"k_x", 0.02, "W/m/K", "conductivity along x", NULL},
    {"k_y", 0.005, "W/m/K", "conductivity along y", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"A", 0.8, "K", "amplitude of the decaying part, up to 1", NULL},
    {"rise", 0, "K/s", "rate of a part linear in time; if positive, the source depends on time", NULL},
    {"t_end", 2, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static const double rate_x = 0.8, rate_y = 1.1, phase_y = 0.4; /* constants of S */

static double steady(const struct problem *p, const double *x) {
    return 1 + 0.5 * exp(rate_x * x[0] / p->param[WIDTH]) * cos(rate_y * x[1] / p->param[HEIGHT] + phase_y);
}

/* dS/dy, K/m */
static double slope_y(const struct problem *p, const double *x) {
    double b = rate_y / p->param[HEIGHT];
    return -0.5 * b * exp(rate_x * x[0] / p->param[WIDTH]) * sin(b * x[1] + phase_y);
}

/* Derivative of R of that order, 0 to 2, times width^order. */
static double shape(const struct problem *p, const double *x, int order) {
    double a = M_PI * x[0] / p->param[WIDTH];
    if (order == 1) return M_PI * (cos(a) - 0.3 * cos(3 * a));
    return order == 0 ? sin(a) - 0.1 * sin(3 * a) : M_PI * M_PI * (0.9 * sin(3 * a) - sin(a));
}

static double source(const struct problem *p, const double *x) {
    const double *v = p->param, a = rate_x / v[WIDTH], b = rate_y / v[HEIGHT];
    double kept = (b * b * v[K_Y] - a * a * v[K_X]) * (steady(p, x) - 1);
    return v[RISE] > 0 ? kept + v[RISE] * v[RHO_C] * shape(p, x, 0) : kept;
}

static double source_rate(const struct problem *p, const double *x) {
    const double *v = p->param;
    return -v[RISE] * v[K_X] * shape(p, x, 2) / (v[WIDTH] * v[WIDTH]);
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    double at[2] = {x[0], x[1]};
    at[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
    if (s == X_LO || s == X_HI) return steady(p, at);
    return p->param[K_Y] * (s == Y_LO ? -slope_y(p, at) : slope_y(p, at));
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, q = 2 * M_PI / v[WIDTH], r = M_PI / v[HEIGHT];
    double lambda = (v[K_X] * q * q + v[K_Y] * r * r) / v[RHO_C],
           exponent = fmin(lambda * t, 800); /* exp(-800) = 0 */
    double amplitude = v[A] * exp(-exponent);
    double rounding = amplitude * (6 + 2 * q * fabs(x[0]) + 2 * r * fabs(x[1]) + 6 * exponent);
    double S = steady(p, x), slope_x = rate_x / v[WIDTH] * (S - 1), risen = v[RISE] * t;
    double shape_T = risen > 0 ? risen * shape(p, x, 0) : 0, shape_x = risen > 0 ? risen * shape(p, x, 1) : 0;
    return (struct exact){.temperature = S + amplitude * sin(q * x[0]) * cos(r * x[1]) + shape_T,
                          .error_bound = DBL_EPSILON * (8 + rounding + 12 * risen),
                          .gradient = {slope_x + amplitude * q * cos(q * x[0]) * cos(r * x[1]) + shape_x / v[WIDTH],
                                       slope_y(p, x) - amplitude * r * sin(q * x[0]) * sin(r * x[1])},
                          .gradient_bound = {DBL_EPSILON * ((12 + 80 * risen) / v[WIDTH] + q * rounding),
                                             DBL_EPSILON * (16 / v[HEIGHT] + r * rounding)}};
}

static double initial(const struct problem *p, const double *x) {
    const double *v = p->param, q = 2 * M_PI / v[WIDTH], r = M_PI / v[HEIGHT];
    return steady(p, x) + v[A] * sin(q * x[0]) * cos(r * x[1]);
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {RISE, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_within(params, p, A, 0, 1, "the temperature stays positive, 0 < A <= 1", why)) return STATUS_INPUT;
    if (!(p->param[RISE] >= 0 && p->param[RISE] < INFINITY))
        return refuse(why, STATUS_INPUT, "--set rise=%g: needs a number of 0 K/s or more", p->param[RISE]);
    p->dim = 2;
    p->hi[0] = p->param[WIDTH];
    p->hi[1] = p->param[HEIGHT];
    params_material(p, p->param[K_X], p->param[K_Y], p->param[RHO_C]);
    p->side[Y_LO] = p->side[Y_HI] = NEUMANN;
    p->initial = initial;
    p->wall = wall;
    p->source = source;
    if (p->param[RISE] > 0) p->source_rate = source_rate;
    return STATUS_OK;
}

static double transient_start(const struct problem *p, const double *x) {
    return initial(p, x) - steady(p, x);
}

/* Additional part of G for `rise`, divided by rho_c: the constant term (K s^-1) and the factor of t (K s^-2). */
static double heated(const struct problem *p, const double *x) {
    return p->param[RISE] * shape(p, x, 0);
}

static double heated_more(const struct problem *p, const double *x) {
    return source_rate(p, x) / p->param[RHO_C];
}

/* Integral over s from 0 to t of exp((t - s)L) times the additional part of G at s. */
static struct exact duhamel(const struct problem *p, const double *x, double t) {
    enum { NODES = 24 };
    static const int n[2] = {16, 12};
    struct spectral *part[2] = {spectral_alloc(p, n, heated), spectral_alloc(p, n, heated_more)};
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(NODES);
    struct exact sum = {0};
    for (size_t i = 0; i < NODES; i++) {
        double s, weight;
        gsl_integration_glfixed_point(0, t, i, &s, &weight, rule);
        struct exact e[2] = {spectral_at(part[0], x, t - s), spectral_at(part[1], x, t - s)};
        sum.temperature += weight * (e[0].temperature + s * e[1].temperature);
        sum.error_bound += weight * (e[0].error_bound + s * e[1].error_bound);
    }
    gsl_integration_glfixed_table_free(rule);
    for (int k = 0; k < 2; k++) spectral_free(part[k]);
    return sum;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    static const int n[2] = {16, 12};
    struct spectral *s = spectral_alloc(p, n, transient_start);
    struct exact e = spectral_at(s, x, t);
    spectral_free(s);
    e.temperature += steady(p, x);
    e.error_bound += 8 * DBL_EPSILON;
    if (!p->source_rate) return e;
    struct exact more = duhamel(p, x, t);
    e.temperature += more.temperature;
    e.error_bound += more.error_bound;
    return e;
}

const struct scene scene_rect_manufactured = {
    .name = "rect-manufactured",
    .about = "an anisotropic rectangle with a source, two Dirichlet and two Neumann walls: smooth",
    .citation = "manufactured; method: Roache 2002, J. Fluids Eng. 124:4",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.9, 0.6, 0.023, 0.0061, 1.9, 0.7, 0.37, 1.3}, 2, 0.02, 0.1},
};
