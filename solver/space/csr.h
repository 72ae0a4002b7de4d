#ifndef HEATLADDER_SOLVER_SPACE_CSR_H
#define HEATLADDER_SOLVER_SPACE_CSR_H

#include "solver/space/operator.h"

/* Fills the rows, the diagonal and g of *a for the particles of c (spacing: the h of the options is in units of it,
 * m). Ghosts count in the columns of their sources.  STATUS_NUMERICAL for the first particle without weights.
 */
int csr_assemble(struct heat_operator *a, const struct problem *p, const struct options *o, const struct scheme *s,
                 const struct cloud *c, double spacing, struct failure *why);

#endif
