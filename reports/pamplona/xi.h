/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_PAMPLONA_XI_H
#define HEATLADDER_REPORTS_PAMPLONA_XI_H

/* Pamplona 2019, eq. 18 and Figures 7 and 8: the xi of smallest error, and the cost of a run. */

#include "solver/options.h"
#include "solver/status.h"

enum { XI_MATERIALS = 3 };
extern const char *const xi_materials[XI_MATERIALS];

/* k/(rho c), m^2/s */
double xi_diffusivity(int material);

/* h = 1.2 * 0.1 m/n, m, of n particles along a side. */
double xi_h(int n);

/* Eqs. 12 and 13 on a lattice: the sum of -F x dx^2 x, F = (dW/dr) r/(r^2 + (eta h)^2), at h/dx. */
double xi_moment(enum kernel_name kernel, double h, double eta);
/* The same with eq. 12 as printed: the component x_ij in place of r. */
double xi_moment_printed(enum kernel_name kernel, double h, double eta);
/* The xi that makes eq. 13 exact for x^2 and y^2: V = area xi/N with N = (n + 4)^2, ghosts counted (eq. 14, m = 0.224
 * kg), is dx^2/M, M the moment at h/dx = 1.2 and eta = 0.1: ((n + 4)/n)^2/M, m. */
double xi_closed_form(int n, enum kernel_name kernel);
/* 9 h^(1/3), m */
double xi_eq18(double h);

/* One setting: particles along a side, material, eq. 15's beta, end time and walls. */
struct xi_best {
    int n, material;
    enum kernel_name kernel;
    double beta, t;    /* -; s */
    const char *walls; /* NULL: fixed, as published */
    double xi;         /* m */
    double error;      /* mean of |e|/T, % */
    long long work;    /* pairs evaluated by one run */
    double seconds;    /* seconds of the last run */
    struct failure failure;
};

/* The one reading of all rows: the plate as stated, the first time of Table 1, beta = 0.08, the cubic kernel
 * (plate.h). */
struct xi_best xi_as_stated(int n, int material);

/* The error at one xi; NaN with b->failure filled. */
double xi_error(struct xi_best *b, double xi);

/* Fills xi, error and work by a golden section around the closed form: the error falls to one minimum and rises. */
void xi_find(struct xi_best *b);

/* log10(work) = at + slope u, u = log10(h) (power) or h; by least squares.  `off` is the rms misfit as a factor - 1.
 */
struct xi_line {
    double at, slope, off;
};
struct xi_line xi_growth(const double *h, const double *work, int n, int power);

#endif
