/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_FTCS_PROBLEMS_H
#define HEATLADDER_VERIFICATION_UNIT_FTCS_PROBLEMS_H

/* Rods, planes and boxes for the tests of the finite differences; no two of their numbers are equal. */

#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */
#include "solver/problem.h"
#include "verification/unit/near.h"

extern const struct method method_ftcs, method_ftcs_flux;

static const double PI = 3.14159265358979323846;

/* Their parameters p->param[] are two mode numbers, a level and an amplitude; DEEP is the mode number along z. */
enum { DEEP = 5 };

static inline double number_of(const struct problem *p, int axis) {
    return p->param[axis < 2 ? axis : DEEP];
}

/* Vanishes at the walls of p where they are DIRICHLET, has no slope where they are NEUMANN. */
static inline double mode(const struct problem *p, const double *x) {
    double T = 1;
    for (int a = 0; a < p->dim; a++) {
        double phase = number_of(p, a) * PI * (x[a] - p->lo[a]) / (p->hi[a] - p->lo[a]);
        T *= p->side[2 * a] == DIRICHLET ? sin(phase) : cos(phase);
    }
    return p->param[2] + p->param[3] * T;
}

static inline double level(const struct problem *p, enum side s, const double x[2], double t) {
    (void)x, (void)t;
    return p->side[s] == DIRICHLET ? p->param[2] : 0;
}

static inline struct problem rod(int number) {
    return (struct problem){.dim = 1,
                            .lo = {-0.7, 0},
                            .hi = {1.6, 0},
                            .t_end = 0.37,
                            .materials = 1,
                            .material = {{{0.29, 0.71}, 2.385}},
                            .param = {number, 0, 0.83, 1.9},
                            .initial = mode,
                            .wall = level};
}

static inline struct problem plane(int along, int up) {
    struct problem p = rod(along);
    p.dim = 2;
    p.lo[1] = 0.2;
    p.hi[1] = 1.58; /* 2.3 by 1.38 m: 0.023 divides both */
    p.param[1] = up;
    p.side[Y_LO] = p.side[Y_HI] = NEUMANN;
    return p;
}

/* 0.046, 0.115 and 0.23 m divide its sides. */
static inline struct problem box(int along, int up, int deep) {
    struct problem p = plane(along, up);
    p.dim = 3;
    p.lo[2] = -0.31, p.hi[2] = 0.61;
    p.material[0].k[2] = 0.43;
    p.param[DEEP] = deep;
    p.side[Z_LO] = p.side[Z_HI] = DIRICHLET;
    return p;
}

/* -dx^2/kappa times the symbol on a mode, along one axis. */
static inline double symbol(const struct method *m, double number, double dx, double extent) {
    double phase = number * PI * dx / extent;
    return m == &method_ftcs ? 4 * pow(sin(phase / 2), 2) : pow(sin(phase), 2);
}

/* Factor of the mode in one Euler step. */
static inline double gain_of(const struct method *m, const struct problem *p, double dx, double dt) {
    double gain = 1;
    for (int a = 0; a < p->dim; a++)
        gain -= p->material[0].k[a] / p->material[0].rho_c * dt / (dx * dx) *
                symbol(m, number_of(p, a), dx, p->hi[a] - p->lo[a]);
    return gain;
}

static inline struct field solved(const struct method *m, const struct problem *p, const struct options *o) {
    struct field f;
    struct failure why = {0};
    if (method_solve(m, p, o, &f, &why)) fail_msg("%s", why.text);
    return f;
}

/* Largest |T - (level + amplitude * factor * mode)|. */
static inline double mode_error(const struct problem *p, const struct field *f, double factor) {
    double worst = 0;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        double want = p->param[2] + factor * (mode(p, x) - p->param[2]);
        worst = fmax(worst, fabs(f->T[i] - want));
    }
    return worst;
}

/* Largest |T - the initial data of p|. */
static inline double furthest_from_start(const struct problem *p, const struct field *f) {
    double worst = 0, x[DIM_MAX];
    for (size_t i = 0; i < f->n; i++) {
        field_place(f, i, x);
        double apart = fabs(f->T[i] - p->initial(p, x));
        if (!(apart <= worst)) worst = apart;
    }
    return worst;
}

/* ---- T = quadratic(x) + drift t line(x), with the source and the walls that it needs ---- */

enum { DRIFT = 10 }; /* p->param[]: K s^-1 */
static const double slope_of[DIM_MAX] = {1.1, -0.7, 0.4}, bend_of[DIM_MAX] = {1.7, -0.9, 2.3},
                    slant_of[DIM_MAX] = {0.6, 1.3, -0.8}, /* yz, zx, xy */
    drift_of[DIM_MAX] = {0.8, 1.9, -1.2};

/* A Robin wall is exact for T without a second derivative across it. */
static inline double bend(const struct problem *p, int axis) {
    return p->side[2 * axis] == ROBIN || p->side[2 * axis + 1] == ROBIN ? 0 : bend_of[axis];
}

static inline double line_at(const struct problem *p, const double *x) {
    double T = 0.6;
    for (int a = 0; a < p->dim; a++) T += drift_of[a] * x[a];
    return T;
}

static inline double quadratic_at(const struct problem *p, const double *x, double t) {
    double T = 0.31 + p->param[DRIFT] * t * line_at(p, x);
    for (int a = 0; a < p->dim; a++) T += slope_of[a] * x[a] + bend(p, a) / 2 * x[a] * x[a];
    if (p->dim > 1) T += slant_of[2] * x[0] * x[1];
    return p->dim > 2 ? T + slant_of[0] * x[1] * x[2] + slant_of[1] * x[2] * x[0] : T;
}

static inline double quadratic(const struct problem *p, const double *x) {
    return quadratic_at(p, x, 0);
}

static inline double quadratic_wall(const struct problem *p, enum side s, const double *x, double t) {
    const int a = (int)s / 2;
    double flux = slope_of[a] + bend(p, a) * x[a] + p->param[DRIFT] * t * drift_of[a];
    for (int b = 0; b < p->dim; b++)
        if (b != a) flux += slant_of[3 - a - b] * x[b];
    flux *= p->material[0].k[a] * (s % 2 ? 1 : -1);
    if (p->side[s] == NEUMANN) return flux;
    return quadratic_at(p, x, t) + (p->side[s] == ROBIN ? flux / p->robin[s] : 0);
}

static inline double quadratic_wall_rate(const struct problem *p, enum side s, const double *x, double t) {
    (void)t;
    return quadratic_wall(p, s, x, 1) - quadratic_wall(p, s, x, 0);
}

static inline double quadratic_source(const struct problem *p, const double *x) {
    double G = p->material[0].rho_c * p->param[DRIFT] * line_at(p, x);
    for (int a = 0; a < p->dim; a++) G -= p->material[0].k[a] * bend(p, a);
    return G;
}

static inline void quadratic_data(struct problem *p, double drift) {
    p->initial = quadratic, p->wall = quadratic_wall, p->source = quadratic_source;
    p->param[DRIFT] = drift;
    if (drift != 0) p->wall_rate = quadratic_wall_rate;
}

#endif
