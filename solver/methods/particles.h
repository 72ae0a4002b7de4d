#ifndef HEATLADDER_SOLVER_METHODS_PARTICLES_H
#define HEATLADDER_SOLVER_METHODS_PARTICLES_H

#include "solver/space/operator.h"
#include "solver/time/stepper.h"

/* A whole run of a particle method: layout, sampling, operator, stepper, field.  As struct method's solve. */
int particles_solve(const struct problem *p, const struct options *o, const struct scheme *s, struct field *f,
                    struct failure *why);

/* The options with their defaults settled (h), checked. */
int particles_settle(const struct problem *p, const struct options *o, const struct scheme *s,
                     struct options *settled, struct failure *why);

/* These, the lattice and whether each particle gets a row of its own: what
 * particles_solve works with, or STATUS_INPUT as it. */
int particles_outline(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *settled, struct lattice *l, int *rows, struct failure *why);

/* The steps that particles_solve takes with the operator *a, for the settled options; m->lo and m->hi are left open.
 */
int particles_march(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    const struct heat_operator *a, struct march *m, struct failure *why);

#endif
