/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_RELAX_H
#define HEATLADDER_SOLVER_SPACE_RELAX_H

#include "solver/space/layout.h"

/* Moves the particles of *c (n of them; ghosts are not looked at) apart until they have settled, and fills
 * c->settling.  spacing, m: V^(1/d).  STATUS_NUMERICAL, with how far it came, where o->sweeps do not suffice.
 * The same for any number of threads. */
int relax_cloud(const struct problem *p, const struct options *o, double spacing, struct cloud *c,
                struct failure *why);

#endif
