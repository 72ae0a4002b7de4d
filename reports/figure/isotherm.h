/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIGURE_ISOTHERM_H
#define HEATLADDER_REPORTS_FIGURE_ISOTHERM_H

/* Isotherms of temperatures on a lattice, as lines that can be drawn. */

#include <stdio.h>

struct isotherm_grid {
    int n[2];           /* points along x and y, x fastest */
    double lo[2], d[2]; /* m */
    double *T;          /* K, n[0] n[1] */
};

/* Writes x,y,level rows, each line of the level followed by a blank line.  `at` gets the point at that part
 * (0 to 1) of the longest line, m.  Returns how many lines there are. */
int isotherm_trace(const struct isotherm_grid *g, double level, double part, FILE *out, double at[2]);

/* The same temperatures `times` as finely, by a bicubic spline (GSL).  The caller frees T. */
struct isotherm_grid isotherm_refine(const struct isotherm_grid *g, int times);

#endif
