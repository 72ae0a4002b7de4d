/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SPACE_CSR_H
#define HEATLADDER_SOLVER_SPACE_CSR_H

#include "solver/space/operator.h"

/* Fills the rows, the diagonal and g of *a for the particles of c; spacing, m, is the unit of the option h.  Ghosts
 * enter the columns of their sources.  Returns STATUS_NUMERICAL for the first particle without weights. */
int csr_assemble(struct heat_operator *a, const struct problem *p, const struct options *o, const struct scheme *s,
                 const struct cloud *c, double spacing, struct failure *why);

/* g (one value per particle) at the time t, s: the source and a->images. */
void csr_constants(const struct heat_operator *a, const struct problem *p, const struct options *o, double t,
                   double *g);

struct assembly_list;

/* A row of A, with ghosts in the columns of their sources. */
struct row {
    double *value;    /* by column, n of the operator; zero if not touched */
    uint32_t *column; /* touched columns, in any order */
    size_t n;         /* number of touched columns */
    unsigned char *touched;
    struct assembly_list *images; /* lists the weights of ghosts too; NULL: not */
};

/* Creates an empty row of n columns; empties it in time proportional to its touched columns; frees it. */
void csr_row_create(struct row *r, size_t n);
void csr_row_clear(struct row *r);
void csr_row_free(struct row *r);

/* Adds w at a column. */
static inline void csr_row_add(struct row *r, uint32_t column, double w) {
    if (!r->touched[column]) r->touched[column] = 1, r->column[r->n++] = column;
    r->value[column] += w;
}

#endif
