/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_ORACLE_ANSWER_H
#define HEATLADDER_VERIFICATION_ORACLE_ANSWER_H

#include "references/mapping.h"
#include "verification/oracle/columns.h"
#include "verification/oracle/points.h"

struct scene;

/* Values of a scene's columns at a set of points. */
struct answer {
    const struct scene *scene;
    const struct image *image; /* of the scene's problem: points and columns are in its axes */
    struct points points;
    struct columns columns;
    int times;
    const double *time; /* s */
    double cell;        /* m: extent of a cell where the points have none; 0 where not given */
};

/* `count` >= 2 times evenly from `from` to `to` (s), both ends among them. */
void answer_times(double from, double to, int count, double *time);

/* Whether all that the columns need is there: times, cells. */
int answer_check(const struct answer *a, struct failure *why);

/* CSV: the coordinates as typed, but on a side where they were taken there, `time` where there are several, the
 * columns with 17 digits. */
void answer_write(const struct answer *a, FILE *out);

#endif
