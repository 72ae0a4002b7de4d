/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_PLAN_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_PLAN_H

struct problem;
struct options;
struct failure;
struct ftcs_grid;

/* Fills *g except its arrays: points, steps and sizes.  Allocates nothing.  Returns STATUS_OK, or STATUS_INPUT or
 * STATUS_NOT_APPLICABLE with *why. */
int ftcs_plan(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
              const struct options *o, struct failure *why);

/* Whether a grid can take these options: STATUS_OK, STATUS_INPUT or STATUS_NOT_APPLICABLE with *why filled. */
int ftcs_plan_check(const char *method, int with_fluxes, const struct problem *p, const struct options *o,
                    struct failure *why);

#endif
