/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_DRIVEN_H
#define HEATLADDER_REFERENCES_DRIVEN_H

#include "references/series.h"

#include <complex.h>

/* A slab 0 <= x <= L, driven periodically at x = 0; the other end is held at zero or insulated.  The temperature is
 * the real part of X(x) exp(i a), where a is the phase of the drive, and X'' = p^2 X. */
struct driven {
    double complex p;    /* m^-1, Re p >= Im p > 0 */
    double complex size; /* K: amplitude of the wave that the drive sends into a half line */
    double complex loss; /* 1 - r far, with the reflection r at x = 0: -1 if held, 1 if the flux is given */
    double L;            /* m */
    int far;             /* reflection at x = L: -1 if held at zero, 1 if insulated */
};

/* The amplitude X (K) at x, and dX/dx (K m^-1) in *slope. */
double complex driven_at(const struct driven *d, double x, double complex *slope);

/* The temperature and its slope at the phase a (rad), with bounds of their rounding errors; `turns` is the size of
 * the terms of a. */
struct curve driven_now(const struct driven *d, double x, double a, double turns);

/* Second form: the sum of damped waves that both ends reflect, in real arithmetic. */
struct approx driven_reflected(const struct driven *d, double x, double a, double turns);

#endif
