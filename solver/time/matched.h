/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_MATCHED_H
#define HEATLADDER_SOLVER_TIME_MATCHED_H

#include "solver/space/operator.h"

/* The matched run: the time step and the initial data that make a second-order operator with Euler's method fourth
 * order. */

/* Leading error of a scheme's symbol, kappa (-|theta|^2 + A sum_a theta_a^4 + B sum_(a<b) theta_a^2 theta_b^2) /
 * dx^2.
 */
struct symbol_error {
    double A, B;
};

/* Symbol of the scheme at o->h on a cubic lattice of dimension dim. */
int matched_symbol(int dim, const struct options *o, const struct scheme *s, struct symbol_error *e,
                   struct failure *why);

/* The h/dx closest to 1.2, in space to 1, with an isotropic error (B = 2 A) on that lattice, on a rod that of the
 * plane, to 1e-12.  Refuses if there is none. */
int matched_isotropic(int dim, const struct options *o, const struct scheme *s, double *h, struct failure *why);

/* Refuses initial data of unknown order, see matched.c. */
int matched_check(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                  struct failure *why);
/* Corrects the source *a's g for the match, and adds to T (the sampled data, in the particles' order, K) the effect
 * of the source up to the initial time of the run. */
void matched_source(const struct problem *p, const struct options *o, struct heat_operator *a, double *T);

#endif
