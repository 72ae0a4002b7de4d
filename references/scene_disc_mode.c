/* SPDX-License-Identifier: GPL-3.0-or-later */
/* disc-mode: one mode of a disc with a Dirichlet, Neumann or Robin wall.
 *
 *     rho_c dT/dt = k lap T  in r < R,   T(r, theta, 0) = Tm + A J_m(lambda r/R) cos(m theta),
 *     wall = 1 (Dirichlet): T = Tm,   2 (Neumann): k dT/dr = 0,   3 (Robin): k dT/dr = b (Tm - T)  at r = R
 *
 * J_m(lambda r/R) cos(m theta) is an eigenfunction if lambda is a root of J_m, of J_m', or of lambda J_m' + (b R/k)
 * J_m (Carslaw and Jaeger 1959, sections 7.6 and 7.7).  The scene uses the first positive root:
 *
 *     T = Tm + A J_m(lambda r/R) cos(m theta) exp(-k lambda^2 t/(rho_c R^2))
 *
 * The second form evaluates J_m by Bessel's integral with the trapezoidal rule and computes its own root
 * from it.
 *
 * Restrictions: A < Tm, so that T > 0 (|J_m| <= 1); mode <= 20; 1e-12 <= b R/k <= 1e12. */
#include "references/params.h"
#include "references/roots.h"

#include "solver/status.h"
#include "solver/shape.h"

#include <float.h>
#include <math.h>

#include <gsl/gsl_sf_bessel.h>

enum { R, K, RHO_C, MODE, TM, A, WALL, B, T_END, LAMBDA }; /* LAMBDA: computed by setup */

static const struct param params[] = {
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

static double first_root(const struct problem *p, double (*J)(int m, double z)) {
    const double *v = p->param;
    return roots_round(J, (int)v[MODE], 0, p->side[X_HI], p->robin[X_HI] * v[R] / v[K]);
}

/* |J_m|, |J_m'| and |z J_m'|/(m + 1) are at most 1.  Errors: a few eps in J_m (GSL), m eps in the phase. */
static struct exact exact(const struct problem *p, const double x[2], double t) {
    const double *v = p->param;
    int m = (int)v[MODE];
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

static double initial(const struct problem *p, const double x[2]) {
    return exact(p, x, 0).temperature;
}

static double bessel(int m, double z) {
    return gsl_sf_bessel_Jn(m, z);
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE, WALL, -1};
    static const enum side_kind kind[] = {DIRICHLET, NEUMANN, ROBIN};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE, 0, 20, why) || params_whole(params, p, WALL, 1, 3, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    if (params_between(params, p, B, 1e-12 * v[K] / v[R], 1e12 * v[K] / v[R], "b radius/k of 1e-12 to 1e12", why))
        return STATUS_INPUT;
    shape_round(p, 0, v[R]);
    params_material(p, v[K], v[K], v[RHO_C]);
    p->side[X_HI] = kind[(int)v[WALL] - 1];
    p->robin[X_HI] = v[WALL] == 3 ? v[B] : 0;
    p->param[LAMBDA] = first_root(p, bessel);
    p->initial = initial;
    p->held[X_HI] = v[WALL] == 2 ? 0 : v[TM];
    return STATUS_OK;
}

/* J_m(z) = mean over tau of cos(m tau - z sin tau).  N points alias J_(N-m)(z), negligible for z + m < N/2. */
static double bessel_integral(int m, double z) {
    enum { N = 128 };
    double sum = 0;
    for (int k = 0; k < N; k++) {
        double tau = 2 * M_PI * k / N;
        sum += cos(m * tau - z * sin(tau));
    }
    return sum / N;
}

static struct exact second(const struct problem *p, const double x[2], double t) {
    const double *v = p->param;
    int m = (int)v[MODE];
    double lambda = first_root(p, bessel_integral), z = lambda * hypot(x[0], x[1]) / v[R];
    double decay = v[K] * lambda * lambda / (v[RHO_C] * v[R] * v[R]) * t, amplitude = v[A] * exp(-decay);
    return (struct exact){.temperature = v[TM] + amplitude * bessel_integral(m, z) * cos(m * atan2(x[1], x[0])),
                          .error_bound = DBL_EPSILON * (amplitude * (16 + 8 * m + 32 * decay) + v[TM])};
}

const struct scene scene_disc_mode = {
    .name = "disc-mode",
    .about = "one mode of a disc with a Dirichlet, insulated or cooled wall",
    .citation = "Carslaw and Jaeger 1959, sections 7.6 and 7.7",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 1.9, 3, 2.1, 1.2, 3, 0.031, 1.7}, 1, 0.01, 0.1},
};
