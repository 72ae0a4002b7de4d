/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_TRANSFORM_H
#define HEATLADDER_SOLVER_TIME_TRANSFORM_H

#include "solver/space/layout.h"

/* The sine or cosine transform of a lattice that has the parity of its mirroring walls (sign -1 or +1) on each axis,
 * or along an axis with a Robin wall the modes of that. */

enum { TRANSFORM_ROBIN_MOST = 4096 }; /* unknowns along an axis with a Robin wall: its table is of their square */

struct transform;

/* For the sides of *l; end with transform_free. */
struct transform *transform_create(const struct lattice *l);
void transform_free(struct transform *t);

/* Releases the plans that are kept from one transform to the next; no transform may be in use. */
void transform_forget(void);

/* T (n[0] x n[1], x fastest) becomes its coefficients, or coefficients become T.  Forth and back multiplies by
 * transform_scale. */
void transform_forward(const struct transform *t, double *T);
void transform_backward(const struct transform *t, double *T);
double transform_scale(const struct lattice *l);

/* The transform of one line of n[axis] values along an axis. */
void transform_line_forward(const struct transform *t, int axis, const double *line, double *to);
void transform_line_backward(const struct transform *t, int axis, const double *line, double *to);

/* Additions and multiplications of transform_backward, a value. */
double transform_flops(const struct transform *t);

/* Wave number of mode k along an axis, radians a particle. */
double transform_angle(const struct lattice *l, int axis, int k);

#endif
