/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_POINTS_H
#define HEATLADDER_VERIFICATION_CASE_POINTS_H

/* The points of `reference`. */

#include "solver/problem.h"
#include "verification/case/rows.h"

struct failure;

struct points {
    int dim;
    size_t n;
    double (*x)[DIM_MAX];               /* m, n points, inside the domain */
    double (*cell)[DIM_MAX];            /* m, extents of the cell around each point; NULL without a column dx */
    struct rows_cell (*typed)[DIM_MAX]; /* the coordinates as typed; length 0 if x was moved onto a side */
    struct rows rows;                   /* owned: the text that `typed` is in */
};

/* Reads all of `in`: a header with x (x,y in the plane, x,y,z in space), then one point per line (rows.h).  Columns
 * dx (and dy, dz, by default equal) are cell extents; other columns are skipped.  A point may be outside of *p by
 * 1e-9 of its extent and is then moved onto the side.  Returns STATUS_OK, and the caller releases the points with
 * points_free; or STATUS_INPUT with *why naming `name`, line and column. */
int points_read(FILE *in, const char *name, const struct problem *p, struct points *points, struct failure *why);

/* One point at x.  Returns STATUS_OK or STATUS_INPUT. */
int points_one(const struct problem *p, const double *x, struct points *points, struct failure *why);

void points_free(struct points *points);

#endif
