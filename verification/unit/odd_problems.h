#ifndef HEATLADDER_VERIFICATION_UNIT_ODD_PROBLEMS_H
#define HEATLADDER_VERIFICATION_UNIT_ODD_PROBLEMS_H

/* A small problem with every number its own, for tests of the particle code. */

#include "solver/space/layout.h"
#include "solver/problem.h"

#include <math.h>

/* kappa_x = 0.7/1.3, kappa_y = 0.4/1.3; walls at 0.3, 0.8 K (x) and with fluxes 0.11, -0.23 W m^-2 (y) */
static double odd_wall(const struct problem *p, enum side s, const double x[2]) {
    static const double value[4] = {0.3, 0.8, 0.11, -0.23};
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

static inline struct problem odd_rod(void) {
    struct problem p = odd_rectangle();
    p.dim = 1;
    p.lo[1] = p.hi[1] = 0;
    return p;
}

#endif
