/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_WAVEFRONT_H
#define HEATLADDER_SOLVER_SWEEP_WAVEFRONT_H

#include <stddef.h>

/* Updates 0 .. count - 1 of `units` (rows of a lattice, or of a matrix): each reads what the one before has
 * written up to `lag` units away, and may write over what that one has read. */
struct wavefront {
    void (*advance)(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi); /* update k of the units [lo, hi) */
    const void *what;
    ptrdiff_t units, lag, band; /* band: units at a time */
    int together;               /* updates that share a sweep, at most */
    int threads;                /* at most */
};

void wavefront_sweep(const struct wavefront *w, int count);

#endif
