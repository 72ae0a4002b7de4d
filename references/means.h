/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_MEANS_H
#define HEATLADDER_REFERENCES_MEANS_H

struct image;

/* K: the temperature that keeps the initial heat of the part of the body from lo to hi (m): the integral of rho_c T
 * over that of rho_c.  A cell of zero extent has the value at its point. */
double means_initial(const struct image *image, const double *lo, const double *hi);

#endif
