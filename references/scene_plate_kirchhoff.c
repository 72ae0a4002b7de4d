/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plate-kirchhoff: a rectangle with k = k_0 (1 + beta (T - T_ref)), a source and walls of all three kinds.
 *
 *     rho_c dT/dt = div(k grad T) + G  on [0, width] x [0, height]
 *     T = S + Z,   S = Tm + B exp(0.8 x/width) cos(1.1 y/height + 0.4),
 *     Z = A sin^2(pi x/width) sin^2(pi y/height) exp(-lambda t),   lambda = 2 k_0 ((pi/width)^2 +
 * (pi/height)^2)/rho_c G = rho_c Z_t - k lap T - k_0 beta |grad T|^2
 *
 * (method of manufactured solutions, Roache 2002).  Z and its slope vanish on every wall, so the walls are steady and
 * follow from S: temperatures at x = 0 and y = height, the flux k dS/dn at y = 0, and air of S + k/b dS/dn at
 * x = width.  All of them vary along the walls and agree at the corners.
 *
 * Second form: S from complex exponentials, Z from 4 sin^2 a sin^2 b = (1 - cos 2a) (1 - cos 2b).
 *
 * Restrictions: k > 0 from Tm to Tm + 2.06 B + A; A >= 0. */
#include "references/kirchhoff.h"
#include "references/params.h"

#include "solver/status.h"

#include <complex.h>
#include <float.h>
#include <math.h>

enum { WIDTH, HEIGHT, K_0, BETA, T_REF, RHO_C, TM, B, A, H, T_END };

static const struct param params[] = {
    {"width", 1, "m", "extent along x: held at x = 0, air at x = width", NULL},
    {"height", 0.7, "m", "extent along y: a given flux at y = 0, held at y = height", NULL},
    {"k_0", 0.01, "W/m/K", "conductivity at T_ref", NULL},
    {"beta", 1.1, "1/K", "relative change of the conductivity with temperature", NULL},
    {"T_ref", 0.9, "K", "temperature at which k = k_0", NULL},
    {"rho_c", 1.7, "J/m^3/K", "heat capacity", NULL},
    {"Tm", 1, "K", "level of the steady part", NULL},
    {"B", 0.5, "K", "variation of the steady part", NULL},
    {"A", 0.8, "K", "initial amplitude of the decaying part", NULL},
    {"b", 0.03, "W/m^2/K", "heat transfer coefficient at x = width", NULL},
    {"t_end", 2, "s", "end time", NULL},
    {NULL, 0, NULL, NULL, NULL},
};

static const double rate_x = 0.8, rate_y = 1.1, phase_y = 0.4; /* constants of S */

/* A temperature with its gradient and Laplacian */
struct profile {
    double T, gradient[2], laplacian;
};

static struct profile steady(const struct problem *p, const double *x) {
    double a = rate_x / p->param[WIDTH], b = rate_y / p->param[HEIGHT], size = p->param[B] * exp(a * x[0]);
    double c = size * cos(b * x[1] + phase_y), s = size * sin(b * x[1] + phase_y);
    return (struct profile){p->param[TM] + c, {a * c, -b * s}, (a * a - b * b) * c};
}

static double decay(const struct problem *p) {
    double a = M_PI / p->param[WIDTH], b = M_PI / p->param[HEIGHT];
    return 2 * p->k_0 * (a * a + b * b) / p->param[RHO_C];
}

static struct profile transient(const struct problem *p, const double *x, double t) {
    double left = p->param[A] * exp(-fmin(decay(p) * t, 800)), f[2], d[2], dd[2];
    for (int i = 0; i < 2; i++) {
        double q = M_PI / p->param[i ? HEIGHT : WIDTH], s = sin(q * x[i]);
        f[i] = s * s, d[i] = q * sin(2 * q * x[i]), dd[i] = 2 * q * q * cos(2 * q * x[i]);
    }
    return (struct profile){
        left * f[0] * f[1], {left * d[0] * f[1], left * f[0] * d[1]}, left * (dd[0] * f[1] + f[0] * dd[1])};
}

static double source_at(const struct problem *p, const double *x, double t) {
    struct profile S = steady(p, x), Z = transient(p, x, t);
    double square = 0;
    for (int a = 0; a < 2; a++) square += (S.gradient[a] + Z.gradient[a]) * (S.gradient[a] + Z.gradient[a]);
    return -p->param[RHO_C] * decay(p) * Z.T - kirchhoff_k(p, S.T + Z.T) * (S.laplacian + Z.laplacian) -
           p->k_0 * p->k_beta * square;
}

static double wall(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    double at[2] = {x[0], x[1]};
    at[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
    struct profile S = steady(p, at);
    double flux = kirchhoff_k(p, S.T) * S.gradient[s / 2] * (s % 2 ? 1 : -1);
    if (p->side[s] == NEUMANN) return flux;
    return p->side[s] == ROBIN ? S.T + flux / p->robin[s] : S.T;
}

static struct exact exact(const struct problem *p, const void *shared, const double *x, double t) {
    (void)shared;
    struct profile S = steady(p, x), Z = transient(p, x, t);
    double size = fabs(p->param[TM]) + 3 * p->param[B], exponent = fmin(decay(p) * t, 800);
    double left = p->param[A] * exp(-exponent), error = DBL_EPSILON * (8 * size + left * (16 + 6 * exponent));
    double inverse = 8 / p->param[WIDTH] + 8 / p->param[HEIGHT];
    return (struct exact){.temperature = S.T + Z.T,
                          .error_bound = error,
                          .gradient = {S.gradient[0] + Z.gradient[0], S.gradient[1] + Z.gradient[1]},
                          .gradient_bound = {error * inverse, error * inverse}};
}

static double initial(const struct problem *p, const double *x) {
    return steady(p, x).T + transient(p, x, 0).T;
}

static int setup(struct problem *p, struct failure *why) {
    static const int any[] = {BETA, T_REF, TM, A, -1}, law[3] = {K_0, BETA, T_REF};
    if (params_start(params, p, any, why)) return STATUS_INPUT;
    const double *v = p->param;
    if (!(v[A] >= 0)) return refuse(why, STATUS_INPUT, "--set A=%g: needs a number of 0 K or more", v[A]);
    p->dim = 2;
    p->hi[0] = v[WIDTH];
    p->hi[1] = v[HEIGHT];
    if (kirchhoff_linear(params, p, law, v[RHO_C], v[TM], v[TM] + 2.06 * v[B] + v[A], why)) return STATUS_INPUT;
    p->side[X_HI] = ROBIN;
    p->robin[X_HI] = v[H];
    p->side[Y_LO] = NEUMANN;
    p->initial = initial;
    p->wall = wall;
    p->source_at = source_at;
    return STATUS_OK;
}

static struct exact second(const struct problem *p, const double *x, double t) {
    const double *v = p->param;
    double complex z = rate_x * x[0] / v[WIDTH] + I * (rate_y * x[1] / v[HEIGHT] + phase_y);
    double Z = v[A] / 4 * (1 - cos(2 * M_PI * x[0] / v[WIDTH])) * (1 - cos(2 * M_PI * x[1] / v[HEIGHT]));
    struct exact e = exact(p, NULL, x, t);
    return (struct exact){.temperature = v[TM] + v[B] * creal(cexp(z)) + Z / exp(fmin(decay(p) * t, 700)),
                          .error_bound = 2 * e.error_bound};
}

const struct scene scene_plate_kirchhoff = {
    .name = "plate-kirchhoff",
    .about = "a rectangle with k linear in T, a source and walls of all three kinds: smooth",
    .citation = "manufactured; method: Roache 2002, J. Fluids Eng. 124:4",
    .params = params,
    .setup = setup,
    .exact = exact,
    .second = second,
    .odd = {{0.9, 0.6, 0.013, 0.7, 1.3, 1.9, 1.1, 0.4, 0.6, 0.023, 1.7}, 2, 0.012, 0.1},
};
