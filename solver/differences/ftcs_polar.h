/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_POLAR_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_POLAR_H

/* ftcs in a disc or an annulus, on a grid of rings and rays. */

struct problem;
struct options;
struct field;
struct outline;
struct failure;

/* As method_solve and method_outline, of a round body. */
int ftcs_polar_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why);
int ftcs_polar_outline(const char *method, const struct problem *p, const struct options *o, struct outline *out,
                       struct failure *why);

#endif
