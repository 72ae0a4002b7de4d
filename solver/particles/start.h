/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_START_H
#define HEATLADDER_SOLVER_PARTICLES_START_H

#include "solver/space/operator.h"

/* The initial temperatures of a run; options are resolved. */

/* Sets f->T, f->range and, for a matched run, the source of *a.  Averages over the cells of a scheme are in f->T
 * already.  For a rod of two materials whose initial data jump at the contact (start_is_kept) the temperatures within
 * one support of it become point samples plus a constant, such that the operator conserves the heat of the jump.
 * STATUS_NUMERICAL if T leaves the range of the data. */
int start_set(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
              int rows, struct heat_operator *a, struct field *f, struct failure *why);

/* 1 if the initial data are averaged over the cells of the scheme (voronoi_average). */
int start_averages_cells(const struct options *o, const struct scheme *s);

/* 1 if an insulated copy of the rod determines the initial data; its rows are assembled a second time. */
int start_is_kept(const struct problem *p, const struct options *o, const struct scheme *s);

/* l of n, by unknown of an insulated rod: sum_i l_i T_i is constant, l A = 0, and sum_i l_i = all.  The unknowns are
 * in order along the rod.  STATUS_NUMERICAL if a part of the rod is not connected to the rest. */
int start_kept(const struct heat_operator *a, double all, double *l, struct failure *why);

#endif
