/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_ODD_PROBLEMS_H
#define HEATLADDER_VERIFICATION_UNIT_ODD_PROBLEMS_H

/* A small problem with every number its own, for tests of the particle code. */

#include "solver/problem.h"

#include <math.h>

/* kappa_x = 0.7/1.3, kappa_y = 0.4/1.3; walls at 0.3, 0.8 K (x) and with fluxes 0.11, -0.23 W m^-2 (y) */
static double odd_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    static const double value[SIDES] = {0.3, 0.8, 0.11, -0.23, 0.47, 0.19};
    (void)p, (void)x;
    return value[s];
}

static double odd_start(const struct problem *p, const double x[2]) {
    (void)p;
    return 0.37 + sin(2.1 * x[0] + 0.4) * cos(1.3 * x[1] - 0.2);
}

static inline struct problem odd_rectangle(void) {
    return (struct problem){.dim = 2,
                            .lo = {-0.35, 0.2},
                            .hi = {1.15, 1.4},
                            .t_end = 0.0173,
                            .materials = 1,
                            .material = {{{0.7, 0.4}, 1.3}},
                            .side = {DIRICHLET, DIRICHLET, NEUMANN, NEUMANN},
                            .initial = odd_start,
                            .wall = odd_wall};
}

static inline double odd_start_in_space(const struct problem *p, const double *x) {
    return odd_start(p, x) * cos(0.9 * x[2] + 0.1);
}

/* The rectangle with kappa_z = 0.55/1.3 and 0.47, 0.19 K on the walls of z. */
static inline struct problem odd_box(void) {
    struct problem p = odd_rectangle();
    p.dim = 3;
    p.lo[2] = -0.1, p.hi[2] = 0.8;
    p.material[0].k[2] = 0.55;
    p.side[Z_LO] = p.side[Z_HI] = DIRICHLET;
    p.initial = odd_start_in_space;
    return p;
}

/* sum c[a][b] x^a y^b, a + b <= 3, differentiated da and db times */
static inline double steady_derivative(const double x[2], int da, int db) {
    static const double c[4][4] = {{0.31, -0.59, 0.43, 0.17}, {0.77, 0.37, 0.11}, {-0.22, -0.19}, {0.13}};
    double sum = 0;
    for (int a = da; a < 4; a++)
        for (int b = db; a + b < 4; b++)
            sum += c[a][b] * tgamma(a + 1) / tgamma(a - da + 1) * tgamma(b + 1) / tgamma(b - db + 1) *
                   pow(x[0], a - da) * pow(x[1], b - db);
    return sum;
}

/* A steady solution of the problem with the source below, and the data of each side; also for a rod. */
static inline double steady_cubic(const struct problem *p, const double x[2]) {
    (void)p;
    return steady_derivative(x, 0, 0);
}

static inline double steady_source(const struct problem *p, const double x[2]) {
    const double *k = p->material[0].k;
    return -k[0] * steady_derivative(x, 2, 0) - (p->dim == 2 ? k[1] * steady_derivative(x, 0, 2) : 0);
}

static inline double steady_wall(const struct problem *p, enum side s, const double x[2], double t) {
    (void)t;
    int axis = (int)s / 2, out = s % 2 ? 1 : -1;
    double slope = steady_derivative(x, axis == 0, axis == 1);
    return p->side[s] == DIRICHLET ? steady_derivative(x, 0, 0) : out * p->material[0].k[axis] * slope;
}

static inline struct problem odd_rod(void) {
    struct problem p = odd_rectangle();
    p.dim = 1;
    p.lo[1] = p.hi[1] = 0;
    return p;
}

#endif
