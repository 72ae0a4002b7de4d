/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_CSR_H
#define HEATLADDER_SOLVER_SPACE_CSR_H

#include "solver/space/operator.h"

/* Fills the rows, the diagonal and g of *a for the particles of c (spacing: the h of the options is in units of it,
 * m). Ghosts count in the columns of their sources.  STATUS_NUMERICAL for the first particle without weights.
 */
int csr_assemble(struct heat_operator *a, const struct problem *p, const struct options *o, const struct scheme *s,
                 const struct cloud *c, double spacing, struct failure *why);

/* A row of A, ghosts in the columns of their sources. */
struct row {
    double *value;    /* by column, n of the operator; zero where not touched */
    uint32_t *column; /* touched, in any order */
    size_t n;         /* of these */
    unsigned char *touched;
};

/* An empty row of n columns; emptied again in as many steps as it has columns; freed. */
void csr_row_create(struct row *r, size_t n);
void csr_row_clear(struct row *r);
void csr_row_free(struct row *r);

/* row += w at a column */
static inline void csr_row_add(struct row *r, uint32_t column, double w) {
    if (!r->touched[column]) r->touched[column] = 1, r->column[r->n++] = column;
    r->value[column] += w;
}

#endif
