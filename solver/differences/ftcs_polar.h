/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_POLAR_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_POLAR_H

#include <stddef.h>

/* The grid of a round body (ftcs_polar.c): rays around the axis, each of bands from pole to pole (one in a disc) of
 * rings.  A line is one band of one ray, a sheet all bands of one ray. */

struct polar {
    const char *method;
    int dim, rings, bands, rays;
    double dr, dtheta, down, hole; /* m; rad, between rays; rad, between bands; m, radius of the hole */
    double dt;                     /* s */
    long long steps;
    double rho_c, kappa; /* J m^-3 K^-1; m^2 s^-1 */
    double *in, *out;    /* s^-1, by ring: conductance to the inner and outer ring or wall */
    double *lower, *upper,
        *around;       /* ball, by cell of a sheet: rates to the bands beside and to the rays beside, times dt */
    double *z, *scale; /* disc, by ring: the root z; (1 - z)^2 */
    struct polar_modes *modes; /* ball */
    double *beside[2];         /* K, by line: temperature beyond the wall of the hole and beyond the outer wall */
    double *heating;           /* K s^-1, by cell: source and given flux */
    double *T;                 /* K, rings x bands x rays, rings fastest */
    double *row, *sum;         /* by cell of a sheet: scratch; disc, by ring, K: initial values of the next sweep */
    double lowest, highest;    /* K, of the initial data */
    double middle, reach;      /* K: a stable solution stays within middle +- reach */
};

/* m, of the middle of a ring; area of a sphere or circle of radius r per steradian or radian, m^(dim-1); volume of a
 * ring per steradian or radian, m^dim. */
double ftcs_polar_radius(const struct polar *g, int ring);
double ftcs_polar_face(const struct polar *g, double r);
double ftcs_polar_wedge(const struct polar *g, int ring);

/* Conductances (0 to a wall) and the rates or roots of the implicit part. */
void ftcs_polar_step_factors(struct polar *g);

/* Transforms of T in a ball; freed by ftcs_polar_step_modes_free, which takes NULL. */
struct polar_modes *ftcs_polar_step_modes(const struct polar *g);
void ftcs_polar_step_modes_free(struct polar_modes *m);

/* One step of dt. */
void ftcs_polar_step(struct polar *g);

#endif
