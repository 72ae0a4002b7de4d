/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_CHECKERBOARD_H
#define HEATLADDER_VERIFICATION_RUN_CHECKERBOARD_H

struct field;
struct problem;

/* The largest amplitude, K, among the modes of the error T - exact that have 2 to 4 points to a wavelength along some
 * axis; a pure mode of amplitude c gives c.  NaN where the field is on no lattice. */
double checkerboard_amplitude(const struct problem *p, const struct field *f, const double *exact);

#endif
