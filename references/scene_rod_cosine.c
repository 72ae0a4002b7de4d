/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-cosine: one mode of an insulated rod.
 *
 *     dT/dt = kappa d2T/dx2  on [0, L],   dT/dx = 0 at both ends,   T(x, 0) = Tm + A cos(q x),   q = mode pi/L
 *
 * With insulated ends cos(q x) is an eigenfunction of the operator, with the eigenvalue -kappa q^2, so
 *
 *     T(x, t) = Tm + A cos(q x) exp(-kappa q^2 t)
 *
 * (Carslaw and Jaeger 1959, chapter 3).  The mean Tm keeps the heat content away from zero.  The exact heat content
 * is constant, so a wall that leaks heat shows as a drift.  At the defaults the mode decays to 0.32 of its initial
 * amplitude.  The second form expands the initial data by FFTW, without the eigenfunction.
 *
 * Restrictions: |A| < Tm, so that T > 0; mode <= 32. */
#include "references/params.h"
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, KAPPA, MODE, TM, A, T_END };

static const struct param params[] = {
    {"L", 1, "m", "length of the rod, ends at 0 and L", NULL},
    {"kappa", 0.013, "m^2/s", "diffusivity", NULL},
    {"mode", 3, "", "number of half waves along the rod, an integer", NULL},
    {"Tm", 1, "K", "mean temperature", NULL},
    {"A", 0.7, "K", "initial amplitude of the wave, below Tm", NULL},
    {"t_end", 1, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

/* Rounding: 4 eps relative in the rate, 2 eps relative in the phase. */
static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    double q = p->param[MODE] * M_PI / p->param[L], rate = p->param[KAPPA] * q * q;
    double amplitude = p->param[A] * exp(-rate * t), wave = amplitude * cos(q * x[0]);
    double rounding = DBL_EPSILON * amplitude * (4 + 2 * q * fabs(x[0]) + 5 * rate * t);
    return (struct exact){.temperature = p->param[TM] + wave,
                          .error_bound = rounding + DBL_EPSILON * p->param[TM],
                          .gradient = {-amplitude * q * sin(q * x[0])},
                          .gradient_bound = {q * rounding}};
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {MODE, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_whole(params, p, MODE, 1, 32, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, p->param[TM], "the temperature stays positive, A < Tm", why))
        return STATUS_INPUT;
    p->dim = 1;
    p->hi[0] = p->param[L];
    params_material(p, p->param[KAPPA], p->param[KAPPA], 1);
    for (int s = X_LO; s <= Y_HI; s++) p->side[s] = NEUMANN;
    p->mirror[0] = (int)p->param[MODE] % 2 == 0;
    p->initial = initial;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    static const int n[2] = {128, 1}; /* four times the highest mode */
    struct spectral *s = spectral_alloc(p, n, initial);
    struct exact e = spectral_at(s, x, t);
    spectral_free(s);
    return e;
}

const struct scene scene_rod_cosine = {
    .name = "rod-cosine",
    .about = "one cosine mode of an insulated rod: smooth data, zero flux at both ends",
    .citation = "Carslaw and Jaeger 1959, chapter 3",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{1.3, 0.017, 2, 1.1, 0.6, 1.7}, 1, 0.02, 0.1},
};
