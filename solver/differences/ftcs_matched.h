/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_MATCHED_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_MATCHED_H

#include "solver/differences/ftcs_grid.h"

/* The matched run of the finite differences on a rod: its averaged start and its corrected source. */

struct problem;
struct failure;

/* *m = -1 for point samples of data that are constant between jumps midway between two points, 0 for smooth data;
 * else STATUS_INPUT.  A given temperature that the data do not have is a jump at the wall. */
int ftcs_matched_points(const struct ftcs_grid *g, const struct problem *p, int *m, struct failure *why);

/* W m^-3, what the source at x lacks: Euler's steps of F = 2A act like A dx^2/kappa of diffusion, on it too: A D^2 G.
 */
double ftcs_matched_source(const struct ftcs_grid *g, const struct problem *p, const double x[2]);

#endif
