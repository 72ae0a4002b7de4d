/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_DERIVED_H
#define HEATLADDER_VERIFICATION_JUDGE_DERIVED_H

struct failure;
struct field;
struct problem;
struct quantity;

/* The quantity of a numerical field, in the unit of quantity_unit, from polynomials of degree five through its
 * points (interpolate.h).  A flux is k dT/dn at the side, independent of the method's boundary treatment.  Heat is
 * integrated by Gauss's rule over panels of four spacings, separately on each side of an interface.  A front is
 * between two points, by linear interpolation: half a spacing off at most.  The
 * interpolation error is at least O(dx^5), in addition to the error of the field. */
int derived_value(const struct quantity *q, const struct problem *p, const struct field *f, double dx, double *value,
                  struct failure *why);

#endif
