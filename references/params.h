/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_PARAMS_H
#define HEATLADDER_REFERENCES_PARAMS_H

#include "references/scene.h"

/* Checks of a scene's parameters.  Each returns 0, or STATUS_INPUT with *why naming `--set NAME=VALUE` and the valid
 * range. */

/* Start of every setup: zeroes *p except its parameters.  Each parameter must be finite, and positive unless it is
 * in the list `any`, ended by -1 (NULL: empty).  The last parameter of the table is the end time.  Initial data and
 * walls are problem_start and problem_held, with value 0, until the setup replaces them. */
int params_start(const struct param *table, struct problem *p, const int *any, struct failure *why);

/* Appends a material to *p: conductivities along x and y (W m^-1 K^-1), heat capacity (J m^-3 K^-1). */
void params_material(struct problem *p, double k_x, double k_y, double rho_c);

/* Requires lo < param[i] < hi; an infinite bound is no bound.  `because` states the reason for the bound, or is
 * NULL. */
int params_between(const struct param *table, const struct problem *p, int i, double lo, double hi,
                   const char *because, struct failure *why);

/* Requires lo <= param[i] <= hi with a tolerance of 1e-9 hi; both bounds are finite, hi > 0. */
int params_within(const struct param *table, const struct problem *p, int i, double lo, double hi,
                  const char *because, struct failure *why);

/* Requires an integer param[i] with lo <= param[i] <= hi. */
int params_whole(const struct param *table, const struct problem *p, int i, int lo, int hi, struct failure *why);

#endif
