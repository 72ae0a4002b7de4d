/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_HOLES_H
#define HEATLADDER_VERIFICATION_FOREIGN_HOLES_H

/* Points that are missing from a lattice. */

struct failure;
struct problem;
struct samples;

/* d: dx and dy, m, of the case.  STATUS_INPUT with the first missing place in *why, where the points lie on a lattice
 * (of equal spacing along a rod, of rows and columns in the plane) that lacks some; STATUS_OK where it lacks none, or
 * where they lie on none. */
int holes_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

#endif
