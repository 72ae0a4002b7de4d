/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_SAMPLE_H
#define HEATLADDER_SOLVER_SPACE_SAMPLE_H

#include "solver/space/layout.h"

/* Initial data at x, K: the value there, or its average with a B-spline of order 1 (the cell) or 4 (cubic) on the
 * spacing dx (m, dim values).  Beyond the walls the data are extended like ghosts: odd about a Dirichlet wall's
 * value, even with the slope of the flux about a Neumann wall. */
double sample_initial(const struct problem *p, enum sampling sampling, const double *dx, const double *x);

/* sample_initial for a lattice particle with a cell that the interface may cut: its heat divided by its heat
 * capacity.  Point samples are then at the centres of both parts. */
double sample_cell(const struct problem *p, enum sampling sampling, const double *dx, const double *x);

/* 1 if the data equal the value of a Dirichlet wall, to 1e-9 of their size, at every line of the lattice;
 * averages then need no split at the wall. */
int sample_meets_wall(const struct problem *p, const struct lattice *l, enum side s);

/* sample_initial for every particle of a lattice: T[(k n[1] + j) n[0] + i], K. */
void sample_lattice(const struct problem *p, enum sampling sampling, const struct lattice *l, double *T);

#endif
