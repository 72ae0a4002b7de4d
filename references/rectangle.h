/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_RECTANGLE_H
#define HEATLADDER_REFERENCES_RECTANGLE_H

#include "references/series.h"

/* A rectangle, initially at zero, with a constant temperature on each side from t = 0 on.  The diffusion width
 * s = sqrt(4 kappa t), m, represents the time. */

enum { RECTANGLE_MODES = 56 }; /* per axis; at most 53 are significant, see rectangle.c */

/* Terms of the solution at one time that all points share. */
struct rectangle {
    double extent[2], reach[2], cut[2]; /* m; cut: the extent without the middle part, which the ends do not affect */
    double side[4];                     /* K, indexed by enum side */
    int rows, count[RECTANGLE_MODES];   /* significant modes: number of rows n, and number of m in each row */
    double error[3];                    /* K; K m^-1 along x and y, for any point */
    double mode[RECTANGLE_MODES][RECTANGLE_MODES]; /* K: [n][m], amplitude of sin(m pi x/cut) sin(n pi y/cut) */
};

struct surface {
    struct approx at;       /* K */
    struct approx slope[2]; /* K m^-1, along x and y; undefined in a corner */
};

/* The extents differ by a factor below 1e6; s > 0, INFINITY for the steady state. */
void rectangle_prepare(const double extent[2], const double side[4], double s, struct rectangle *r);
struct surface rectangle_at(const struct rectangle *r, const double x[2]);

/* One hot side at 1: steady temperature at the distance xi from it (0 <= xi <= W) and eta from one of its neighbours
 * (0 <= eta <= B). */
struct approx rectangle_steady(double xi, double W, double eta, double B);

/* Transient temperature for the same side, by quadrature over time of the wall's Green's function. */
struct approx rectangle_quadrature(double xi, double W, double eta, double B, double s);

#endif
