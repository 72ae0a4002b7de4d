/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_MATCHED_H
#define HEATLADDER_SOLVER_TIME_MATCHED_H

#include "solver/space/operator.h"

/* The matched run: the time step and the start with which a second-order operator and Euler's method are of fourth
 * order. */

/* Leading error of a scheme's symbol, kappa (-|theta|^2 + A (theta_x^4 + theta_y^4) + B theta_x^2 theta_y^2) / dx^2.
 */
struct symbol_error {
    double A, B;
};

/* Of the scheme at o->h on a square lattice of dimension dim. */
int matched_symbol(int dim, const struct options *o, const struct scheme *s, struct symbol_error *e,
                   struct failure *why);

/* The h/dx nearest to 1.2 at which the error is isotropic (B = 2 A), to 1e-12.  STATUS_INPUT where there is none. */
int matched_isotropic(const struct options *o, const struct scheme *s, double *h, struct failure *why);

/* Refuses starts whose order is not known: see matched.c. */
int matched_check(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                  struct failure *why);
/* Adds to *a's g what the source takes to stay in step with the match, and to T (the sampled start, in the particles'
 * order, K) what it has given by the time that the clock starts. */
void matched_source(const struct problem *p, const struct options *o, struct heat_operator *a, double *T);

#endif
