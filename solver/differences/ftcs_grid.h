/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H

#include "solver/method.h"
#include <stddef.h>

/* The grid of the finite differences: points, ghosts, initial data and time step. */

struct problem;
struct options;
struct failure;
struct ftcs_loops;
struct field;

enum { FTCS_LAYERS = 2 }; /* layers of ghosts: the flux form needs two */

/* T of ghost m = sign[m] T[mirror[m]] + offset[m length + place along the side]; m = 0 is next to the grid. */
struct ftcs_edge {
    double sign[FTCS_LAYERS];
    int mirror[FTCS_LAYERS]; /* index from the side inwards */
    double *offset;          /* K */
};

struct ftcs_grid {
    const char *method; /* name for messages */
    const struct ftcs_loops *loops;
    int with_fluxes, dim;
    int n[2];               /* unknowns along x and y; 1 along y for a rod */
    double origin[2], d[2]; /* m: the first unknown, the spacing; the height of a rod is 1 m */
    double end_cell[4];     /* by enum side: fraction of the outermost cell inside the domain, 1 or 1/2 */
    double kappa[2];        /* m^2 s^-1; 0 along y for a rod */
    double rho_c;           /* J m^-3 K^-1; the smaller of two materials */
    double *layers[4];  /* two materials, by column: rho_c, J m^-3 K^-1; k / (rho_c d^2), s^-1, to the left, to the
                           right and along y (NULL for a rod); else NULL */
    double dt, start;   /* s: the step; the initial time of the run */
    double alternation; /* odd steps are (1 + alternation) dt, even ones (1 - alternation) dt */
    long long steps;
    double lowest, highest;   /* K, of the sampled initial data */
    double middle, reach;     /* K: a stable solution stays within middle +- reach */
    ptrdiff_t stride, corner; /* offset from row to row; from the start of T to unknown (0, 0) */
    size_t size, held;        /* number of doubles: in T with its ghosts; allocated in total */
    struct ftcs_edge edge[4]; /* by enum side */
    double *T, *next;         /* K; `next` is NULL with fluxes, which step in place */
    double *q;                /* K m s^-1: one row of q_x, then three of q_y; NULL without fluxes */
    double *heating;          /* K s^-1, G / rho_c; NULL without a source */
    double *warming[2];       /* source that depends on time: `heating` at t = 0, and its rate, K s^-2; else NULL */
};

/* Returns 0 with *g ready for its first step, to be released by ftcs_grid_free; or a refusal with *why and nothing
 * allocated. */
int ftcs_grid_make(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
                   const struct options *o, struct failure *why);
void ftcs_grid_free(struct ftcs_grid *g);
void ftcs_grid_keep_T(struct ftcs_grid *g); /* frees all arrays except T */

/* Evaluates a source that depends on time at t, s. */
void ftcs_grid_source(struct ftcs_grid *g, double t);

/* Sets the ghosts from the unknowns. */
void ftcs_grid_walls(const struct ftcs_grid *g);

/* m^dim: volume of the cell of unknown (i, j). */
double ftcs_grid_cell(const struct ftcs_grid *g, int i, int j);

/* J m^-3 K^-1, of column i. */
double ftcs_grid_rho_c(const struct ftcs_grid *g, int i);

/* Initial temperature of the grid point at x, K: the value there, its cell average, or its average with the cubic
 * B-spline on the spacings d (m, along x and y). */
double ftcs_sample(const struct problem *p, const double x[2], const double d[2], enum sampling how);

/* method_solve with ftcs for a disc or an annulus, on a grid of rings and rays. */
int ftcs_polar_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why);

#endif
