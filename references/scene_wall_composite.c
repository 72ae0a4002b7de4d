/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wall-composite: a wall of two layers is heated from one side until the heat flux is steady.
 *
 *     rho_c dT/dt = d/dx(k dT/dx)  on [0, L],   (k1, rho_c1) for x < x_c, (k2, rho_c2) for x >= x_c,
 *     T(0, t) = T1,   T(L, t) = T2,   T(x, 0) = T2
 *
 * At x_c the flux q is continuous, and T falls by R q.  In the steady state the same flux crosses layers and contact
 * in series, q = (T1 - T2)/(x_c/k1 + R + (L - x_c)/k2), and T is linear in each layer (Carslaw and Jaeger 1959,
 * section 3.2).  Transient modes are added; while they are too many, the Laplace transform is used (layers.c).  Each
 * form checks the other.
 *
 * End time: at the defaults the slowest mode decays at 15.4 s^-1 (nearly kappa1 (pi/(2 x_c))^2, an insulated first
 * layer, since k2 << k1).  At t_end = 2.5 s exp(-15.4 t_end) = 1.9e-17, so the wall is steady to round-off.
 *
 * Restrictions: 0 < x_c < L; T1 != T2. */
#include "references/layers.h"
#include "references/params.h"

#include "solver/status.h"

#include <math.h>
#include <stdlib.h>

enum { L, X_C, K1, RHO_C1, T1, K2, RHO_C2, T2, R, T_END };

static const struct param params[] = {
    {"L", 1, "m", "thickness of the wall", NULL},
    {"x_c", 0.4, "m", "position of the contact, between 0 and L", NULL},
    {"k1", 1, "W/m/K", "conductivity at x < x_c", NULL},
    {"rho_c1", 1, "J/m^3/K", "heat capacity at x < x_c", NULL},
    {"T1", 1, "K", "temperature at x = 0", NULL},
    {"k2", 0.001, "W/m/K", "conductivity at x > x_c", NULL},
    {"rho_c2", 0.001, "J/m^3/K", "heat capacity at x > x_c", NULL},
    {"T2", 0, "K", "temperature at x = L, also the initial temperature", NULL},
    {"R", 0, "m^2 K/W", "resistance of the contact, 0: none", NULL},
    {"t_end", 2.5, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T1, T2, R, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (params_between(params, p, X_C, 0, p->param[L], "the contact is inside the wall, x_c < L", why))
        return STATUS_INPUT;
    if (params_within(params, p, R, 0, 1e300, "resistances are not negative", why)) return STATUS_INPUT;
    if (p->param[T1] == p->param[T2])
        return refuse(why, STATUS_INPUT,
                      "--set T1=%g: needs a temperature other than T2=%g; with equal ones no heat flows",
                      p->param[T1], p->param[T2]);
    p->dim = 1;
    p->hi[0] = p->param[L];
    p->interface = p->param[X_C];
    p->resistance = p->param[R];
    params_material(p, p->param[K1], p->param[K1], p->param[RHO_C1]);
    params_material(p, p->param[K2], p->param[K2], p->param[RHO_C2]);
    p->start = p->held[X_HI] = p->param[T2];
    p->held[X_LO] = p->param[T1];
    return STATUS_OK;
}

static struct layers layers_of(const struct problem *p) {
    const double *v = p->param;
    return (struct layers){.width = {v[X_C], v[L] - v[X_C]},
                           .k = {v[K1], v[K2]},
                           .rho_c = {v[RHO_C1], v[RHO_C2]},
                           .wall = {v[T1], v[T2]},
                           .start = {v[T2], v[T2]},
                           .R = v[R]};
}

/* Modes if there are few, else the contour. */
struct shared {
    int by_modes;
    struct layers_contour contour;
    struct layers_modes modes;
};

enum { FEW = 40 };

static struct shared *share(const struct problem *p, double t, int other) {
    struct shared *s = xcalloc(1, sizeof *s);
    struct layers w = layers_of(p);
    if (t == 0) return s;
    s->by_modes = (layers_modes_needed(&w, t) <= FEW) != other;
    if (s->by_modes)
        layers_modes(&w, t, &s->modes);
    else
        layers_contour(&w, t, &s->contour);
    return s;
}

static void *prepare(const struct problem *p, double t) {
    return share(p, t, 0);
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    const struct shared *s = shared;
    double from = x[0] - p->param[X_C];
    if (p->resistance > 0 && fabs(from) < 1e-12 * p->param[L]) from = 0; /* the second layer has the contact */
    if (t == 0) return (struct exact){.temperature = p->start};
    struct curve T = s->by_modes ? layers_modes_at(&s->modes, from) : layers_contour_at(&s->contour, from);
    return (struct exact){.temperature = T.at.value,
                          .error_bound = T.at.error,
                          .gradient = {T.slope.value},
                          .gradient_bound = {T.slope.error}};
}

static struct exact second(const struct problem *p, const double *x, double t) {
    struct shared *s = share(p, t, 1);
    struct exact e = exact(p, s, x, t);
    free(s);
    return e;
}

const struct scene scene_wall_composite = {
    .name = "wall-composite",
    .about = "a wall of two layers, run to the steady state: a conductivity ratio of 1000",
    .citation = "Carslaw and Jaeger 1959, section 3.2",
    .params = params,
    .setup = setup,
    .prepare = prepare,
    .exact = exact,
    .second = second,
    .odd = {{1.1, 0.37, 0.9, 1.3, 1.2, 0.013, 0.021, 0.3, 0, 4}, 1, 0.01, 0.5},
};
