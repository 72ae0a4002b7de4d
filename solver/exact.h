#ifndef HEATLADDER_SOLVER_EXACT_H
#define HEATLADDER_SOLVER_EXACT_H

#include "solver/operator.h"

/* exp(tA) on a lattice whose walls mirror (sign -1 or +1): T, in the particles' order, is taken from 0 to t (s)
 * without any time error.  Adds what it holds to *bytes.  STATUS_INPUT where the operator has rows or fixed walls. */
int exact_evolve(const struct heat_operator *a, double t, double *T, size_t *bytes, struct failure *why);
/* What that holds beside T. */
size_t exact_bytes(const struct heat_operator *a);

#endif
