/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_START_H
#define HEATLADDER_SOLVER_PARTICLES_START_H

#include "solver/space/operator.h"

/* Initial data with the correct heat content for an operator that does not conserve heat. */

/* l of n, by unknown of an insulated rod: sum_i l_i T_i is constant, l A = 0, and sum_i l_i = all.  The unknowns are
 * in order along the rod.  STATUS_NUMERICAL if a part of the rod is not connected to the rest. */
int start_kept(const struct heat_operator *a, double all, double *l, struct failure *why);

/* 1 if start_keep_heat determines the initial data; this assembles the rows a second time. */
int start_is_kept(const struct problem *p, const struct options *o, const struct scheme *s);

/* For a rod of two materials with its particles in *f: if the initial data jump at the contact, the temperatures
 * within one support of it become point samples plus a constant, such that sum_i l_i T_i has the heat of the jump.
 * The options are resolved. */
int start_keep_heat(const struct problem *p, const struct options *o, const struct scheme *s, struct field *f,
                    struct failure *why);

#endif
