/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_WAVEFRONT_H
#define HEATLADDER_SOLVER_SWEEP_WAVEFRONT_H

#include <stddef.h>

/* Updates 0 .. count - 1 of `units` (rows of a lattice or of a matrix).  Each update reads the results of the
 * previous one up to `lag` units away and may overwrite its input. */
struct wavefront {
    void (*advance)(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi); /* update k of the units [lo, hi) */
    const void *what;
    ptrdiff_t units, lag, band; /* band: units per front */
    int together;               /* maximum number of updates per sweep */
    int threads;                /* maximum */
};

void wavefront_sweep(const struct wavefront *w, int count);

#endif
