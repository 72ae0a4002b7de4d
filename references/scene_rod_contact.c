/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-contact: two half rods at different temperatures are brought into contact at x = x_c.
 *
 *     rho_c dT/dt = d/dx(k dT/dx),   k, rho_c and T(x, 0) = (k1, rho_c1, T1) for x < x_c, (k2, rho_c2, T2) else
 *
 * At x = x_c the flux q = -k dT/dx is continuous, and T falls by R q.  At R = 0 the contact therefore jumps at once
 * to the temperature Tc at which both half rods carry the same flux e_i (T_i - Tc)/sqrt(pi t), with the effusivity e
 * = sqrt(k rho_c), and stays there:
 *
 *     T = Tc + (T_i - Tc) erf(|x - x_c|/sqrt(4 kappa_i t)),   Tc = (e1 T1 + e2 T2)/(e1 + e2),   kappa = k/rho_c
 *
 * (Carslaw and Jaeger 1959, section 2.15).  A contact resistance R > 0 lets the flux grow from (T1 - T2)/R at t = 0:
 * the surface of half rod i differs from T_i by the half integral of the flux over e_i, whose transform is q/(e_i
 * sqrt(z)), so the transform of the flux is (T1 - T2)/(R sqrt(z) (sqrt(z) + H)) with H = (1/e1 + 1/e2)/R.  Hence
 *
 *     T = T_i + (Tc - T_i) (erfc(y) - exp(-y^2) erfcx(y + H sqrt(t))),   y = |x - x_c|/sqrt(4 kappa_i t),
 *     |dT/dx| = |Tc - T_i| H/sqrt(kappa_i) exp(-y^2) erfcx(y + H sqrt(t)),   erfcx(y) = exp(y^2) erfc(y)
 *
 * (tables of Carslaw and Jaeger 1959, appendix V).  The walls at -L and L are held at T1 and T2.  The solution on the
 * infinite line misses these values by |T_i - Tc| erfc(L_i/s_i), with L_i = L +- x_c and s_i = sqrt(4 kappa_i t).
 * By the maximum principle the error inside is no larger; it is part of the error bound, 1.5e-23 K at the defaults.
 *
 * At the defaults Tc = 0.8635 K, and the diffusivities are 0.005 and 0.002 m^2/s.  The second form solves the rod
 * with its walls by the Laplace transform and uses no contact temperature.
 *
 * Restrictions: L - |x_c| > 5 s_i at t_end. */
#include "references/cooling.h"
#include "references/layers.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

enum { L, X_C, K1, RHO_C1, T1, K2, RHO_C2, T2, R, T_END };

static const struct param params[] = {
    {"L", 1, "m", "half the length of the rod, walls at -L and L", NULL},
    {"x_c", 0, "m", "position of the contact", NULL},
    {"k1", 0.01, "W/m/K", "conductivity at x < x_c", NULL},
    {"rho_c1", 2, "J/m^3/K", "heat capacity at x < x_c", NULL},
    {"T1", 1, "K", "initial temperature at x < x_c, also that of the wall x = -L", NULL},
    {"k2", 0.001, "W/m/K", "conductivity at x > x_c", NULL},
    {"rho_c2", 0.5, "J/m^3/K", "heat capacity at x > x_c", NULL},
    {"T2", 0, "K", "initial temperature at x > x_c, also that of the wall x = L", NULL},
    {"R", 0, "m^2 K/W", "resistance of the contact, 0: none", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int right_of_contact(const struct problem *p, double x) {
    return x >= p->param[X_C] - 1e-12 * p->param[L]; /* points within round-off of x_c belong to the right half */
}

static double initial(const struct problem *p, const double *x) {
    return p->param[right_of_contact(p, x[0]) ? T2 : T1];
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {X_C, T1, T2, R, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    double kappa1 = p->param[K1] / p->param[RHO_C1], kappa2 = p->param[K2] / p->param[RHO_C2];
    double kappa = fmax(kappa1, kappa2);
    int of = kappa2 > kappa1 ? 2 : 1;
    if (params_between(params, p, X_C, -p->param[L], p->param[L], "the contact is between the walls", why))
        return STATUS_INPUT;
    if (params_within(params, p, R, 0, 1e300, "resistances are not negative", why)) return STATUS_INPUT;
    double nearest = p->param[L] - fabs(p->param[X_C]), latest = nearest * nearest / (100 * kappa);
    char because[160];
    snprintf(because, sizeof because,
             "the solution neglects the walls, which later matter; D^2/(100 kappa) with D = L - |x_c| = %g m and "
             "k%d/rho_c%d = %g m^2/s",
             nearest, of, of, kappa);
    if (params_between(params, p, T_END, 0, latest, because, why)) return STATUS_INPUT;
    p->dim = 1;
    p->lo[0] = -p->param[L];
    p->hi[0] = p->param[L];
    p->interface = p->param[X_C];
    p->resistance = p->param[R];
    params_material(p, p->param[K1], p->param[K1], p->param[RHO_C1]);
    params_material(p, p->param[K2], p->param[K2], p->param[RHO_C2]);
    p->jumps[0] = 1;
    p->jump[0][0] = p->param[X_C];
    p->initial = initial;
    p->held[X_LO] = p->param[T1];
    p->held[X_HI] = p->param[T2];
    return STATUS_OK;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    if (t == 0) return (struct exact){.temperature = initial(p, x)};
    const int right = right_of_contact(p, x[0]);
    double e1 = sqrt(v[K1] * v[RHO_C1]), e2 = sqrt(v[K2] * v[RHO_C2]), from = x[0] - v[X_C];
    double share1 = e1 / (e1 + e2), Tc = v[T2] + share1 * (v[T1] - v[T2]), rise = v[right ? T2 : T1] - Tc;
    double s1 = sqrt(4 * v[K1] / v[RHO_C1] * t), s2 = sqrt(4 * v[K2] / v[RHO_C2] * t), s = right ? s2 : s1;
    double walls = fabs(v[T1] - v[T2]) * fmax(erfc((v[L] + v[X_C]) / s1), erfc((v[L] - v[X_C]) / s2));
    double z = from / s, size = fabs(v[T1]) + fabs(v[T2]), edge = 1.12837916709551257 / s * exp(-z * z);
    double T = Tc + rise * erf(fabs(z)), rounding = 8 + 6 * z * z;
    if (v[R] > 0) {
        double eta = fmin((1 / e1 + 1 / e2) / v[R] * sqrt(t), 1e100); /* H sqrt(t) */
        double fall = exp(-z * z) * cooling_erfcx(fabs(z) + eta);
        T = v[right ? T2 : T1] - rise * (erfc(fabs(z)) - fall);
        edge = 2 * eta / s * fall;
        rounding += 60; /* exp(y^2), y < 5 */
    }
    return (struct exact){.temperature = T,
                          .error_bound = walls + 8 * DBL_EPSILON * size,
                          .gradient = {(right ? rise : -rise) * edge},
                          .gradient_bound = {walls * 10 / s + DBL_EPSILON * size * edge * rounding}};
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    struct layers w = {.width = {v[L] + v[X_C], v[L] - v[X_C]},
                       .k = {v[K1], v[K2]},
                       .rho_c = {v[RHO_C1], v[RHO_C2]},
                       .wall = {v[T1], v[T2]},
                       .start = {v[T1], v[T2]},
                       .R = v[R]};
    struct layers_contour c;
    if (t == 0) return (struct exact){.temperature = initial(p, x)};
    layers_contour(&w, t, &c);
    struct curve T = layers_contour_at(&c, x[0] - v[X_C]);
    return (struct exact){.temperature = T.at.value, .error_bound = T.at.error};
}

const struct scene scene_rod_contact = {
    .name = "rod-contact",
    .about = "two half rods of different materials in contact: a jump in the data and in the conductivity",
    .citation = "Carslaw and Jaeger 1959, section 2.15",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.13, 0.011, 2.3, 0.9, 0.0017, 0.61, 0.2, 0, 1.1}, 1, 0.003, 0.9},
};
