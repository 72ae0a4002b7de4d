/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_REDRAW_H
#define HEATLADDER_SOLVER_PARTICLES_REDRAW_H

#include "solver/space/operator.h"
#include "solver/time/stepper.h"

/* Takes f->T through the march *m; after each o->redraw steps the cloud is redrawn with the next seed, and T is
 * carried over by SSPH of order 2.  *a and the places in *f follow. */
int redraw_march(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                 const struct march *m, struct heat_operator *a, struct field *f, struct failure *why);

/* STATUS_NOT_APPLICABLE where there is nothing to draw, or an interface that the interpolation does not know of. */
int redraw_check(const struct problem *p, const struct options *o, struct failure *why);

#endif
