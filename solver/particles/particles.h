/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_PARTICLES_H
#define HEATLADDER_SOLVER_PARTICLES_PARTICLES_H

#include "solver/space/operator.h"
#include "solver/time/stepper.h"

/* The options that a method with a scheme accepts, but for walls, and what is its own. */
#define PARTICLES_OPTIONS "stepper kernel h layout jitter sweeps seed sampling"
#define PARTICLES_WALLS " shift angle walls"

/* `solve` of a method with a scheme: layout, sampling, operator, stepper, field. */
int particles_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                    struct failure *why);

/* The rate of the fastest growing mode of the method's rows, s^-1 (solver/time/growth.h), for a problem that was
 * solved with these options and gave *f.  NaN where there are no rows: on a lattice of one material, and without a
 * scheme. */
int particles_growth(const struct method *m, const struct problem *p, const struct options *o, const struct field *f,
                     double *rate, struct failure *why);

/* ---- Their parts ---- */

/* The options with their defaults resolved (h), checked. */
int particles_resolve(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct failure *why);

/* The resolved options, the lattice, and whether each particle gets a row of its own. */
int particles_prepare(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct lattice *l, int *rows, struct failure *why);

/* Whether each particle gets a row of its own: off the lattice, for two materials, without walls, and where walls cut
 * the lattice. */
int particles_rows(const struct problem *p, const struct options *o);

/* The particles and ghosts of the layout, what they hold included. */
int particles_cloud(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    struct cloud *c, struct failure *why);

/* How far from a wall particles have ghosts, m. */
double particles_reach(const struct options *o, const struct scheme *s, const struct lattice *l);

/* The steps of the run for resolved options, from f->T; counts, cost and ranges into *f. */
int particles_integrate(const struct problem *p, const struct options *o, const struct scheme *s,
                        const struct lattice *l, struct heat_operator *a, struct field *f, struct failure *why);

#endif
