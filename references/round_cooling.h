/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_ROUND_COOLING_H
#define HEATLADDER_REFERENCES_ROUND_COOLING_H

#include "references/scene.h"

/* An initially warm disc (dim 2) or ball (3) cooled by the surrounding air: the functions of the scenes disc-cooling
 * and ball-cooling.  *params: their table, in the order of round_cooling.c. */
int round_cooling_setup(const struct param *params, int dim, struct problem *p, struct failure *why);
void *round_cooling_prepare(const struct problem *p, double t);
struct exact round_cooling_at(const struct problem *p, const void *shared, const double *x, double t);
struct exact round_cooling_second(const struct problem *p, const double *x, double t);

#endif
