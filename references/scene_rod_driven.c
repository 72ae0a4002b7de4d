/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-driven: a rod whose end x = 0 follows a periodic temperature.
 *
 *     dT/dt = kappa d2T/dx2  on [0, L],   T(0, t) = Tm + A cos(omega t + phase),   T(L, t) = Tm
 *
 * The start is the periodic state at t = 0, so no transient hides an order:
 *
 *     T = Tm + Re[A exp(i (omega t + phase)) sinh(p (L - x))/sinh(p L)],   p = sqrt(i omega/kappa)
 *
 * (Carslaw and Jaeger 1959, sections 2.6 and 3.6).  With p = q (1 + i), q = sqrt(omega/(2 kappa)), the second form
 * is the sum of the damped waves A exp(-q x) cos(omega t + phase - q x) that both ends reflect with the opposite
 * sign.
 *
 * Restrictions: A < Tm, so that T > 0. */
#include "references/driven.h"
#include "references/params.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>

enum { L, KAPPA, TM, A, OMEGA, PHASE, T_END };

static const struct param params[] = {
    {"L", 1, "m", "length of the rod, ends at 0 and L", NULL},
    {"kappa", 0.02, "m^2/s", "diffusivity", NULL},
    {"Tm", 2, "K", "mean temperature, and that of the end x = L", NULL},
    {"A", 1.5, "K", "amplitude of the end x = 0, below Tm", NULL},
    {"omega", 0.5, "1/s", "angular frequency of the end x = 0", NULL},
    {"phase", 0.4, "", "its phase at t = 0, rad", NULL},
    {"t_end", 8, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    const double *v = p->param;
    (void)x;
    return v[TM] + (s == X_LO ? v[A] * cos(v[OMEGA] * t + v[PHASE]) : 0);
}

static double wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    const double *v = p->param;
    (void)x;
    return s == X_LO ? -v[A] * v[OMEGA] * sin(v[OMEGA] * t + v[PHASE]) : 0;
}

static struct driven wave_of(const double *v) {
    return (struct driven){.p = csqrt(I * (v[OMEGA] / v[KAPPA])), .size = v[A], .loss = 0, .L = v[L], .far = -1};
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    const double *v = p->param, turned = v[OMEGA] * t;
    struct driven wave = wave_of(v);
    struct curve u = driven_now(&wave, x[0], turned + v[PHASE], turned + fabs(v[PHASE]));
    return (struct exact){.temperature = v[TM] + u.at.value,
                          .error_bound = u.at.error + DBL_EPSILON * v[TM],
                          .gradient = {u.slope.value},
                          .gradient_bound = {u.slope.error}};
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param, q = sqrt(v[OMEGA] / v[KAPPA] / 2), turned = v[OMEGA] * t;
    struct driven wave = wave_of(v);
    wave.p = q + I * q;
    struct approx u = driven_reflected(&wave, x[0], turned + v[PHASE], turned + fabs(v[PHASE]));
    return (struct exact){.temperature = v[TM] + u.value, .error_bound = u.error + DBL_EPSILON * v[TM]};
}

static double initial(const struct problem *p, const double *x) {
    return exact(p, NULL, x, 0).temperature;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {PHASE, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, PHASE, -100, 100, NULL, why)) return STATUS_INPUT;
    if (params_between(params, p, A, 0, p->param[TM], "the temperature stays positive, A < Tm", why))
        return STATUS_INPUT;
    p->dim = 1;
    p->hi[0] = p->param[L];
    params_material(p, p->param[KAPPA], p->param[KAPPA], 1);
    p->initial = initial;
    p->wall = wall;
    p->wall_rate = wall_rate;
    return STATUS_OK;
}

const struct scene scene_rod_driven = {
    .name = "rod-driven",
    .about = "a rod whose end follows a periodic temperature: a wall that changes in time",
    .citation = "Carslaw and Jaeger 1959, sections 2.6 and 3.6",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.83, 0.017, 2.3, 1.7, 0.61, -0.37, 5.1}, 2, 0.01, 0.7},
};
