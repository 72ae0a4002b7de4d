#ifndef HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H
#define HEATLADDER_VERIFICATION_FOREIGN_COVERAGE_H

/* Coverage: whether the points of an answer fill the whole domain at the spacing dx, each of them once. */

#include <stddef.h>

struct failure;
struct problem;
struct samples;

/* The fewest points that dx asks for: with N = extent / dx cells along an axis, the N - 1 nodes between the walls of
 * each axis, multiplied.  Cell centres are N, nodes with the walls N + 1, quadrature points more. */
size_t coverage_fewest(const struct problem *p, double dx);

/* STATUS_OK; STATUS_INPUT with *why for a point outside of the domain, fewer points than dx asks for, the same point
 * twice, or a part of the domain without one.  How large a part may be without: coverage.c. */
int coverage_check(const struct samples *s, const struct problem *p, double dx, struct failure *why);

#endif
