/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rod-cooling: an initially warm rod, held at one end and cooled by air at the other.
 *
 *     rho_c dT/dt = k d2T/dx2  on [0, L],   T(0, t) = T1,   -k dT/dx = b (T - T_a) at x = L,   T(x, 0) = T0
 *
 * The condition at x = L is Song 2018 eq. 4 with the air at T_a.  With h = b/k, s = sqrt(4 k/rho_c t), u = T - T1:
 *
 *     late:   u = (T_a - T1) h x/(1 + h L) + sum_n c_n sin(q_n x) exp(-(q_n s/2)^2),   q_n L cot(q_n L) = -h L
 *             c_n = ((T0 - T1) (1 - cos(q_n L)) + (T_a - T1) cos(q_n L))/(q_n N_n),   N_n = integral of sin(q_n x)^2
 *     early:  T = T0 + (T1 - T0) erfc(x/s) + (T_a - T0) (erfc(d/s) - exp(h d + (h s/2)^2) erfc(d/s + h s/2)),
 *             d = L - x
 *
 * (Carslaw and Jaeger 1959, sections 3.9 to 3.11 and 2.7).  The early form holds for s <= 0.159 L, when the ends do
 * not yet interact: erfc(L/s) < 7e-19.  At b = 0 the end is insulated; as b tends to infinity its temperature tends
 * to T_a.  The second form inverts the Laplace transform, without roots or error functions.
 *
 * Restrictions: b >= 0. */
#include "references/cooling.h"
#include "references/params.h"
#include "references/talbot.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { L, K, RHO_C, T1, T0, B, T_A, T_END };

static const struct param params[] = {
    {"L", 0.3, "m", "length of the rod, ends at 0 and L", NULL},
    {"k", 52, "W/m/K", "conductivity", NULL},
    {"rho_c", 3.6e6, "J/m^3/K", "heat capacity", NULL},
    {"T1", 20, "K", "temperature of the end x = 0", NULL},
    {"T0", 100, "K", "initial temperature", NULL},
    {"b", 750, "W/m^2/K", "heat transfer coefficient of the end x = L, 0 or more", NULL},
    {"T_a", 5, "K", "temperature of the air at x = L", NULL},
    {"t_end", 600, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

enum { MODES = 48 }; /* 4.1 L/s + 1 modes are significant, with s > 0.159 L */
static const double early = 0.159, last_exponent = 41.5;

struct shared {
    double h, s; /* m^-1, m */
    int is_early;
    int modes; /* significant modes; 0 in the steady state */
    double q[MODES], size[MODES];
    double error[2]; /* K, K/m */
};

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {T1, T0, B, T_A, -1};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    if (!(p->param[B] >= 0))
        return refuse(why, STATUS_INPUT, "--set b=%g: needs a finite number, 0 W/m^2/K (insulated) or more",
                      p->param[B]);
    p->dim = 1;
    p->hi[0] = p->param[L];
    params_material(p, p->param[K], p->param[K], p->param[RHO_C]);
    p->side[X_HI] = ROBIN;
    p->robin[X_HI] = p->param[B];
    p->start = p->param[T0];
    p->held[X_LO] = p->param[T1];
    p->held[X_HI] = p->param[T_A];
    return STATUS_OK;
}

static double scale_of(const double *v) {
    return fabs(v[T0] - v[T1]) + fabs(v[T_A] - v[T1]);
}

static void add_modes(const double *v, struct shared *g) {
    for (int n = 1; n <= MODES; n++) {
        struct cooling_mode m = cooling_mode(n, 0, v[L], g->h);
        double exponent = pow(m.q * g->s / 2, 2), amplitude = exp(-exponent) / (m.q * m.norm);
        double size = (v[T0] - v[T1]) * (1 - m.end_cosine) + (v[T_A] - v[T1]) * m.end_cosine;
        if (exponent > last_exponent) return;
        g->q[g->modes] = m.q;
        g->size[g->modes++] = size * amplitude;
        double rounding = DBL_EPSILON * 2 * scale_of(v) * amplitude * (8 + 8 * exponent + 3 * n);
        g->error[0] += rounding;
        g->error[1] += m.q * rounding;
    }
}

static void *prepare(const struct problem *p, double t) {
    const double *v = p->param;
    struct shared *g = xcalloc(1, sizeof *g);
    g->h = v[B] / v[K];
    g->s = sqrt(4 * v[K] / v[RHO_C] * t);
    if (t == 0) return g;
    double all = DBL_EPSILON * (fabs(v[T1]) + fabs(v[T0]) + fabs(v[T_A]));
    g->error[0] = 4 * all + 1e-17 * scale_of(v);
    g->is_early = g->s <= early * v[L];
    if (!g->is_early) {
        g->error[1] = 8 * all / v[L];
        add_modes(v, g);
    } else {
        g->error[0] += 40 * DBL_EPSILON * scale_of(v);
        g->error[1] = 60 * DBL_EPSILON * scale_of(v) * (1 / g->s + fmin(g->h, 1 / g->s));
    }
    return g;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    const struct shared *g = shared;
    const double *v = p->param;
    struct exact e = {.temperature = v[T0], .error_bound = g->error[0], .gradient_bound = {g->error[1]}};
    if (t == 0) return e;
    if (g->is_early) {
        struct cooling_half cold = cooling_half(v[L] - x[0], g->h, g->s);
        double z = x[0] / g->s;
        e.temperature += (v[T1] - v[T0]) * erfc(z) + (v[T_A] - v[T0]) * (erfc((v[L] - x[0]) / g->s) - cold.end);
        e.gradient[0] = (v[T0] - v[T1]) * 2 / sqrt(M_PI) / g->s * exp(-z * z) + (v[T_A] - v[T0]) * cold.slope;
        return e;
    }
    e.gradient[0] = (v[T_A] - v[T1]) * g->h / (1 + g->h * v[L]);
    e.temperature = v[T1] + e.gradient[0] * x[0];
    for (int n = 0; n < g->modes; n++) {
        e.temperature += g->size[n] * sin(g->q[n] * x[0]);
        e.gradient[0] += g->size[n] * g->q[n] * cos(g->q[n] * x[0]);
    }
    return e;
}

/* The transform of T - T0 is ((T1 - T0) (k q cosh q d + b sinh q d) + (T_a - T0) b sinh q x)/z/(k q cosh q L + b
 * sinh q L), q = sqrt(z rho_c/k). */
static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    double d = v[L] - x[0], sum = 0;
    if (t == 0) return (struct exact){.temperature = v[T0]};
    for (int j = 0; j < TALBOT_NODES; j++) {
        double complex z, weight;
        talbot_node(j, &z, &weight);
        double complex q = csqrt(z) * (sqrt(v[RHO_C] / v[K]) / sqrt(t)), e = cexp(-q * d), f = cexp(-q * x[0]),
                       g = e * f;
        double complex held = f * (v[K] * q * (1 + e * e) + v[B] * talbot_one_less(q * d, e));
        double complex air = v[B] * e * talbot_one_less(q * x[0], f);
        sum += cimag(weight / z * ((v[T1] - v[T0]) * held + (v[T_A] - v[T0]) * air) /
                     (v[K] * q * (1 + g * g) + v[B] * talbot_one_less(q * v[L], g)));
    }
    return (struct exact){.temperature = v[T0] + sum, .error_bound = 4e-13 * scale_of(v) + 4e-16 * fabs(v[T0])};
}

const struct scene scene_rod_cooling = {
    .name = "rod-cooling",
    .about = "an initially warm rod, held at one end and cooled by air at the other",
    .citation = "Carslaw and Jaeger 1959, sections 2.7 and 3.9 to 3.11; the cooled end is Song 2018 eq. 4",
    .params = params,
    .odd = {{0.37, 41, 2.9e6, 31, 97, 630, 7, 450}, 90, 0.004, 200},
    .setup = setup,
    .prepare = prepare,
    .exact = exact,
    .second = second,
};
