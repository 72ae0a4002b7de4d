/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-gauss: a Gaussian spreads along a rod (Song, Xing, Hou, Lu 2018, section 5.1).
 *
 *     dT/dt = kappa d2T/dx2,   T(x, 0) = M/sqrt(2 pi sigma0^2) exp(-x^2/(2 sigma0^2))        (47)
 *     g(x, t) = sigma0/sigma exp(-x^2/(2 sigma^2)),   sigma^2 = sigma0^2 + 2 kappa t          (48)
 *
 * Here M = sqrt(2 pi sigma0^2), an amplitude of 1 K.  Eq. 48 is the solution on the infinite line.  A run needs
 * walls, so this scene has Dirichlet walls at -L and L, held at zero, with initial data that vanish there:
 *
 *     T(x, t) = sum_k (-1)^k g(x - 2kL, t)
 *             = sum_n sqrt(2 pi) sigma0/L exp(-q^2 sigma^2/2) cos(q x),   q = (n + 1/2) pi/L
 *
 * for all t >= 0.  Eqs. 47-48 do not vanish at the walls.  The difference is largest there: exp(-L^2/(2
 * sigma0^2)) = 6.1e-13 K initially and 1.2e-12 K at t_end, at the default parameters.
 *
 * Restrictions: sigma0 < L, so that a peak remains between the walls. */
#include "references/params.h"
#include "references/series.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, SIGMA0, KAPPA, T_END };

static const struct param params[] = {
    {"L", 15, "m", "half length of the rod, walls at -L and L", NULL},
    {"sigma0", 2, "m", "initial standard deviation of the Gaussian, below L", NULL},
    {"kappa", 0.01, "m^2/s", "diffusivity", NULL},
    {"t_end", 5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double sigma_at(const struct problem *p, double t) {
    return sqrt(p->param[SIGMA0] * p->param[SIGMA0] + 2 * p->param[KAPPA] * t);
}

static struct exact scaled(const struct problem *p, double sigma, struct curve g) {
    double peak = p->param[SIGMA0] / sigma, rounding = 3 * DBL_EPSILON; /* relative to peak */
    return (struct exact){.temperature = peak * g.at.value,
                          .error_bound = peak * (g.at.error + rounding * fabs(g.at.value)),
                          .gradient = {peak * g.slope.value},
                          .gradient_bound = {peak * (g.slope.error + rounding * fabs(g.slope.value))}};
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    double sigma = sigma_at(p, t);
    return scaled(p, sigma, series_gauss(x[0], p->param[L], sigma));
}

static struct exact second(const struct problem *p, const double *x, double t) {
    double sigma = sigma_at(p, t);
    return scaled(p, sigma, series_gauss_other(x[0], p->param[L], sigma));
}

static double published(const struct problem *p, const double *x, double t) {
    double sigma = sigma_at(p, t), z = x[0] / sigma;
    return p->param[SIGMA0] / sigma * exp(-z * z / 2);
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    if (params_start(params, p, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, SIGMA0, 0, p->param[L], "the Gaussian fits between the walls, sigma0 < L", why))
        return STATUS_INPUT;
    p->dim = 1;
    p->lo[0] = -p->param[L];
    p->hi[0] = p->param[L];
    params_material(p, p->param[KAPPA], p->param[KAPPA], 1);
    p->mirror[0] = 1;
    p->initial = initial;
    return STATUS_OK;
}

const struct scene scene_rod_gauss = {
    .name = "rod-gauss",
    .about = "a Gaussian in a rod between cold walls: smooth data",
    .citation = "Song, Xing, Hou, Lu 2018, section 5.1, eqs. 47-48",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .published = published,
    .odd = {{11, 1.9, 0.017, 4.3}, 1, 0.1, 0.1},
};
