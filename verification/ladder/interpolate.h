#ifndef HEATLADDER_VERIFICATION_LADDER_INTERPOLATE_H
#define HEATLADDER_VERIFICATION_LADDER_INTERPOLATE_H

struct failure;
struct samples;

/* The temperature at x of a field on scattered points: that of a point there, else the value at x of the polynomial
 * of degree three which fits the nearest points by least squares (7 on a rod, 20 on a rectangle), wrong by O(h^4) for
 * smooth fields.  STATUS_INPUT with *why where there are too few points, or these lie on a line. */
int interpolate_at(const struct samples *s, const double x[2], double *T, struct failure *why);

#endif
