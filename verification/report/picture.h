/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_REPORT_PICTURE_H
#define HEATLADDER_VERIFICATION_REPORT_PICTURE_H

/* Pictures of a row that does not hold, as SVG within an HTML page. */

#include <stdio.h>

struct gate;
struct measured;
struct rungs;

/* The errors over the spacing, log-log, with the band of the slope from the coarsest rung and the ceiling. */
void picture_ladder(FILE *out, const struct rungs *l, const struct gate *gate);

/* T, what it is compared with (exact temperatures, a second run, its rounding; NAN: no value there) and their
 * difference: profiles on a rod, maps in the plane, and in space maps of the layer in the middle. */
void picture_field(FILE *out, const struct measured *m);

#endif
