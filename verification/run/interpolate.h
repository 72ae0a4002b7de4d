/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_INTERPOLATE_H
#define HEATLADDER_VERIFICATION_RUN_INTERPOLATE_H

/* Temperatures and gradients between scattered points. */

#include <stddef.h>

struct failure;

struct interpolate {
    const char *name; /* of the field, for messages */
    int dim;
    size_t n;
    const double *x, *y, *T; /* m, m, K; y is NULL for a rod */
    double from, to;         /* only points with from <= x <= to count: one side of a kink */
    double lo[2], side[2];   /* boxes of some two points each */
    size_t count[2];
    size_t *first, *point; /* owned: the points by their boxes */
};

/* Sorts the points into boxes; the arrays stay the caller's.  End with interpolate_end. */
struct interpolate interpolate_begin(const char *name, int dim, size_t n, const double *x, const double *y,
                                     const double *T);
void interpolate_end(struct interpolate *f);

/* Value and gradient at x of the polynomial of degree five through the 6 nearest points of a rod, or fitted by least
 * squares to 36 or more of a rectangle: wrong by O(h^6) and O(h^5) for smooth fields.  `gradient` may be NULL; then a
 * point at x gives its own value.  STATUS_INPUT with *why where there are too few points, or these lie on too few
 * lines. */
int interpolate_at(const struct interpolate *f, const double x[2], double *T, double gradient[2],
                   struct failure *why);

#endif
