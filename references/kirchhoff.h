/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_KIRCHHOFF_H
#define HEATLADDER_REFERENCES_KIRCHHOFF_H

#include "references/scene.h"

/* The law k(T) of a problem, and Kirchhoff's transform theta, the integral of k from k_ref to T (Carslaw & Jaeger
 * 1959, section 2.16): div(k grad T) = lap theta. */

double kirchhoff_k(const struct problem *p, double T);     /* W m^-1 K^-1 */
double kirchhoff_slope(const struct problem *p, double T); /* dk/dT, W m^-1 K^-2 */
double kirchhoff_theta(const struct problem *p, double T); /* W m^-1 */

/* k that a code uses along the axis at x, where the temperature is T, W m^-1 K^-1. */
double kirchhoff_along(const struct problem *p, const struct material *m, int axis, double T);

/* The linear law from the parameters k_0, k_beta, k_ref (indices of the table), with the heat capacity rho_c. Refuses
 * a k that is not positive from lo to hi, K. */
int kirchhoff_linear(const struct param *table, struct problem *p, const int index[3], double rho_c, double lo,
                     double hi, struct failure *why);

#endif
