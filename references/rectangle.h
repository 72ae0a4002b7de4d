/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_RECTANGLE_H
#define HEATLADDER_REFERENCES_RECTANGLE_H

#include "references/series.h"

/* A rectangle at zero whose sides are held at temperatures of their own from t = 0 on; s = sqrt(4 kappa t), m, stands
 * for the time. */

enum { RECTANGLE_MODES = 56 }; /* along an axis; 53 are the most that can count, see rectangle.c */

/* What all points share at one time. */
struct rectangle {
    double extent[2], reach[2], cut[2]; /* m; cut: the extent without its middle, where the ends are not felt */
    double side[4];                     /* K, indexed by enum side */
    int rows, count[RECTANGLE_MODES];   /* modes that count: rows n, and m in each */
    double error[3];                    /* K; K m^-1 along x and y, whatever the point */
    double mode[RECTANGLE_MODES][RECTANGLE_MODES]; /* K: [n][m] of sin(m pi x/cut) sin(n pi y/cut) */
};

struct surface {
    struct approx at;       /* K */
    struct approx slope[2]; /* K m^-1, along x and y; without meaning in a corner */
};

/* Extents within a factor of 1e6 of each other; s > 0, INFINITY for the steady state. */
void rectangle_prepare(const double extent[2], const double side[4], double s, struct rectangle *r);
struct surface rectangle_at(const struct rectangle *r, const double x[2]);

/* One hot side, held at 1: the steady temperature at the distance xi from it (0 <= xi <= W) and eta from one of its
 * neighbours (0 <= eta <= B). */
struct approx rectangle_steady(double xi, double W, double eta, double B);

/* The same after the time s, from quadrature over time of the wall's Green's function (rectangle_quadrature.c). */
struct approx rectangle_quadrature(double xi, double W, double eta, double B, double s);

#endif
