/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_SAME_POINTS_H
#define HEATLADDER_VERIFICATION_FOREIGN_SAME_POINTS_H

/* Two points are the same where they are within 1e-9 of the extent along each axis: a program that gives one place
 * two values left something undone.  STATUS_INPUT, with the lines of both. */

struct failure;
struct problem;
struct samples;

int same_points_check(const struct samples *s, const struct problem *p, struct failure *why);

#endif
