/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_INTERPOLATE_H
#define HEATLADDER_VERIFICATION_JUDGE_INTERPOLATE_H

/* Temperatures and gradients between scattered points. */

#include "solver/field.h"

#include <stddef.h>

struct failure;

struct interpolate {
    const char *name;                  /* name of the field, for messages */
    const struct field *field;         /* its points and temperatures */
    double from, to;                   /* uses only points with from <= x <= to: one side of a kink */
    double lo[DIM_MAX], side[DIM_MAX]; /* boxes of about two points each */
    size_t count[DIM_MAX];
    size_t *first, *point; /* owned: the points sorted by box */
    size_t along[DIM_MAX]; /* number of lines of points across each axis; 0: no rows and columns */
    double *line[DIM_MAX]; /* owned: their coordinates, ascending */
    double *value;         /* owned: T, the index along the first axis fastest */
};

/* Sorts the points into boxes; the caller keeps the field.  Release with interpolate_end. */
struct interpolate interpolate_begin(const char *name, const struct field *field);
void interpolate_end(struct interpolate *f);

/* Value and gradient at x of the polynomial of degree five through the 6 nearest points of a rod, or fitted by least
 * squares to 36 or more of a rectangle: errors of O(h^6) and O(h^5) for smooth fields; in space of degree three to 64
 * or more, O(h^4) and O(h^3).  `gradient` may be NULL; then
 * a point at x gives its own value.  Returns STATUS_INPUT with *why if there are too few points or rows of
 * points. */
int interpolate_at(const struct interpolate *f, const double *x, double *T, double *gradient, struct failure *why);

/* Finds rows and columns (and layers) among the points, if each of their crossings has one; for interpolate_sure. */
void interpolate_find_rows(struct interpolate *f);

/* The value at x, and in *off its difference from that of a lower degree, an estimate of its error that is too large
 * for smooth fields.  On rows and columns the product of polynomials through eight points along each axis, against
 * six: O(dx^8) and O(dx^6).  On other points least squares of degree five in the plane and four in space, against one
 * less. */
int interpolate_sure(const struct interpolate *f, const double *x, double *T, double *off, struct failure *why);

#endif
