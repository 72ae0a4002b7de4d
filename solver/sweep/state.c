/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conversion between temperatures and states, and dispatch of updates to the sweeps. */
#include "solver/sweep/state.h"
#include "solver/sweep/sweep.h"

#include <string.h>

/* Rows of particles in all planes, and the start of one. */
static ptrdiff_t rows_of(const struct heat_operator *a) {
    return a->weight ? (ptrdiff_t)a->lattice.n[1] * a->lattice.n[2] : 1;
}

static ptrdiff_t start_of(const struct heat_operator *a, ptrdiff_t row) {
    ptrdiff_t ny = a->weight ? a->lattice.n[1] : 1;
    return operator_place(a, row % ny, row / ny);
}

/* From the last row to the first, so that no row is overwritten before it has moved. */
void state_load(const struct heat_operator *a, const double *T, double *state) {
    ptrdiff_t rows = rows_of(a), nx = (ptrdiff_t)a->n / rows, end = (ptrdiff_t)a->state;
    for (ptrdiff_t j = rows; j-- > 0; end = start_of(a, j)) {
        ptrdiff_t after = start_of(a, j) + nx;
        memmove(state + start_of(a, j), T + j * nx, (size_t)nx * sizeof *T);
        memset(state + after, 0, (size_t)(end - after) * sizeof *T);
    }
    memset(state, 0, (size_t)end * sizeof *T);
}

void state_store(const struct heat_operator *a, const double *state, double *T) {
    ptrdiff_t rows = rows_of(a), nx = (ptrdiff_t)a->n / rows;
    for (ptrdiff_t j = 0; j < rows; j++) memmove(T + j * nx, state + start_of(a, j), (size_t)nx * sizeof *T);
}

size_t state_find_outside(const struct heat_operator *a, const double *state, double lo, double hi) {
    ptrdiff_t rows = rows_of(a), nx = (ptrdiff_t)a->n / rows;
    for (ptrdiff_t j = 0; j < rows; j++) {
        const double *row = state + start_of(a, j);
        int outside = 0;
        for (ptrdiff_t i = 0; i < nx; i++) outside += !(row[i] >= lo && row[i] <= hi);
        if (outside == 0) continue;
        ptrdiff_t i = 0;
        while (row[i] >= lo && row[i] <= hi) i++;
        return (size_t)(j * nx + i);
    }
    return a->n;
}

void state_update(const struct heat_operator *a, const struct update *u, int count, double *Y[2]) {
    if (a->weight && a->lattice.dim == 3)
        sweep_box(a, u, count, Y);
    else if (a->weight)
        sweep_lattice(a, u, count, Y);
    else
        sweep_csr(a, u, count, Y);
    if (count % 2) {
        double *swap = Y[0];
        Y[0] = Y[1], Y[1] = swap;
    }
}
