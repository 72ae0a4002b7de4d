/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_SAMPLE_H
#define HEATLADDER_SOLVER_SPACE_SAMPLE_H

#include "solver/space/layout.h"

/* Initial data at x, K: the value there, or its average with a B-spline of order 1 (the cell) or 4 (cubic) on the
 * spacing dx (m).  Beyond the walls the data are continued as the ghosts are: odd about a Dirichlet wall's value,
 * even with the flux's slope about a Neumann wall. */
double sample_initial(const struct problem *p, enum sampling sampling, const double dx[2], const double x[2]);

/* sample_initial for a particle of a lattice, whose cell the interface may cut: its heat over its heat capacity.
 * Points are then those in the middle of either part. */
double sample_cell(const struct problem *p, enum sampling sampling, const double dx[2], const double x[2]);

/* Whether the data have the temperature of a Dirichlet wall, to 1e-9 of their size, at every row or column of the
 * lattice: averages need not be cut there. */
int sample_meets_wall(const struct problem *p, const struct lattice *l, enum side s);

/* sample_initial for every particle of a lattice: T[j * n[0] + i], K. */
void sample_lattice(const struct problem *p, enum sampling sampling, const struct lattice *l, double *T);

#endif
