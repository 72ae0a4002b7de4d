/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_DERIVED_H
#define HEATLADDER_VERIFICATION_RUN_DERIVED_H

struct failure;
struct field;
struct problem;
struct quantity; /* references/quantity.h */

/* The quantity of a numerical field, in the unit of quantity_unit, from polynomials of degree five through its points
 * (interpolate.h): a flux is k dT/dn at the side, whatever the method held there; heat is integrated by Gauss's rule
 * over panels of four spacings, each side of an interface by itself.  Wrong by O(dx^5) at least, beside the field's
 * own error. */
int derived_value(const struct quantity *q, const struct problem *p, const struct field *f, double dx, double *value,
                  struct failure *why);

#endif
