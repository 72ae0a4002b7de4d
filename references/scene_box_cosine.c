/* SPDX-License-Identifier: GPL-3.0-or-later */
/* box-cosine: one oblique cosine mode of an insulated box.
 *
 *     dT/dt = kappa_x d2T/dx2 + kappa_y d2T/dy2 + kappa_z d2T/dz2  on [0, width] x [0, height] x [0, depth],
 *     dT/dn = 0 on all six sides,   T(x, y, z, 0) = Tm + A cos(q_x x) cos(q_y y) cos(q_z z)
 *
 * with q = mode pi/extent on each axis.  The mode is an eigenfunction:
 *
 *     T = Tm + A cos(q_x x) cos(q_y y) cos(q_z z) exp(-(kappa_x q_x^2 + kappa_y q_y^2 + kappa_z q_z^2) t)
 *
 * (Carslaw and Jaeger 1959, section 6.2).  Extents, modes and diffusivities differ, so no two axes can be swapped.
 * The second form expands the initial data by FFTW and evolves them.
 *
 * Restrictions: A < Tm, so that T > 0; modes 0 to 12, mode_x at least 1. */
#include "references/params.h"
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { WIDTH, HEIGHT, DEPTH, KAPPA_X, KAPPA_Y, KAPPA_Z, MODE_X, MODE_Y, MODE_Z, TM, A, T_END };

static const struct param params[] = {
    {"width", 1, "m", "extent along x", NULL},
    {"height", 0.8, "m", "extent along y", NULL},
    {"depth", 1.2, "m", "extent along z", NULL},
    {"kappa_x", 0.01, "m^2/s", "diffusivity along x", NULL},
    {"kappa_y", 0.008, "m^2/s", "diffusivity along y", NULL},
    {"kappa_z", 0.012, "m^2/s", "diffusivity along z", NULL},
    {"mode_x", 2, "", "number of half waves along x, an integer", NULL},
    {"mode_y", 1, "", "number of half waves along y, an integer", NULL},
    {"mode_z", 3, "", "number of half waves along z, an integer", NULL},
    {"Tm", 1, "K", "mean temperature", NULL},
    {"A", 0.7, "K", "initial amplitude of the mode, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param;
    double q[3], rate = 0, turns = 0;
    for (int a = 0; a < 3; a++) {
        q[a] = v[MODE_X + a] * M_PI / v[WIDTH + a];
        rate += v[KAPPA_X + a] * q[a] * q[a];
        turns += q[a] * fabs(x[a]);
    }
    double amplitude = v[A] * exp(-rate * t), rounding = DBL_EPSILON * amplitude * (8 + 2 * turns + 8 * rate * t);
    struct exact e = {.temperature = amplitude, .error_bound = rounding + DBL_EPSILON * v[TM]};
    for (int a = 0; a < 3; a++) {
        e.temperature *= cos(q[a] * x[a]);
        e.gradient[a] = -amplitude * q[a];
        for (int b = 0; b < 3; b++) e.gradient[a] *= a == b ? sin(q[b] * x[b]) : cos(q[b] * x[b]);
        e.gradient_bound[a] = q[a] * rounding;
    }
    e.temperature += v[TM];
    return e;
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE_X, MODE_Y, MODE_Z, -1};
    const double *v = p->param;
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, v[TM], "the temperature stays positive, A < Tm", why)) return STATUS_INPUT;
    p->dim = 3;
    params_material(p, v[KAPPA_X], v[KAPPA_Y], 1);
    p->material[0].k[2] = v[KAPPA_Z];
    for (int a = 0; a < 3; a++) {
        if (params_whole(params, p, MODE_X + a, a == 0, 12, why)) return STATUS_INPUT;
        p->hi[a] = v[WIDTH + a];
        p->side[2 * a] = p->side[2 * a + 1] = NEUMANN;
        p->mirror[a] = (int)v[MODE_X + a] % 2 == 0;
    }
    p->initial = initial;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    int n[3];
    for (int a = 0; a < 3; a++) n[a] = 4 * (int)p->param[MODE_X + a] + 4;
    struct spectral *s = spectral_alloc(p, n, initial);
    struct exact e = spectral_at(s, x, t);
    spectral_free(s);
    return e;
}

const struct scene scene_box_cosine = {
    .name = "box-cosine",
    .about = "one oblique cosine mode of an insulated box: smooth data in three dimensions",
    .citation = "Carslaw and Jaeger 1959, section 6.2",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.9, 1.1, 0.017, 0.0071, 0.011, 2, 1, 3, 1.1, 0.6, 1.7}, 1, 0.02, 0.1},
};
