/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_COOLING_H
#define HEATLADDER_REFERENCES_COOLING_H

/* A slab [0, L] with its end x = L cooled, dT/dx = -h T with h = b/k, m^-1; the other is held at zero or insulated.
 */

/* sin(q x) where the other end is held, cos(q x) where it is insulated. */
struct cooling_mode {
    double q;          /* m^-1 */
    double norm;       /* m: integral of the square */
    double integral;   /* m: integral */
    double end_cosine; /* cos(q L) */
};

/* The n-th, n >= 1, of finite h >= 0. */
struct cooling_mode cooling_mode(int n, int insulated, double L, double h);

/* The half line d >= 0 from 1, whose end d = 0 is cooled from t = 0 on; s = sqrt(4 kappa t) > 0, m. */
struct cooling_half {
    double T;      /* erf(d/s) + E */
    double slope;  /* m^-1: by d, h E */
    double change; /* m^-1: by s */
    double end;    /* E = exp(h d + (h s/2)^2) erfc(d/s + h s/2) */
};

/* At d, m, for h, m^-1, and s, m: all >= 0. */
struct cooling_half cooling_half(double d, double h, double s);

#endif
