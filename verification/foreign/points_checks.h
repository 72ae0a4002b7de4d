/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_POINTS_CHECKS_H
#define HEATLADDER_VERIFICATION_FOREIGN_POINTS_CHECKS_H

/* Whether the points of an answer fill the domain, each of them once.  d: dx and dy, m, of the case.  STATUS_OK, or
 * STATUS_INPUT with the place, or the lines, in *why. */

struct failure;
struct problem;
struct samples;

/* A point outside of the domain, fewer points than dx asks for (N - 1 along an axis of N = extent / dx cells: the
 * nodes between its walls), the same point twice, or a part of the domain without a point.  How large a part may be
 * without one: coverage.c. */
int coverage_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

/* A place without its point, where the points lie on a lattice (of equal spacing along a rod, of rows and columns in
 * the plane) that lacks some. */
int holes_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

/* Two points within 1e-9 of the extent along each axis: a program that gives one place two values left something
 * undone. */
int same_points_check(const struct samples *s, const struct problem *p, struct failure *why);

#endif
