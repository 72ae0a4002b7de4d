/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall-kirchhoff: a wall between two held temperatures, with k = k_0 (1 + beta (T - T_ref)).
 *
 *     rho_c dT/dt = d/dx(k dT/dx) + G  on [0, L],   T(0, t) = T1,   T(L, t) = T2
 *
 * The steady profile S has a linear theta, the integral of k from T_ref: with u = S - T_ref,
 *
 *     theta = theta1 + (theta2 - theta1) x/L,   theta = k_0 (u + beta u^2/2),   u = 2 theta/(k_0 + k(S)),
 *     k(S) = k_0 sqrt(1 + 2 beta theta/k_0)
 *
 * (Kirchhoff 1894; Carslaw and Jaeger 1959, section 2.16).  A transient is added and the source follows from it:
 *
 *     T = S + Z,   Z = A sin(pi x/L) exp(-lambda t),   lambda = (pi/L)^2 k((T1 + T2)/2)/rho_c
 *     G = rho_c Z_t - k T_xx - k_0 beta T_x^2
 *
 * Its walls are steady.  After a few times 1/lambda the source has decayed and the profile S remains.
 *
 * Second form: with means of k, S obeys (S - T1) (k(S) + k(T1))/((T2 - T1) (k(T2) + k(T1))) = x/L, an increasing
 * function of S; the root by bisection, without theta.
 *
 * Restrictions: k > 0 from the lower wall to A above the upper one; T1 != T2; A >= 0. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, K_0, BETA, T_REF, RHO_C, T1, T2, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "thickness of the wall", NULL},
    {"k_0", 0.01, "W/m/K", "conductivity at T_ref", NULL},
    {"beta", 3, "1/K", "relative change of the conductivity with temperature", NULL},
    {"T_ref", 0.4, "K", "temperature at which k = k_0", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"T1", 1.2, "K", "temperature at x = 0", NULL},
    {"T2", 0.5, "K", "temperature at x = L", NULL},
    {"A", 0.6, "K", "initial amplitude of the decaying part", NULL},
    {"t_end", 4, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* A temperature with its derivatives along x, K, K/m, K/m^2. */
struct profile {
    double T, slope, bend;
};

static struct profile steady(const struct problem *p, double x) {
    double theta[2] = {kirchhoff_theta(p, p->param[T1]), kirchhoff_theta(p, p->param[T2])};
    double q = (theta[1] - theta[0]) / p->param[L], at = theta[0] + q * x;
    double k = p->k_0 * sqrt(1 + 2 * p->k_beta * at / p->k_0), slope = q / k;
    return (struct profile){p->k_ref + 2 * at / (p->k_0 + k), slope, -p->k_0 * p->k_beta * slope * slope / k};
}

static double decay(const struct problem *p) {
    double q = M_PI / p->param[L];
    return q * q * kirchhoff_k(p, (p->param[T1] + p->param[T2]) / 2) / p->param[RHO_C];
}

/* Z with its derivatives along x */
static struct profile transient(const struct problem *p, double x, double t) {
    double q = M_PI / p->param[L], left = p->param[A] * exp(-fmin(decay(p) * t, 800));
    return (struct profile){left * sin(q * x), left * q * cos(q * x), -left * q * q * sin(q * x)};
}

static double source_at(const struct problem *p, const double *x, double t) {
    struct profile S = steady(p, x[0]), Z = transient(p, x[0], t);
    double slope = S.slope + Z.slope;
    return -p->param[RHO_C] * decay(p) * Z.T - kirchhoff_k(p, S.T + Z.T) * (S.bend + Z.bend) -
           p->k_0 * p->k_beta * slope * slope;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    struct profile S = steady(p, x[0]), Z = transient(p, x[0], t);
    double least = fmin(kirchhoff_k(p, p->param[T1]), kirchhoff_k(p, p->param[T2]));
    double size = fabs(p->param[T1]) + fabs(p->param[T2]) + fabs(p->k_ref), ratio = p->material[0].k[0] / least;
    double error = DBL_EPSILON * (8 * ratio * size + p->param[A] * exp(-decay(p) * t) * (8 + 6 * decay(p) * t));
    return (struct exact){.temperature = S.T + Z.T,
                          .error_bound = t > 1e6 / decay(p) ? 8 * DBL_EPSILON * ratio * size : error,
                          .gradient = {S.slope + Z.slope},
                          .gradient_bound = {DBL_EPSILON * 40 * ratio * ratio * (size + p->param[A]) / p->param[L]}};
}

static double initial(const struct problem *p, const double *x) {
    return steady(p, x[0]).T + transient(p, x[0], 0).T;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {BETA, T_REF, T1, T2, A, -1}, law[3] = {K_0, BETA, T_REF};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    const double *v = p->param;
    if (v[T1] == v[T2])
        return refuse(why, STATUS_INPUT, "--set T1=%g: needs a temperature other than T2=%g, so that heat flows",
                      v[T1], v[T2]);
    if (!(v[A] >= 0)) return refuse(why, STATUS_INPUT, "--set A=%g: needs a number of 0 K or more", v[A]);
    p->dim = 1;
    p->hi[0] = v[L];
    if (kirchhoff_linear(params, p, law, v[RHO_C], fmin(v[T1], v[T2]), fmax(v[T1], v[T2]) + v[A], why))
        return STATUS_INPUT;
    p->held[X_LO] = v[T1];
    p->held[X_HI] = v[T2];
    p->initial = initial;
    if (v[A] > 0) p->source_at = source_at;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    enum { HALVINGS = 60 };
    const double *v = p->param;
    double from = v[T1], to = v[T2], whole = (to - from) * (kirchhoff_k(p, to) + kirchhoff_k(p, from));
    double wanted = x[0] / v[L];
    for (int i = 0; i < HALVINGS; i++) {
        double T = from + (to - from) / 2, part = (T - v[T1]) * (kirchhoff_k(p, T) + kirchhoff_k(p, v[T1])) / whole;
        *(part < wanted ? &from : &to) = T;
    }
    double half = M_PI * x[0] / (2 * v[L]), Z = 2 * v[A] * sin(half) * cos(half) / exp(fmin(decay(p) * t, 700));
    struct exact e = exact(p, NULL, x, t);
    return (struct exact){.temperature = to + Z, .error_bound = 2 * e.error_bound};
}

const struct scene scene_wall_kirchhoff = {
    .name = "wall-kirchhoff",
    .about = "a wall between two held temperatures, k linear in T: Kirchhoff's profile and a transient",
    .citation = "Kirchhoff 1894; Carslaw and Jaeger 1959, section 2.16; manufactured transient",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.1, 0.013, 1.7, 0.3, 1.9, 0.45, 1.3, 0.7, 2.3}, 1.3, 0.01, 0.1},
};
