/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_LAYERS_H
#define HEATLADDER_REFERENCES_LAYERS_H

#include "references/series.h"
#include "references/talbot.h"

/* Two layers in contact at x = 0, between walls at -width[0] and width[1]: solutions by the Laplace transform and by
 * eigenfunctions. */
struct layers {
    double width[2]; /* m */
    double k[2];     /* W m^-1 K^-1 */
    double rho_c[2]; /* J m^-3 K^-1 */
    double wall[2];  /* K, Dirichlet value at the outer face of each layer */
    double start[2]; /* K, uniform initial temperature of each layer */
    double R;        /* m^2 K W^-1, resistance of the contact: T falls by R times the flux; 0: perfect */
};

/* The contour of the numerical inversion at one time, with the factors of the transform that do not depend on x. */
struct layers_contour {
    struct layers w;
    double error[2]; /* K and K m^-1 */
    struct {
        double complex q;    /* m^-1: sqrt(z rho_c/k) */
        double complex wall; /* K: factor of sinh(q d), d the distance to the contact */
        double complex core; /* K: factor of sinh(q (width - d)) */
    } node[2][TALBOT_NODES]; /* by layer */
};

/* t > 0 s */
void layers_contour(const struct layers *w, double t, struct layers_contour *c);

/* T (K) and dT/dx (K m^-1) at -width[0] <= x <= width[1].  The error is below 1e-12 of the largest temperature
 * difference. */
struct curve layers_contour_at(const struct layers_contour *c, double x);

/* The transient part at one time, as a sum of eigenfunctions; both layers have the same initial temperature. */
enum { LAYERS_MODES = 2048 };
struct layers_modes {
    struct layers w;
    int n;           /* number of modes with amplitude above 1e-18 */
    double error[2]; /* K and K m^-1, for any x */
    struct {
        double size[2], q[2]; /* K, m^-1, by layer: mode size sin(q (distance to the wall)) */
    } mode[LAYERS_MODES];
};

/* Estimated number of significant modes at t > 0 s. */
double layers_modes_needed(const struct layers *w, double t);
void layers_modes(const struct layers *w, double t, struct layers_modes *m);

/* The steady state plus the transient modes. */
struct curve layers_modes_at(const struct layers_modes *m, double x);

#endif
