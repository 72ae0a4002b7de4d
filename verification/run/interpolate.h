/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_INTERPOLATE_H
#define HEATLADDER_VERIFICATION_RUN_INTERPOLATE_H

/* Temperatures and gradients between scattered points. */

#include <stddef.h>

struct failure;

struct interpolate {
    const char *name; /* name of the field, for messages */
    int dim;
    size_t n;
    const double *x, *y, *T; /* m, m, K; y is NULL for a rod */
    double from, to;         /* uses only points with from <= x <= to: one side of a kink */
    double lo[2], side[2];   /* boxes of about two points each */
    size_t count[2];
    size_t *first, *point; /* owned: the points sorted by box */
};

/* Sorts the points into boxes; the caller keeps the arrays.  Release with interpolate_end. */
struct interpolate interpolate_begin(const char *name, int dim, size_t n, const double *x, const double *y,
                                     const double *T);
void interpolate_end(struct interpolate *f);

/* Value and gradient at x of the polynomial of degree five through the 6 nearest points of a rod, or fitted by least
 * squares to 36 or more of a rectangle: errors of O(h^6) and O(h^5) for smooth fields.  `gradient` may be NULL; then
 * a point at x gives its own value.  Returns STATUS_INPUT with *why if there are too few points or rows of
 * points. */
int interpolate_at(const struct interpolate *f, const double x[2], double *T, double gradient[2],
                   struct failure *why);

#endif
