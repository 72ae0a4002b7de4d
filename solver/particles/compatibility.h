/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_COMPATIBILITY_H
#define HEATLADDER_SOLVER_PARTICLES_COMPATIBILITY_H

#include "solver/space/operator.h"

/* Which layouts, walls, sampling, materials, orders and steppers go together in a particle method. */

/* STATUS_OK, or STATUS_NOT_APPLICABLE by the first row of the table that refuses these resolved options; at last the
 * scheme's own check. */
int compatibility_check(const struct problem *p, const struct options *o, const struct scheme *s,
                        struct failure *why);

#endif
