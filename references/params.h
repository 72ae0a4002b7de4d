/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_PARAMS_H
#define HEATLADDER_REFERENCES_PARAMS_H

#include "references/scene.h"

/* Checks of a scene's parameters.  Each returns 0, or STATUS_INPUT with *why naming `--set NAME=VALUE` and what would
 * be valid. */

/* A setup starts from here: zeroes all of *p but its parameters, of which each must be finite, and > 0 but for those
 * of the list `any`, ended by -1 (NULL: none); the last of the table is the end time.  Start and walls are
 * problem_start and problem_held, of 0, until the setup has others. */
int params_start(const struct param *table, struct problem *p, const int *any, struct failure *why);

/* The next material of *p: W m^-1 K^-1 along x and y, J m^-3 K^-1. */
void params_material(struct problem *p, double k_x, double k_y, double rho_c);

/* lo < param[i] < hi; an infinite bound is none.  `because` says where the bound comes from, or is NULL. */
int params_between(const struct param *table, const struct problem *p, int i, double lo, double hi,
                   const char *because, struct failure *why);

/* lo <= param[i] <= hi, but for a rounding of 1e-9 hi; both are finite, hi > 0. */
int params_within(const struct param *table, const struct problem *p, int i, double lo, double hi,
                  const char *because, struct failure *why);

/* param[i] a whole number, lo <= param[i] <= hi */
int params_whole(const struct param *table, const struct problem *p, int i, int lo, int hi, struct failure *why);

#endif
