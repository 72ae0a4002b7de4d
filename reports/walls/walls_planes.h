/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_WALLS_WALLS_PLANES_H
#define HEATLADDER_REPORTS_WALLS_WALLS_PLANES_H

#include <stdio.h>

struct failure;

/* Rods at the offsets 0, 0.1, ... 0.9: orders, errors and steps to `out` and `md`; the mean error against spacing and
 * work of rod-cooling to `error`. */
int walls_planes_offsets(FILE *out, FILE *md, FILE *error, struct failure *why);

/* The largest stable step in the plane, to `md`; refused where runs 2 % below and above it do not stay and grow. */
int walls_planes_steps(FILE *md, struct failure *why);

#endif
