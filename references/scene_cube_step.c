/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cube-step: a hot brick in the middle of a cold cube; square-step in space.
 *
 *     dT/dt = kappa_x d2T/dx2 + kappa_y d2T/dy2 + kappa_z d2T/dz2  on [-L, L]^3,   T = 0 on all six sides,
 *     T(x, y, z, 0) = T0 for |x| <= a, |y| <= b and |z| <= c, else 0
 *
 * Data, walls and operator are separable, so the solution is T0 times a product of three rods (rod-step) with unit
 * data, each a sum of images or of modes between walls (Carslaw and Jaeger 1959, sections 1.15 and 2.2).  As in Song,
 * Xing, Hou, Lu 2018, eq. 51, the published form is the product of the boxes on the infinite line, which neglects the
 * walls; at the defaults its error is 7.5e-4 K at the middle of the wall z = L.
 *
 * Restrictions: a, b, c < L.  At t = 0 the faces of the brick belong to it. */
#include "references/params.h"
#include "references/series.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, A, B, C, KAPPA_X, KAPPA_Y, KAPPA_Z, T0, T_END };

static const struct param params[] = {
    {"L", 2, "m", "half side of the cube, walls at -L and L", NULL},
    {"a", 0.5, "m", "half width of the brick along x, below L", NULL},
    {"b", 0.6, "m", "half width of the brick along y, below L", NULL},
    {"c", 0.7, "m", "half width of the brick along z, below L", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.008, "m^2/s", "diffusivity along y", NULL},
    {"kappa_z", 0.012, "m^2/s", "diffusivity along z", NULL},
    {"T0", 10, "K", "initial temperature of the brick above that of the walls", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double width_at(const struct problem *p, int axis, double t) {
    return sqrt(4 * p->param[KAPPA_X + axis] * t);
}

static double initial(const struct problem *p, const double *x) {
    for (int a = 2; a >= 0; a--) /* rows along x beside the brick end here at once */
        if (!series_in_box(x[a], p->param[A + a])) return 0;
    return p->param[T0];
}

static int setup(struct problem *p, struct failure *why) {
    const double *v = p->param;
    if (params_start(params, p, NULL, why)) return STATUS_INPUT;
    p->dim = 3;
    params_material(p, v[KAPPA_X], v[KAPPA_Y], 1);
    p->material[0].k[2] = v[KAPPA_Z];
    for (int a = 0; a < 3; a++) {
        if (params_between(params, p, A + a, 0, v[L], "the brick ends before the walls", why)) return STATUS_INPUT;
        p->lo[a] = -v[L], p->hi[a] = v[L];
        p->jumps[a] = 2;
        p->jump[a][0] = -v[A + a], p->jump[a][1] = v[A + a];
        p->mirror[a] = 1;
    }
    p->initial = initial;
    return STATUS_OK;
}

static struct approx times(struct approx u, struct approx v) {
    double value = u.value * v.value;
    return (struct approx){value,
                           fabs(u.value) * v.error + u.error * (fabs(v.value) + v.error) + DBL_EPSILON * fabs(value)};
}

static struct exact product(const struct problem *p, const struct curve u[3]) {
    struct exact e = {0};
    for (int d = -1; d < 3; d++) { /* -1: temperature, else dT/dx_d */
        struct approx T = {p->param[T0], 0};
        for (int a = 0; a < 3; a++) T = times(T, a == d ? u[a].slope : u[a].at);
        *(d < 0 ? &e.temperature : &e.gradient[d]) = T.value;
        *(d < 0 ? &e.error_bound : &e.gradient_bound[d]) = T.error;
    }
    return e;
}

typedef struct curve form(double x, double L, double a, double s); /* series_box or series_box_other */

static struct curve rod(const struct problem *p, int axis, double x, double t, form *box) {
    return box(x, p->param[L], p->param[A + axis], width_at(p, axis, t));
}

/* Grid points come in rows along an axis: a coordinate equal to that of the previous point reuses its rod. */
static void at_points(const struct problem *p, const void *shared, size_t n, const double *const *x, double t,
                      struct exact *e) {
    struct curve u[3] = {0};
    (void)shared;
    for (size_t i = 0; i < n; i++) {
        for (int a = 0; a < 3; a++)
            if (i == 0 || x[a][i] != x[a][i - 1]) u[a] = rod(p, a, x[a][i], t, series_box);
        e[i] = product(p, u);
    }
}

static struct exact evaluate(const struct problem *p, const double *x, double t, form *box) {
    struct curve u[3];
    for (int a = 0; a < 3; a++) u[a] = rod(p, a, x[a], t, box);
    return product(p, u);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    return evaluate(p, x, t, series_box);
}

static struct exact second(const struct problem *p, const double *x, double t) {
    return evaluate(p, x, t, series_box_other);
}

static double published(const struct problem *p, const double *x, double t) {
    double T = p->param[T0];
    for (int a = 0; a < 3; a++) T *= series_box_line(x[a], p->param[A + a], width_at(p, a, t));
    return T;
}

const struct scene scene_cube_step = {
    .name = "cube-step",
    .about = "a hot brick in a cube between cold walls: data with jumps in three dimensions",
    .citation = "Song, Xing, Hou, Lu 2018, section 5.2, extended by an axis; Carslaw and Jaeger 1959, section 1.15",
    .params = params,
    .setup = setup,
    .exact = exact,
    .at_points = at_points,
    .second = second,
    .published = published,
    .odd = {{1.9, 0.47, 0.83, 0.61, 0.013, 0.0071, 0.0093, 6.1, 3.7}, 6, 0.01, 2},
};
