/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H
#define HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H

/* Checks that the points of an answer fill the domain, each of them once.  d: dx and dy, m, of the case.  STATUS_OK,
 * or STATUS_INPUT with the place, or the lines, in *why. */

struct failure;
struct problem;
struct samples;

/* Refuses a point outside the domain, fewer points than dx asks for (N - 1 along an axis of N = extent / dx cells:
 * the nodes between its walls), a part of the domain without a point, or a point that is there twice. */
int coverage_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

/* Refuses two points within 1e-9 of the extent along each axis: a program that gives one place two values left
 * something undone. */
int coverage_check_once(const struct samples *s, const struct problem *p, struct failure *why);

/* Refuses a lattice (equal spacing along a rod, rows and columns in the plane) that lacks a point. */
int missing_points_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

#endif
