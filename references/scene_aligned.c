/* SPDX-License-Identifier: GPL-3.0-or-later */
/* aligned: a field along the isotherms, whatever its conductivity.
 *
 *     rho_c dT/dt = div(K grad T)  on the square of side L about 0, sides held at Tm,
 *     K = k_perp I + (k_par - k_perp) b b^T,  b along the lines of psi = cos(pi x/L) cos(pi y/L),
 *     T(x, y, 0) = Tm + A psi
 *
 * T is a function of psi, so b.grad T = 0 and k_par conducts nothing (Sovinec et al. 2004, section 4.1):
 *
 *     T = Tm + A psi exp(-2 pi^2 k_perp t/(rho_c L^2))   (angle = 0)
 *
 * A scheme that turns part of k_par to the normal of the lines decays faster: its leak.  Where grad psi = 0, at the
 * centre and the corners, grad T = 0 too, and K grad T does not depend on b; b is the image of (1, 0) there.
 *
 * angle: b is turned by it from the lines, everywhere.  Then K grad T = k grad T + c (T_y, -T_x) with the constants
 *
 *     k = k_perp + (k_par - k_perp) sin(angle)^2,   c = (k_par - k_perp) sin(angle) cos(angle)
 *
 * and the second part has no divergence: T decays as by k in place of k_perp.  b crosses the sides, along which T is
 * uniform and beside which dT/dn varies.
 *
 * Second form: two waves along the diagonals, cos(pi (x + y)/L)/2 and cos(pi (x - y)/L)/2, each with its own rate.
 *
 * Restrictions: A < Tm, so that T > 0; k_perp <= k_par <= 1e9 k_perp. */
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, K_PAR, K_PERP, ANGLE, RHO_C, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "side of the square", NULL},
    {"k_par", 10, "W/(m K)", "conductivity along b", NULL},
    {"k_perp", 0.01, "W/(m K)", "conductivity across b", NULL},
    {"angle", 0, "", "angle from the isotherms to b, rad", NULL},
    {"rho_c", 1, "J/(m^3 K)", "heat capacity", NULL},
    {"Tm", 1, "K", "temperature of the sides", NULL},
    {"A", 0.7, "K", "initial excess at the centre, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* k of psi, W m^-1 K^-1. */
static double across(const double *v) {
    return v[K_PERP] + (v[K_PAR] - v[K_PERP]) * sin(v[ANGLE]) * sin(v[ANGLE]);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, q = M_PI / v[L], phase[2] = {q * x[0], q * x[1]};
    const double rate = 2 * q * q * (across(v) / v[RHO_C]), amplitude = v[A] * exp(-rate * t);
    const double turns = fabs(phase[0]) + fabs(phase[1]),
                 rounding = DBL_EPSILON * amplitude * (6 + turns + 6 * rate * t);
    struct exact e = {.temperature = v[TM] + amplitude * cos(phase[0]) * cos(phase[1]),
                      .error_bound = rounding + DBL_EPSILON * v[TM]};
    for (int a = 0; a < 2; a++) {
        e.gradient[a] = -amplitude * q * sin(phase[a]) * cos(phase[1 - a]);
        e.gradient_bound[a] = q * rounding;
    }
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

/* Along (-psi_y, psi_x), turned by the angle. */
static void direction(const struct problem *p, const double *x, double b[DIM_MAX]) {
    const double q = M_PI / p->param[L], phase[2] = {q * x[0], q * x[1]};
    double u = cos(phase[0]) * sin(phase[1]), v = -sin(phase[0]) * cos(phase[1]), size = hypot(u, v);
    const double along[2] = {size > 0 ? u / size : 1, size > 0 ? v / size : 0};
    const double c = cos(p->param[ANGLE]), s = sin(p->param[ANGLE]);
    b[0] = c * along[0] - s * along[1];
    b[1] = s * along[0] + c * along[1];
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {ANGLE, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_within(params, p, ANGLE, -M_PI / 2, M_PI / 2, NULL, why)) return STATUS_INPUT;
    if (params_within(params, p, K_PAR, v[K_PERP], 1e9 * v[K_PERP], "k_par is at least k_perp", why))
        return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = 2;
    params_material(p, v[K_PAR], v[K_PAR], v[RHO_C]);
    p->direction = direction, p->k_par = v[K_PAR], p->k_perp = v[K_PERP];
    for (int a = 0; a < 2; a++) p->lo[a] = -v[L] / 2, p->hi[a] = v[L] / 2;
    for (int s = 0; s < 4; s++) p->side[s] = DIRICHLET, p->held[s] = v[TM];
    p->initial = initial;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param, q[2] = {M_PI / v[L], M_PI / v[L]}, c = cos(v[ANGLE]), s = sin(v[ANGLE]);
    double sum = 0, rate = 0, turns = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        double phase = q[0] * x[0] + sign * q[1] * x[1];
        rate = (v[K_PERP] * c * c + v[K_PAR] * s * s) / v[RHO_C] * (q[0] * q[0] + q[1] * q[1]);
        sum += v[A] / 2 * exp(-rate * t) * cos(phase);
        turns += fabs(phase);
    }
    return (struct exact){.temperature = v[TM] + sum,
                          .error_bound = DBL_EPSILON * (v[TM] + v[A] * (6 + turns + 6 * rate * t))};
}

const struct scene scene_aligned = {
    .name = "aligned",
    .about = "conduction along a field that follows the isotherms, or crosses them and the sides",
    .citation = "Sovinec et al. 2004, section 4.1",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.43, 0.017, 0.29, 1.7, 1.1, 0.6, 1.9}, 1, 0.01, 0.1},
};
