/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_ANSWER_H
#define HEATLADDER_VERIFICATION_CASE_ANSWER_H

#include "references/columns.h"
#include "references/mapping.h"
#include "verification/case/points.h"

struct scene;

/* Values of a scene's columns at a set of points. */
struct answer {
    const struct scene *scene;
    const struct image *image; /* image of the scene's problem; points and columns are in its axes */
    struct points points;
    struct columns columns;
    int times;
    const double *time; /* s */
    double cell;        /* m: extent of a cell if the points have none; 0 if not given */
};

/* `count` >= 2 equidistant times from `from` to `to` (s), ends included. */
void answer_times(double from, double to, int count, double *time);

/* Checks that the columns have the times and cells that they need. */
int answer_check(const struct answer *a, struct failure *why);

/* CSV: the coordinates as typed, except those moved onto a side; `time` if there are several; the columns with 17
 * digits. */
void answer_write(const struct answer *a, FILE *out);

#endif
