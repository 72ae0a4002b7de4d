/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_PLAN_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_PLAN_H

struct problem;
struct options;
struct failure;
struct ftcs_grid;

/* Fills *g but for its arrays: points, steps and sizes.  Holds nothing.  STATUS_OK, STATUS_INPUT or
 * STATUS_NOT_APPLICABLE with *why filled. */
int ftcs_plan(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
              const struct options *o, struct failure *why);

/* Whether step and end time of the options and the problem are what any grid can take. */
int ftcs_plan_check_times(const struct problem *p, const struct options *o, struct failure *why);

#endif
