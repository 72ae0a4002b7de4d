/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_WALLS_H
#define HEATLADDER_SOLVER_PARTICLES_WALLS_H

/* Walls of a cut lattice: by dummies, linear combinations of particles plus a constant, or by rows of the particles.
 */

#include "solver/space/operator.h"

/* Particles that a quadratic at a wall requires, by dim (walls.c). */
static const size_t walls_least[] = {0, 4, 15, 60};

/* The axis along which a normal points, or nearly so. */
static inline int walls_axis(const double normal[DIM_MAX]) {
    int axis = 0;
    for (int a = 1; a < DIM_MAX; a++)
        if (normal[a] * normal[a] > 0.5) axis = a;
    return axis;
}

/* 1 if these walls support the law: those without dummies support all. */
int walls_support(enum walls walls, const struct wall_law *law);

/* Sets the values of the dummies of *c by the treatment of the options. */
int walls_fill(const struct problem *p, const struct options *o, struct cloud *c, double spacing,
               struct failure *why);

/* `at_wall` (operator.h) of SSPH, by its own least squares. */
int walls_one_sided(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                    struct wall_row *out, struct failure *why);

#endif
