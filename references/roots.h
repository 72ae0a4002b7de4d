/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_ROOTS_H
#define HEATLADDER_REFERENCES_ROOTS_H

#include "solver/problem.h"

/* Roots of transcendental equations.  Each equation is written as an increasing phase with one root for each
 * multiple of pi, so no root is missed. */

/* Root of an increasing f with f(lo) <= 0 <= f(hi) by Brent's method (GSL), to one or two units in the last place.
 */
double roots_increasing(double (*f)(double z, const void *data), const void *data, double lo, double hi);

/* Root n >= 1 of z cot z = -biot (`insulated` 0: the other end is held at zero) or z tan z = biot (`insulated` 1),
 * for 0 <= biot <= INFINITY:  z + atan2(z, biot) = n pi, or (n - 1/2) pi. */
double roots_cooled(int n, int insulated, double biot);

/* First positive root of J_m (DIRICHLET), J_m' (NEUMANN) or z J_m' + biot J_m (ROBIN, biot > 0), m >= 0, for Bessel
 * functions (`spherical` 0: J(m, z) = J_m(z)) or spherical ones (1: j_m(z)). */
double roots_round(double (*J)(int m, double z), int m, int spherical, enum side_kind wall, double biot);

#endif
