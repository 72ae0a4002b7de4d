/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_WALLS_WALLS_PLANES_H
#define HEATLADDER_REPORTS_WALLS_WALLS_PLANES_H

#include <stdio.h>

struct document;
struct failure;

/* Rods at the offsets 0, 0.1, ... 0.9: orders, errors and steps to `out` and `d`; the mean error against spacing and
 * work of rod-cooling to `error`. */
int walls_planes_offsets(FILE *out, struct document *d, FILE *error, struct failure *why);

/* The largest stable step in the plane, to `d`. */
int walls_planes_steps(struct document *d, struct failure *why);

#endif
