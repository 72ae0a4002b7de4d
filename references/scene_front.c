/* SPDX-License-Identifier: GPL-3.0-or-later */
/* front: heat that penetrates a cold body with k = k_0 T^n, as a travelling wave with a sharp front.
 *
 *     rho_c dT/dt = d/dx(k_0 T^n dT/dx)  on [0, L],   T given at both ends
 *     T = (A xi)^(1/n) for xi > 0, else 0;   xi = c t + x0 - x,   A = n rho_c c/k_0
 *
 * Behind the front k = n rho_c c xi and dT/dx = -T/(n xi), so the flux is -k dT/dx = rho_c c T, and both sides of the
 * equation are rho_c c T/(n xi).  At the front flux and T vanish together: no heat is lost there (Zeldovich &
 * Kompaneets 1950; Barenblatt 1952).  The integral of k has the slope zero at the front for every n; the slope of T
 * jumps for n = 1 and is infinite for n > 1.
 *
 * With x0 >= L the body is behind the front and T is smooth.
 *
 * The second form is the first integral of the wave, rho_c c T = k dT/dxi: the distance of the temperature T from the
 * front is xi(T) = integral of k/(rho_c c T) from 0 to T, by Gauss's rule, and the root of xi(T) = xi by bisection.
 *
 * Restrictions: n is a whole number from 1 to 6; T from 1e-30 to 1e30 K at x = 0, so that k_0 T^(n+1) is
 * representable down to a thousandth of T. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <gsl/gsl_integration.h>
#include <math.h>

enum { L, X0, C, K_0, N, RHO_C, T_END };

static const struct param params[] = {
    {"L", 1, "m", "length", NULL},
    {"x0", 0.35, "m", "initial position of the front; x0 >= L: the rod is behind it", NULL},
    {"c", 0.05, "m/s", "velocity of the front", NULL},
    {"k_0", 0.02, "W/m/K/K^n", "factor in k = k_0 T^n", NULL},
    {"n", 2, "", "exponent in k = k_0 T^n", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"t_end", 4, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* Distance behind the front, m. */
static double behind(const struct problem *p, double x, double t) {
    return p->param[C] * t + p->param[X0] - x;
}

static double temperature(const struct problem *p, double xi) {
    const double *v = p->param;
    return xi > 0 ? pow(v[N] * v[RHO_C] * v[C] * xi / v[K_0], 1 / v[N]) : 0;
}

/* -dT/dx */
static double slope(const struct problem *p, double xi) {
    return xi > 0 ? temperature(p, xi) / (p->param[N] * xi) : 0;
}

/* m: rounding error of xi */
static double rounding(const struct problem *p, double x, double t) {
    return 2 * DBL_EPSILON * (p->param[C] * t + p->param[X0] + fabs(x));
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    double xi = behind(p, x[0], t), d = rounding(p, x[0], t), T = temperature(p, xi);
    double apart = fmax(temperature(p, xi + d) - T, T - temperature(p, xi - d));
    struct exact e = {.temperature = T,
                      .error_bound = apart + 8 * DBL_EPSILON * T,
                      .gradient = {-slope(p, xi)},
                      .gradient_bound = {xi < -d                      ? 0
                                         : p->param[N] > 1 && xi <= d ? INFINITY
                                                                      : 0}};
    if (xi > -d && !isinf(e.gradient_bound[0]))
        e.gradient_bound[0] = fabs(slope(p, xi - d) - slope(p, xi + d)) + 16 * DBL_EPSILON * slope(p, xi + d);
    return e;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)x;
    return temperature(p, behind(p, s == X_LO ? p->lo[0] : p->hi[0], t));
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)x;
    return p->param[C] * slope(p, behind(p, s == X_LO ? p->lo[0] : p->hi[0], t));
}

static double initial(const struct problem *p, const double *x) {
    return temperature(p, behind(p, x[0], 0));
}

static int setup(struct problem *p, struct failure *why) {
    if (params_start(params, p, NULL, why) || params_whole(params, p, N, 1, 6, why)) return STATUS_INPUT;
    p->dim = 1;
    p->hi[0] = p->param[L];
    p->k_law = K_POWER;
    p->k_0 = p->param[K_0], p->k_n = p->param[N];
    double hottest = temperature(p, behind(p, 0, p->t_end)), most = kirchhoff_k(p, hottest);
    if (!(hottest >= 1e-30 && hottest <= 1e30))
        return refuse(why, STATUS_INPUT, "--set k_0=%g: needs a temperature from 1e-30 to 1e30 K at x = 0, not %g K",
                      p->k_0, hottest);
    params_material(p, most, most, p->param[RHO_C]);
    p->initial = initial;
    p->kinked[0] = p->param[X0] < p->hi[0], p->kink[0] = p->param[X0];
    p->wall = wall;
    p->wall_rate = wall_rate;
    return STATUS_OK;
}

/* xi(T), m: the integrand is T^(n-1) times a constant, for which six points are exact. */
static double distance(const struct problem *p, double T, gsl_integration_glfixed_table *rule) {
    double sum = 0;
    for (size_t i = 0; i < 6; i++) {
        double at, weight;
        gsl_integration_glfixed_point(0, T, i, &at, &weight, rule);
        sum += weight * (p->param[K_0] * pow(at, p->param[N]) / (p->param[RHO_C] * p->param[C] * at));
    }
    return sum;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    enum { HALVINGS = 60 };
    double xi = behind(p, x[0], t), d = rounding(p, x[0], t), lo = 1, hi = 1;
    if (xi <= 0) return (struct exact){.error_bound = xi < -d ? 0 : temperature(p, d)};
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(6);
    while (distance(p, hi, rule) < xi) hi *= 2;
    while (distance(p, lo, rule) > xi) lo /= 2;
    for (int k = 0; k < HALVINGS; k++) {
        double T = lo + (hi - lo) / 2;
        *(distance(p, T, rule) < xi ? &lo : &hi) = T;
    }
    gsl_integration_glfixed_table_free(rule);
    double far = xi > d ? hi * d / (xi - d) : temperature(p, 2 * d);
    return (struct exact){.temperature = hi, .error_bound = far + 64 * DBL_EPSILON * hi};
}

const struct scene scene_front = {
    .name = "front",
    .about = "heat penetrates a cold rod with k = k_0 T^n: a travelling wave with a sharp front",
    .citation = "Zeldovich and Kompaneets 1950; Barenblatt 1952, Prikl. Mat. Mekh. 16:67",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.9, 1.3, 0.057, 0.023, 3, 1.9, 1.7}, 2, 0.01, 0.1},
};
