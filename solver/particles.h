#ifndef HEATLADDER_SOLVER_PARTICLES_H
#define HEATLADDER_SOLVER_PARTICLES_H

#include "solver/operator.h"

/* A whole run of a particle method: layout, sampling, operator, stepper, field.  As struct method's solve. */
int particles_solve(const struct problem *p, const struct options *o, const struct scheme *s, struct field *f,
                    struct failure *why);

/* The options with their defaults settled (h, order), checked: what particles_solve works with. */
int particles_settle(const struct problem *p, const struct options *o, const struct scheme *s,
                     struct options *settled, struct failure *why);

#endif
