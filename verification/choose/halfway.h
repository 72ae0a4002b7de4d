/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_HALFWAY_H
#define HEATLADDER_VERIFICATION_CHOOSE_HALFWAY_H

struct field;
struct problem;
struct scene;

/* E1 half-way between neighbouring lattice points, along each axis: the temperature there is a polynomial through up
 * to eight points of the row that lie in the same material.  NaN off a lattice. */
double halfway_error(const struct scene *s, const struct problem *p, const struct field *f);

#endif
