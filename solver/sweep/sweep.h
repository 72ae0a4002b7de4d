/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SWEEP_SWEEP_H
#define HEATLADDER_SOLVER_SWEEP_SWEEP_H

#include "solver/space/operator.h"

/* y = rate (A x + g) + self x + old y + start Y0; all are states, and Y0 may be NULL. */
struct update {
    double rate, self, old, start;
    const double *Y0;
};

/* The hot loops of state_update, for `count` updates alternating between the states Y[0] and Y[1]. */

void sweep_lattice(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]);
void sweep_box(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]);
void sweep_csr(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]);

/* 1 for an Euler step without source or wall values. */
int sweep_is_plain(const struct heat_operator *a, const struct update *u);

/* The width of a vector is a type, so each width is a copy of lanes.inc in a file of its own, compiled for its
 * machine: `target_clones` would choose the widest alone, and no width could be forced (HEATLADDER_LANES).
 *
 * Update *u of the rows row <= j < end from the state x, with its ghosts, to y, in vectors of 2, 4 or 8 doubles,
 * which may extend beyond the last column. support: largest i i + j j of an offset with a weight. */
typedef void sweep_band(const struct heat_operator *a, int support, const struct update *u, const double *x,
                        double *y, ptrdiff_t row, ptrdiff_t end);
sweep_band sweep_band_2, sweep_band_4, sweep_band_8;

/* The same for the planes plane <= k < end of a box. support: largest i i + j j + k k. */
typedef void sweep_planes(const struct heat_operator *a, int support, const struct update *u, const double *x,
                          double *y, ptrdiff_t plane, ptrdiff_t end);
sweep_planes sweep_planes_2, sweep_planes_4, sweep_planes_8;

/* The same for particles begin <= i < end of a rod with a banded matrix.  Band entries beyond the ends of the rod
 * are 0, and x is not read there. */
typedef void sweep_bands(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                         ptrdiff_t begin, ptrdiff_t end);
sweep_bands sweep_bands_2, sweep_bands_4, sweep_bands_8;

#endif
