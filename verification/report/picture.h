/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_REPORT_PICTURE_H
#define HEATLADDER_VERIFICATION_REPORT_PICTURE_H

/* Pictures of a row that does not hold, as SVG within an HTML page. */

#include <stdio.h>

struct field;
struct gate;
struct rungs;

/* The errors over the spacing, log-log, with the band of the slope from the coarsest rung and the ceiling. */
void picture_ladder(FILE *out, const struct rungs *l, const struct gate *gate);

/* T, the exact temperature and their difference: profiles on a rod, maps in the plane, and in space maps of the layer
 * in the middle.  `exact`, K: at the points of the field; NAN: no value there. */
void picture_field(FILE *out, const struct field *f, const double *exact);

#endif
