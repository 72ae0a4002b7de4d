/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_ROOTS_H
#define HEATLADDER_REFERENCES_ROOTS_H

/* Roots of transcendental equations written as increasing phases, one root for each multiple of pi, so that none is
 * missed. */

/* The root of an increasing f with f(lo) <= 0 <= f(hi), to a unit or two in the last place, by Brent's method (GSL).
 */
double roots_increasing(double (*f)(double z, const void *data), const void *data, double lo, double hi);

/* n-th root, n >= 1, of z cot z = -biot (`insulated` 0: the other end is held) or z tan z = biot (1: it is
 * insulated), biot from 0 to INFINITY:  z + atan2(z, biot) = n pi, or (n - 1/2) pi. */
double roots_cooled(int n, int insulated, double biot);

#endif
