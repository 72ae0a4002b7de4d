/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plate: a rectangular plate with a Dirichlet condition on each side (Pamplona, Silva, Bucar, Vasco 2019, section
 * 6).
 *
 *     dT/dt = alpha (d2T/dx2 + d2T/dy2)  on [0, width] x [0, height],   alpha = k/rho_c        (1)
 *     T = T1 at y = 0, T2 at x = width, T3 at y = height, T4 at x = 0,   T = T0 at t = 0
 *
 * The problem is linear: T = T0 + sum_i (T_i - T0) H_i, where H_i is the response to a step from 0 to 1 on side i
 * (rectangle.c: strips for the steady part, a double sine series for the transient).  The second form integrates the
 * walls' Green's function over time.  The error of either form is 1e-13 of max|T_i - T0|.
 *
 * The solution printed in the paper differs from this one (`published`, with T0 = 0 as in the paper; a = width,
 * b = height):
 *   eq. 2: sinh(n pi (y - b)/a) is -sinh(n pi b/a) at y = 0, so the temperature of that side is -T1, and -T4 at x =
 * 0. eq. 7: projection of eq. 2 gives C_pn = a p T3 (-1)^p/(a^2 p^2 + b^2 n^2), D_mn = -b m T4/(a^2 n^2 + b^2 m^2);
 *          the paper prints b p T3 (-1)^m and -a m T4 over the same denominators. A_pn and B_mn are right (A_pn for
 * the side at T1, not for the printed sign). eq. 5: the sum over n has two terms, n = m from A and C, n = p from B
 * and D, by eq. 6.
 *
 * Corners: between two sides at different temperatures the limit of T depends on the direction; along the bisector
 * it is their mean.  The corner itself has no value, so `exact` returns the mean and sets no_value.  On a side, T is
 * T0 at t = 0 and the temperature of the side later.
 *
 * Restrictions: one isotropic material. */
#include "references/params.h"
#include "references/rectangle.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { WIDTH, HEIGHT, T1, T2, T3, T4, T0, MATERIAL, T_END };

static const char *const materials[] = {"steel", "titanium", "vanadium", NULL};
static const struct {
    double rho, c, k; /* kg/m^3, J/kg/K, W/m/K; Pamplona 2019 section 6, from Bergman et al. */
} property[] = {{7854, 434, 60.5}, {4500, 522, 21.9}, {6100, 489, 30.7}};

static const struct param params[] = {
    {"width", 0.1, "m", "extent along x", NULL},
    {"height", 0.1, "m", "extent along y", NULL},
    {"T1", 0.25, "K", "temperature of the side y = 0", NULL},
    {"T2", 0.50, "K", "temperature of the side x = width", NULL},
    {"T3", 0.75, "K", "temperature of the side y = height", NULL},
    {"T4", 1.00, "K", "temperature of the side x = 0", NULL},
    {"T0", 0, "K", "initial temperature of the plate", NULL},
    {"material", 0, "", "material of the plate", materials},
    {"t_end", 28.8894, "s", "end time; the paper also shows 57.9411, 86.9928 and 115.8822", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T1, T2, T3, T4, T0, MATERIAL, -1}, of_side[] = {[X_LO] = T4, T2, T1, T3};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    double ratio = p->param[HEIGHT] / p->param[WIDTH];
    if (ratio < 1e-3 || ratio > 1e3)
        return refuse(why, STATUS_INPUT,
                      "--set height=%g: needs %g to %g m, a thousandth to a thousand times the width",
                      p->param[HEIGHT], 1e-3 * p->param[WIDTH], 1e3 * p->param[WIDTH]);
    double which = p->param[MATERIAL];
    if (!(which == 0 || which == 1 || which == 2))
        return refuse(why, STATUS_INPUT, "--set material=%g: needs steel, titanium or vanadium (0, 1 or 2)", which);
    p->dim = 2;
    p->hi[0] = p->param[WIDTH];
    p->hi[1] = p->param[HEIGHT];
    double k = property[(int)which].k;
    params_material(p, k, k, property[(int)which].rho * property[(int)which].c);
    p->mirror[0] = p->param[T2] == p->param[T4];
    p->mirror[1] = p->param[T1] == p->param[T3];
    p->start = p->param[T0];
    for (int s = X_LO; s <= Y_HI; s++) p->held[s] = p->param[of_side[s]];
    return STATUS_OK;
}

static double width_at(const struct problem *p, double t) {
    return sqrt(4 * p->material[0].k[0] / p->material[0].rho_c * t);
}

/* Returns 1 if x is a corner, and sets *e to the mean of both sides. */
static int corner(const struct problem *p, const double *x, struct exact *e) {
    const double *v = p->param;
    int at_x = x[0] <= 0 || x[0] >= v[WIDTH], at_y = x[1] <= 0 || x[1] >= v[HEIGHT];
    if (!at_x || !at_y) return 0;
    double Tx = x[0] <= 0 ? v[T4] : v[T2], Ty = x[1] <= 0 ? v[T1] : v[T3];
    *e = (struct exact){.temperature = (Tx + Ty) / 2,
                        .error_bound = fabs(Tx - Ty) / 2 + 2 * DBL_EPSILON * (fabs(Tx) + fabs(Ty)),
                        .no_value = Tx != Ty};
    for (int a = 0; a < 2; a++) e->gradient_bound[a] = Tx != Ty ? INFINITY : 0;
    return 1;
}

static void *prepare(const struct problem *p, double t) {
    const double *v = p->param, side[4] = {v[T4] - v[T0], v[T2] - v[T0], v[T1] - v[T0], v[T3] - v[T0]};
    double least = 1e-100 * fmin(v[WIDTH], v[HEIGHT]); /* squares of smaller widths underflow */
    struct rectangle *r = xcalloc(1, sizeof *r);
    if (t > 0) rectangle_prepare(p->hi, side, fmax(width_at(p, t), least), r);
    return r;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    double start = p->param[T0], rounding = 2 * DBL_EPSILON * fabs(start);
    struct exact e = {.temperature = start};
    if (t == 0 || corner(p, x, &e)) return e;
    struct surface T = rectangle_at(shared, x);
    return (struct exact){.temperature = start + T.at.value,
                          .error_bound = T.at.error + rounding,
                          .gradient = {T.slope[0].value, T.slope[1].value},
                          .gradient_bound = {T.slope[0].error, T.slope[1].error}};
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param, W = v[WIDTH], B = v[HEIGHT], s = width_at(p, t);
    const struct {
        double T, xi, W, eta, B;
    } side[] = {{v[T1], x[1], B, x[0], W},
                {v[T2], W - x[0], W, x[1], B},
                {v[T3], B - x[1], B, x[0], W},
                {v[T4], x[0], W, x[1], B}};
    struct exact e = {.temperature = v[T0], .error_bound = 2 * DBL_EPSILON * fabs(v[T0])};
    if (t == 0 || corner(p, x, &e)) return e;
    for (int i = 0; i < 4; i++) {
        if (side[i].T == v[T0]) continue;
        struct approx H = rectangle_quadrature(side[i].xi, side[i].W, side[i].eta, side[i].B, s);
        e.temperature += (side[i].T - v[T0]) * H.value;
        e.error_bound += fabs(side[i].T - v[T0]) * H.error;
    }
    return e;
}

/* K_mp of eqs. 5-7 exactly as printed. */
static double published_coefficient(const double *v, int m, int p) {
    double a = v[WIDTH], b = v[HEIGHT], sign = m % 2 ? -1 : 1, K = 0;
    double nm = a * a * p * p + b * b * m * m; /* both denominators, for n = m and for n = p */
    if (m % 2) K += 16 / (m * M_PI * M_PI) * a / 2 * (-a * p * v[T1] + b * p * v[T3] * sign) / nm;
    if (p % 2) K += 16 / (p * M_PI * M_PI) * b / 2 * (b * m * v[T2] * sign - a * m * v[T4]) / nm;
    return K;
}

/* Eqs. 2-7 as printed.  The series of eq. 2 are summed in closed form, that of eq. 4 down to exponents of -40. */
static double published(const struct problem *p, const double *x, double t) {
    enum { MODES = 400 };
    const double *v = p->param, a = v[WIDTH], b = v[HEIGHT], c = pow(width_at(p, t) / 2, 2);
    double T =
        -v[T1] * rectangle_steady(x[1], b, x[0], a).value + v[T2] * rectangle_steady(a - x[0], a, x[1], b).value +
        v[T3] * rectangle_steady(b - x[1], b, x[0], a).value - v[T4] * rectangle_steady(x[0], a, x[1], b).value;
    for (int m = 1; m <= MODES; m++)
        for (int n = 1; n <= MODES; n++) {
            double q = m * M_PI / a, r = n * M_PI / b, rate = c * (q * q + r * r);
            if (rate > 40) break;
            T += published_coefficient(v, m, n) * sin(q * x[0]) * sin(r * x[1]) * exp(-rate);
        }
    return T;
}

const struct scene scene_plate = {
    .name = "plate",
    .about = "a plate with four sides at different temperatures: discontinuous at the corners",
    .citation = "Pamplona, Silva, Bucar, Vasco 2019, section 6, eqs. 1-7 (signs corrected)",
    .params = params,
    .setup = setup,
    .prepare = prepare,
    .exact = exact,
    .second = second,
    .published = published,
    .odd = {{0.13, 0.07, 0.31, 0.57, 0.83, 1.19, 0.11, 1, 23.7}, 1, 0.001, 20},
};
