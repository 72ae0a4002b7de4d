/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H
#define HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H

/* Coverage: whether the points of an answer fill the whole domain at the spacings dx and dy, d[0] and d[1], m, each
 * of them once. */

struct failure;
struct problem;
struct samples;

/* STATUS_OK; STATUS_INPUT with *why for a point outside of the domain, fewer points than dx asks for (N - 1 along an
 * axis of N = extent / dx cells: the nodes between its walls), the same point twice, or a part of the domain without
 * a point.  How large a part may be without one: coverage.c. */
int coverage_check(const struct samples *s, const struct problem *p, const double d[2], struct failure *why);

#endif
