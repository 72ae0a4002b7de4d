/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H

#include "solver/method.h"
#include <stddef.h>

/* The grid of the finite differences: its points, its ghosts, what it starts from and how it steps. */

struct problem;
struct options;
struct failure;
struct ftcs_loops;
struct field;

enum { FTCS_LAYERS = 2 }; /* of ghosts: the fluxes reach two points far */

/* T of ghost m = sign[m] T[mirror[m]] + offset[m length + place along the side]; m = 0 touches the grid. */
struct ftcs_edge {
    double sign[FTCS_LAYERS];
    int mirror[FTCS_LAYERS]; /* counted from the side inwards */
    double *offset;          /* K */
};

struct ftcs_grid {
    const char *method; /* its name */
    const struct ftcs_loops *loops;
    int with_fluxes, dim;
    int n[2];               /* unknowns along x and y; 1 along y for a rod */
    double origin[2], d[2]; /* m: the first unknown, the spacing; a rod is 1 m high */
    double end_cell[4];     /* by enum side: the part of its cell that the unknown at the side has inside, 1 or 1/2 */
    double kappa[2];        /* m^2 s^-1; 0 along y for a rod */
    double rho_c;           /* J m^-3 K^-1; the least, of two materials */
    double *layers[4];      /* two materials, by column: rho_c, J m^-3 K^-1; k / (rho_c d^2), s^-1, to its left and
                               right, and along y (NULL for a rod).  Else NULL */
    double dt, start;       /* s: the step; what the clock shows when the run starts */
    double alternation;     /* odd steps take (1 + alternation) dt, even ones (1 - alternation) dt */
    long long steps;
    double lowest, highest;   /* K, of the sampled initial data */
    double middle, reach;     /* K: a stable solution stays within middle +- reach */
    ptrdiff_t stride, corner; /* from row to row; from the start of T to unknown (0, 0) */
    size_t size, held;        /* doubles: of T with its ghosts; of all that is allocated */
    struct ftcs_edge edge[4]; /* by enum side */
    double *T, *next;         /* K; `next` is NULL with fluxes: they step in place */
    double *q;                /* K m s^-1: one row of q_x, then three of q_y; NULL without fluxes */
    double *heating;          /* K s^-1, G / rho_c; NULL where there is no source */
    double *warming[2];       /* of a source that changes: `heating` at t = 0, and what it gains, K s^-2; else NULL */
};

/* 0 and *g ready for its first step, to be given to ftcs_grid_free; or STATUS_INPUT, *why filled and nothing held. */
int ftcs_grid_make(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
                   const struct options *o, struct failure *why);
void ftcs_grid_free(struct ftcs_grid *g);
void ftcs_grid_keep_T(struct ftcs_grid *g); /* frees all that a finished run needs no more */

/* Sets `heating` to that of the time t, s, of a source that changes. */
void ftcs_grid_source(struct ftcs_grid *g, double t);

/* Sets the ghosts from the unknowns. */
void ftcs_grid_walls(const struct ftcs_grid *g);

/* m^d: the part of the domain that unknown (i, j) stands for. */
double ftcs_grid_cell(const struct ftcs_grid *g, int i, int j);

/* J m^-3 K^-1, of column i. */
double ftcs_grid_rho_c(const struct ftcs_grid *g, int i);

/* The initial temperature, K, that the grid point at x stands for: the value there, or its average over the point's
 * cell or with the cubic B-spline on spacings d (m, along x and y). */
double ftcs_sample(const struct problem *p, const double x[2], const double d[2], enum sampling how);

/* ftcs in a disc or an annulus, on a grid of rings and rays. */

/* As method_solve, of a round body. */
int ftcs_polar_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why);

#endif
