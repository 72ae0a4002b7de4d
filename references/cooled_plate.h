/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_COOLED_PLATE_H
#define HEATLADDER_REFERENCES_COOLED_PLATE_H

#include "references/rectangle.h"

#include <stddef.h>

/* A plate [0, W] x [0, H], initially at zero.  The side y = 0 is held at 1 from t = 0 on, x = 0 is insulated, and
 * the other two sides are cooled: dT/dn = -h T, h in m^-1.  The diffusion width s = sqrt(4 kappa t), m, represents
 * the time. */

enum { COOLED_PLATE_NODES = 16 };

/* Terms of the solution at one time that all points share. */
struct cooled_plate {
    double W, H, h, s; /* m, m^-1 */
    double hot, start; /* K: the hot side, and the initial temperature */
    double early;      /* m: largest width at which the half-line solutions hold */
    double node[COOLED_PLATE_NODES], weight[COOLED_PLATE_NODES];
    double error[2]; /* K, K m^-1 */
    int m, n;        /* number of modes along x and y; 0 at early times */
    double mode[]; /* wave numbers along x, then y (m^-1); amplitudes of the initial data along x, then y; amplitudes
                      of the hot side's response, m rows of n (K) */
};

/* Temperatures are relative to the air; s > 0.  The caller frees the result by free(). */
struct cooled_plate *cooled_plate(double W, double H, double h, double hot, double start, double s);

/* Temperatures (K), gradients (K m^-1) and their error bounds at the n points (x[i], y[i]), m.  Points of a lattice
 * in row order share work. */
void cooled_plate_at(const struct cooled_plate *c, size_t n, const double *x, const double *y, struct surface *T);

/* Second form of the same temperature: a steady sine or cosine series minus the transient double series, summed at
 * each point. s may be INFINITY. */
struct approx cooled_plate_series(double W, double H, double h, double hot, double start, double s,
                                  const double x[2]);

#endif
