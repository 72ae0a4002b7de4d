/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_ORACLE_CLIPPED_H
#define HEATLADDER_VERIFICATION_ORACLE_CLIPPED_H

struct problem;

/* K: the mean of the start over the part of the box from lo to hi (m) inside a round body; that part is not empty. */
double clipped_mean(const struct problem *p, const double lo[2], const double hi[2]);

#endif
