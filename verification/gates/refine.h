/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_REFINE_H
#define HEATLADDER_VERIFICATION_GATES_REFINE_H

/* The rows of a battery with more rungs, or for a code of a given order in time. */

#include "verification/gates/gates.h"

/* rungs: in all, for rows of fewer, the further ones by halving; their ceilings fall with the order that the band is
 * for.  time_order: rows of measure slope_time get the band [P - 0.2, P + 0.5].  0 for either: as the rows are.  The
 * gates' new texts are owned by *g, whose `text` is not in use. */
void refine_gates(struct gates *g, int rungs, double time_order);

#endif
