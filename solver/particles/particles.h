/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_PARTICLES_H
#define HEATLADDER_SOLVER_PARTICLES_PARTICLES_H

#include "solver/space/operator.h"
#include "solver/time/stepper.h"

/* Options of a method with a scheme, except walls and its own options. */
#define PARTICLES_OPTIONS "stepper kernel h layout jitter sweeps seed sampling"
#define PARTICLES_WALLS " shift angle walls"

/* Rows, and the particles with their initial temperatures.  They depend on no time step: runs that differ in that
 * alone share them by options.assembled. */
struct assembled {
    struct heat_operator rows; /* n is 0 until a run has filled it */
    struct field start;
};
void particles_free_assembled(struct assembled *kept);

/* `solve` of a method with a scheme: layout, sampling, operator, stepper, field. */
int particles_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                    struct failure *why);

/* Rate of the fastest growing mode of the method's rows, s^-1 (solver/time/growth.h), those of o->assembled if a run
 * has filled it.  NaN without rows: on a lattice of one material, without a scheme, or with a k that depends on T. */
int particles_growth(const struct method *m, const struct problem *p, const struct options *o, double *rate,
                     struct failure *why);

/* ---- Parts ---- */

/* Checks resolved options: STATUS_NOT_APPLICABLE from the first row of the table that refuses them, or the result of
 * the scheme's own check. */
int particles_check(const struct problem *p, const struct options *o, const struct scheme *s, struct failure *why);

/* Fills in the defaults of the options (h) and checks them. */
int particles_resolve(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct failure *why);

/* The resolved options, the lattice, and whether each particle has its own row. */
int particles_prepare(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct lattice *l, int *rows, struct failure *why);

/* 1 if each particle has its own row: off the lattice, with two materials, without walls, and on a cut lattice. */
int particles_rows(const struct problem *p, const struct options *o);

/* The particles and ghosts of the layout, with the values of the dummies. */
int particles_cloud(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    struct cloud *c, struct failure *why);

/* Distance from a wall within which particles need ghosts, m. */
double particles_reach(const struct options *o, const struct scheme *s, const struct lattice *l);

#endif
