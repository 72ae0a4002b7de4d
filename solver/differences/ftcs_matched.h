/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_MATCHED_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_MATCHED_H

#include "solver/differences/ftcs_grid.h"

/* The matched run of the finite differences on a rod: its averaged initial data and corrected source. */

struct problem;
struct failure;

/* Sets *m to -1 for point samples of data that are constant between jumps midway between two points, to 0 for smooth
 * data; else refuses.  A Dirichlet value that differs from the data is a jump at the wall. */
int ftcs_matched_points(const struct ftcs_grid *g, const struct problem *p, int *m, struct failure *why);

/* Correction of the source at x, W m^-3: A D^2 G, since Euler steps of F = 2A add A dx^2/kappa of diffusion to it
 * too. */
double ftcs_matched_source(const struct ftcs_grid *g, const struct problem *p, const double x[2]);

#endif
