/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_PLACE_H
#define HEATLADDER_SOLVER_SPACE_PLACE_H

#include "solver/space/layout.h"

/* Where the particles of a cloud are before anything moves them. */

/* The rows along y that a hexagonal cloud of spacing dx (m) has in a height (m). */
double place_rows(double height, double dx);

/* Position of the cell (i, j) of the lattice under the cloud, m. */
void place_position(const struct problem *p, const struct options *o, const struct lattice *l, int i, int j,
                    double x[2]);

/* Extent along an axis of the cell of a particle at x, m: l->dx but on graded clouds. */
double place_width(const struct problem *p, const struct options *o, const struct lattice *l, int axis, double x);

/* (V_i)^(1/d) of a particle at x, m, and the largest that there is. */
double place_spacing(const struct problem *p, const struct options *o, const struct lattice *l, const double x[2]);
double place_coarsest(const struct problem *p, const struct options *o, const struct lattice *l);

#endif
