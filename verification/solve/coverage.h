/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_COVERAGE_H
#define HEATLADDER_VERIFICATION_SOLVE_COVERAGE_H

/* Checks that the points of an answer cover the domain exactly once. d: the spacings of the case by axis, m.  Each
 * returns STATUS_OK, or STATUS_INPUT with the position or the lines in *why. */

struct failure;
struct image;
struct problem;
struct samples;

/* Refuses a point outside the domain, fewer points than required (N - 1 along an axis of N = extent / dx cells: the
 * nodes between its walls; one less for an interface), a part of the domain without a point, a duplicate point, or a
 * lattice with a missing point. */
int coverage_check(const struct samples *s, const struct image *image, const double *d, struct failure *why);

/* Refuses two points within 1e-9 of the extent along each axis: two values at one position indicate unfinished
 * output. */
int coverage_check_once(const struct samples *s, const struct problem *p, struct failure *why);

/* Refuses a lattice (equal spacing along a rod; rows and columns, or rows, columns and layers) with a missing
 * point. */
int coverage_check_missing(const struct samples *s, const struct image *image, const double *d, struct failure *why);

#endif
