/* SPDX-License-Identifier: GPL-3.0-or-later */
/* square-step: a hot rectangle in the middle of a square (Song, Xing, Hou, Lu 2018, section 5.2).
 *
 *     dT/dt = kappa_x d2T/dx2 + kappa_y d2T/dy2  on [-L, L]^2,   T = 0 on all four sides,
 *     T(x, y, 0) = T0 for |x| <= a and |y| <= b, else 0                                       (49, 50)
 *
 * Data, walls and operator are separable, so the solution is a product of two rods (rod-step) with unit data,
 *
 *     T(x, y, t) = T0 X(x, t) Y(y, t),   X for (a, kappa_x), Y for (b, kappa_y),
 *
 * each a sum of images or of modes between walls.  Eq. 51 prints the product of the two boxes on the infinite line
 * and neglects the walls; at the defaults its error is 9.3e-6 K at the middle of a wall.  Errors of this form are of
 * the order of round-off at any time.
 *
 * Restrictions: a, b < L.  At t = 0 the edges belong to the box. */
#include "references/params.h"
#include "references/series.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, A, B, KAPPA_X, KAPPA_Y, T0, T_END };

static const struct param params[] = {
    {"L", 2, "m", "half side of the square, walls at -L and L", NULL},
    {"a", 0.5, "m", "half width of the hot rectangle along x, below L", NULL},
    {"b", 0.5, "m", "half width of the hot rectangle along y, below L", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.01, "m^2/s", "diffusivity along y", NULL},
    {"T0", 10, "K", "initial temperature of the hot rectangle above that of the walls", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double width_at(const struct problem *p, int kappa, double t) {
    return sqrt(4 * p->param[kappa] * t);
}

static double initial(const struct problem *p, const double *x) {
    return series_in_box(x[0], p->param[A]) && series_in_box(x[1], p->param[B]) ? p->param[T0] : 0;
}

static int setup(struct problem *p, struct failure *why) {
    if (params_start(params, p, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, p->param[L], "the rectangle ends before the walls, a < L", why) ||
        params_between(params, p, B, 0, p->param[L], "the rectangle ends before the walls, b < L", why))
        return STATUS_INPUT;
    p->dim = 2;
    for (int d = 0; d < 2; d++) {
        double half = p->param[d ? B : A];
        p->lo[d] = -p->param[L];
        p->hi[d] = p->param[L];
        p->jumps[d] = 2;
        p->jump[d][0] = -half;
        p->jump[d][1] = half;
        p->mirror[d] = 1;
    }
    params_material(p, p->param[KAPPA_X], p->param[KAPPA_Y], 1);
    p->initial = initial;
    return STATUS_OK;
}

static double product_error(struct approx u, struct approx v) {
    return fabs(u.value) * v.error + u.error * (fabs(v.value) + v.error) + 2 * DBL_EPSILON * fabs(u.value * v.value);
}

static struct exact product(const struct problem *p, struct curve u, struct curve v) {
    double peak = p->param[T0];
    return (struct exact){
        .temperature = peak * u.at.value * v.at.value,
        .error_bound = peak * product_error(u.at, v.at),
        .gradient = {peak * u.slope.value * v.at.value, peak * u.at.value * v.slope.value},
        .gradient_bound = {peak * product_error(u.slope, v.at), peak * product_error(u.at, v.slope)}};
}

static struct curve rod(const struct problem *p, int axis, double x, double t) {
    return series_box(x, p->param[L], p->param[axis ? B : A], width_at(p, axis ? KAPPA_Y : KAPPA_X, t));
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    return product(p, rod(p, 0, x[0], t), rod(p, 1, x[1], t));
}

/* Grid points come in rows or columns: a coordinate equal to that of the previous point reuses its rod. */
static void at_points(const struct problem *p, const void *shared, size_t n, const double *const *x, double t,
                      struct exact *e) {
    struct curve u = {{0, 0}, {0, 0}}, v = u;
    (void)shared;
    for (size_t i = 0; i < n; i++) {
        if (i == 0 || x[0][i] != x[0][i - 1]) u = rod(p, 0, x[0][i], t);
        if (i == 0 || x[1][i] != x[1][i - 1]) v = rod(p, 1, x[1][i], t);
        e[i] = product(p, u, v);
    }
}

static struct exact second(const struct problem *p, const double *x, double t) {
    return product(p, series_box_other(x[0], p->param[L], p->param[A], width_at(p, KAPPA_X, t)),
                   series_box_other(x[1], p->param[L], p->param[B], width_at(p, KAPPA_Y, t)));
}

static double published(const struct problem *p, const double *x, double t) {
    return p->param[T0] * series_box_line(x[0], p->param[A], width_at(p, KAPPA_X, t)) *
           series_box_line(x[1], p->param[B], width_at(p, KAPPA_Y, t));
}

const struct scene scene_square_step = {
    .name = "square-step",
    .about = "a hot rectangle in a square between cold walls: data with jumps in two dimensions",
    .citation = "Song, Xing, Hou, Lu 2018, section 5.2, eqs. 49-51",
    .params = params,
    .setup = setup,
    .exact = exact,
    .at_points = at_points,
    .second = second,
    .published = published,
    .odd = {{1.9, 0.47, 0.83, 0.013, 0.0071, 6.1, 3.7}, 6, 0.01, 2},
};
