/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Talbot's inversion by the midpoint rule with N points on the contour
 *
 *     z(a) = N/t (0.5017 a cot(0.6407 a) - 0.6122 + 0.2645 i a),   -pi < a < pi.
 *
 * The error decreases as 3.89^-N (Trefethen, Weideman, Schmelzer 2006, BIT 46:653); at N = 24 it equals round-off.
 * Only one node of each conjugate pair is evaluated. */
#include "references/talbot.h"

#include <math.h>

void talbot_node(int j, double complex *z, double complex *weight) {
    enum { N = 2 * TALBOT_NODES };
    double a = (2 * j + 1) * M_PI / N, cot = 1 / tan(0.6407 * a);
    *z = N * (0.5017 * a * cot - 0.6122 + 0.2645 * I * a);
    *weight = cexp(*z) * (0.5017 * cot - 0.5017 * 0.6407 * a * (1 + cot * cot) + 0.2645 * I) * 2;
}

double complex talbot_one_less(double complex u, double complex e) {
    if (cabs(u) > 0.5) return 1 - e * e;
    double a = creal(u), b = cimag(u), left = exp(-2 * a);
    return -expm1(-2 * a) + 2 * left * sin(b) * sin(b) + I * left * sin(2 * b);
}
