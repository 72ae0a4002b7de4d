/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_COMPATIBILITY_H
#define HEATLADDER_SOLVER_PARTICLES_COMPATIBILITY_H

#include "solver/space/operator.h"

/* Valid combinations of layout, walls, sampling, materials, order and stepper for particle methods. */

/* Returns STATUS_OK, or STATUS_NOT_APPLICABLE from the first row of the table that refuses these resolved options,
 * or the result of the scheme's own check. */
int compatibility_check(const struct problem *p, const struct options *o, const struct scheme *s,
                        struct failure *why);

#endif
