/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_START_H
#define HEATLADDER_SOLVER_PARTICLES_START_H

#include "solver/space/operator.h"

/* A start that holds the heat of the initial data, as an operator that does not conserve heat counts it. */

/* l of n, unknown i of an insulated rod: sum_i l_i T_i stays as it is, l A = 0, and sum_i l_i = all.  Unknowns are
 * in order along the rod.  STATUS_NUMERICAL where a part of the rod has no way to the rest. */
int start_kept(const struct heat_operator *a, double all, double *l, struct failure *why);

/* Whether the start is what start_keep_heat makes of it: the rows are assembled once more for that. */
int start_is_kept(const struct problem *p, const struct options *o, const struct scheme *s);

/* A rod of two materials with its particles in *f: where the initial data jump at the contact, the temperatures
 * within one support of it become point samples, all changed by the same so that sum_i l_i T_i holds the heat of the
 * jump.  Options resolved. */
int start_keep_heat(const struct problem *p, const struct options *o, const struct scheme *s, struct field *f,
                    struct failure *why);

#endif
