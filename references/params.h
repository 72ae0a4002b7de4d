/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_PARAMS_H
#define HEATLADDER_REFERENCES_PARAMS_H

#include "references/scene.h"

/* Checks of a scene's parameters.  Each returns 0, or STATUS_INPUT with *why naming `--set NAME=VALUE` and what would
 * be valid. */

/* Zeroes all of *p but its parameters: a setup starts from here. */
void params_keep(struct problem *p);

/* lo < param[i] < hi; an infinite bound is none.  `because` says where the bound comes from, or is NULL. */
int params_between(const struct param *table, const struct problem *p, int i, double lo, double hi,
                   const char *because, struct failure *why);

/* Every parameter of the list, ended by -1, > 0. */
int params_all_positive(const struct param *table, const struct problem *p, const int *list, struct failure *why);

/* param[i] finite */
int params_finite(const struct param *table, const struct problem *p, int i, struct failure *why);

/* param[i] a whole number, lo <= param[i] <= hi */
int params_whole(const struct param *table, const struct problem *p, int i, int lo, int hi, struct failure *why);

#endif
