/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_COOLING_H
#define HEATLADDER_REFERENCES_COOLING_H

/* A slab [0, L] with a cooled end x = L: dT/dx = -h T, h = b/k in m^-1.  The other end is held at zero or insulated.
 */

/* The mode is sin(q x) if the other end is held at zero, cos(q x) if it is insulated. */
struct cooling_mode {
    double q;          /* m^-1 */
    double norm;       /* m: integral of the squared mode */
    double integral;   /* m: integral of the mode */
    double end_cosine; /* cos(q L) */
};

/* Mode n >= 1 for finite h >= 0. */
struct cooling_mode cooling_mode(int n, int insulated, double L, double h);

/* The half line d >= 0, initially at 1 and cooled at d = 0 from t = 0 on; s = sqrt(4 kappa t) > 0, m. */
struct cooling_half {
    double T;      /* erf(d/s) + E */
    double slope;  /* m^-1: dT/dd = h E */
    double change; /* m^-1: dT/ds */
    double end;    /* E = exp(h d + (h s/2)^2) erfc(d/s + h s/2) */
};

/* exp(y^2) erfc(y), y >= 0, with a relative error of 60 eps. */
double cooling_erfcx(double y);

/* d in m, h in m^-1, s in m; d and h >= 0. */
struct cooling_half cooling_half(double d, double h, double s);

#endif
