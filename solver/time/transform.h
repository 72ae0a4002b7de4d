/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_TRANSFORM_H
#define HEATLADDER_SOLVER_TIME_TRANSFORM_H

#include "solver/space/layout.h"

/* The sine or cosine transform of a lattice with the parity of its mirror walls (sign -1 or +1) on each axis; along
 * an axis with a wall of another factor, the transform to its modes. */

enum { TRANSFORM_TABLE_MOST = 4096 }; /* unknowns along such an axis: its table is n x n */

struct transform;

/* For the sides of *l; release with transform_free. */
struct transform *transform_create(const struct lattice *l);
void transform_free(struct transform *t);

/* Releases the cached plans; no transform may be in use. */
void transform_forget(void);

/* Replaces T (n[0] x n[1] x n[2], x fastest) by its coefficients, or back.  Forward and backward together multiply by
 * transform_scale. */
void transform_forward(const struct transform *t, double *T);
void transform_backward(const struct transform *t, double *T);
double transform_scale(const struct lattice *l);

/* The same along the axes first .. last alone, of the n[first] ... n[last] values of T. */
void transform_axes_forward(const struct transform *t, int first, int last, double *T);
void transform_axes_backward(const struct transform *t, int first, int last, double *T);

/* Additions and multiplications of transform_backward per value. */
double transform_flops(const struct transform *t);

/* Wave number of mode k along an axis, radians per particle. */
double transform_angle(const struct lattice *l, int axis, int k);

#endif
