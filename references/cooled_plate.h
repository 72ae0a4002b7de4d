/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_COOLED_PLATE_H
#define HEATLADDER_REFERENCES_COOLED_PLATE_H

#include "references/rectangle.h"

#include <stddef.h>

/* A plate [0, W] x [0, H] at zero whose side y = 0 is held at 1 from t = 0 on; x = 0 is insulated, the other two are
 * cooled, dT/dn = -h T, h in m^-1.  s = sqrt(4 kappa t), m, stands for the time. */

enum { COOLED_PLATE_NODES = 16 };

/* What all points share at one time. */
struct cooled_plate {
    double W, H, h, s; /* m, m^-1 */
    double hot, start; /* K: the side's temperature, and that of all at t = 0 */
    double early;      /* m: the width up to which half lines do */
    double node[COOLED_PLATE_NODES], weight[COOLED_PLATE_NODES];
    double error[2]; /* K, K m^-1 */
    int m, n;        /* modes along x and y; 0 while it is early */
    double mode[];   /* wave numbers along x (m) and y (n), the start's sizes along x and y, the hot side's (m rows
                        of n), K */
};

/* *hot and *start above the air; s > 0.  To be freed by free(). */
struct cooled_plate *cooled_plate(double W, double H, double h, double hot, double start, double s);

/* Temperatures (K), their gradients (K m^-1) and their bounds at the n points (x[i], y[i]), m: cheaper where they are
 * those of a lattice, row by row. */
void cooled_plate_at(const struct cooled_plate *c, size_t n, const double *x, const double *y, struct surface *T);

/* The same temperature from the steady sine or cosine series less the transient one, summed for each point; s
 * may be INFINITY. */
struct approx cooled_plate_series(double W, double H, double h, double hot, double start, double s,
                                  const double x[2]);

#endif
