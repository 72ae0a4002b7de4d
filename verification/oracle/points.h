/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_ORACLE_POINTS_H
#define HEATLADDER_VERIFICATION_ORACLE_POINTS_H

/* The points of `reference --points`, from CSV. */

#include <stddef.h>
#include <stdio.h>

struct failure;
struct problem;

struct points_text {
    const char *start; /* within the text that was read */
    int length;
};

struct points {
    int dim;
    size_t n;
    double (*x)[2];    /* m, n of them, within the domain */
    double (*cell)[2]; /* m, extents of the cell around each; NULL without a column dx */
    struct points_text (
        *typed)[2]; /* the coordinates as they were typed; of length 0 where x is another, on a side */
    char *text;     /* owned: all that was read */
};

/* Reads all of `in`: a header with the names x (and y for a rectangle), commas between, then a line a point.  Columns
 * dx (and dy, else the same) are cells' extents; others are skipped, and so are blank lines and those that start with
 * #.  A point may lie outside of *p by 1e-9 of its extent, and is taken to the side then.  STATUS_OK, and the caller
 * ends with points_free; or STATUS_INPUT with *why naming `name`, line and column. */
int points_read(FILE *in, const char *name, const struct problem *p, struct points *points, struct failure *why);

/* One point at x.  STATUS_OK or STATUS_INPUT likewise. */
int points_one(const struct problem *p, const double x[2], struct points *points, struct failure *why);

void points_free(struct points *points);

#endif
