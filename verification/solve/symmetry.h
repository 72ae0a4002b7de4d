/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_SYMMETRY_H
#define HEATLADDER_VERIFICATION_SOLVE_SYMMETRY_H

/* Solves a problem that is even about the middle of an axis on its upper half only. */

#include "solver/method.h"
#include "solver/problem.h"

/* Sets *half to *whole, cut at the middle of every axis about which it is even and along which the lattice has an
 * even number of particles; the cut is its insulated low side.  It refers to *whole. cut[a] is 1 for an
 * axis that was cut.  Returns the number of cuts. */
int symmetry_reduce(const struct problem *whole, const struct options *o, struct problem *half, int cut[DIM_MAX]);

/* Solves the reduced problem and restores the field of the whole; the counts of work and bytes are those of the
 * reduced problem.  Solves the whole problem if nothing can be cut or the option is --domain whole. */
int symmetry_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                   struct failure *why);

#endif
