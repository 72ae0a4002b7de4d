/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_BESSEL_H
#define HEATLADDER_REFERENCES_BESSEL_H

#include <complex.h>

/* exp(-z) I_n(z) for n = 0 or 1, Re z >= 0 and |arg z| < 1.4.  Error: about 1e-15 of exp(-z) I_0(z). */
double complex bessel_scaled(int n, double complex z);

#endif
