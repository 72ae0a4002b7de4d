/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_GRID_H

#include "solver/method.h"
#include "solver/problem.h"
#include <stddef.h>

/* The grid of the finite differences: points, ghosts, initial data and time step. */

struct options;
struct failure;
struct ftcs_loops;
struct field;

enum { FTCS_LAYERS = 2 }; /* layers of ghosts: the flux form needs two */

/* T of ghost m = sign[m] T[mirror[m]] + offset[m places + place on the side]; m = 0 is next to the grid.  Places
 * follow the other two axes, the lower axis fastest. */
struct ftcs_edge {
    int places;
    double sign[FTCS_LAYERS];
    int mirror[FTCS_LAYERS];   /* index from the side inwards */
    double apart[FTCS_LAYERS]; /* m, from the ghost to its mirror image */
    double *offset;            /* K */
};

struct ftcs_grid {
    const char *method; /* name for messages */
    const struct ftcs_loops *loops;
    int with_fluxes, dim;
    int n[DIM_MAX];                     /* unknowns by axis; 1 past dim */
    double origin[DIM_MAX], d[DIM_MAX]; /* m: the first unknown, the spacing; 0 and 1 m past dim */
    double end_cell[SIDES];             /* by enum side: fraction of the outermost cell inside the domain, 1 or 1/2 */
    double kappa[DIM_MAX];              /* m^2 s^-1; 0 past dim */
    double rho_c;                       /* J m^-3 K^-1; the smaller of two materials */
    double *layers[5];  /* two materials, by column: rho_c, J m^-3 K^-1; k / (rho_c d^2), s^-1, to the left, to
                           the right, along y and along z (NULL past dim); else NULL */
    double dt, start;   /* s: the step; the initial time of the run */
    double alternation; /* odd steps are (1 + alternation) dt, even ones (1 - alternation) dt */
    long long steps;
    double lowest, highest;            /* K, of the sampled initial data */
    double data[2], inflow;            /* K: range of initial data and walls; possible effect of source and fluxes */
    double middle, reach;              /* K: a stable solution stays within middle +- reach */
    ptrdiff_t stride[DIM_MAX], corner; /* offset to the next unknown by axis; from the start of T to the first one */
    size_t size, held;                 /* number of doubles: in T with its ghosts; allocated in total */
    struct ftcs_edge edge[SIDES];
    double *T, *next;   /* K; `next` is NULL with fluxes, which step in place */
    double *q;          /* K m s^-1: one row of q_x, three of q_y, three planes of q_z; NULL without fluxes */
    double *heating;    /* K s^-1, G / rho_c; NULL without a source */
    double *warming[2]; /* source that depends on time: `heating` at t = 0, and its rate, K s^-2; else NULL */
};

/* Returns 0 with *g ready for its first step, to be released by ftcs_grid_free; or a refusal with *why and nothing
 * allocated. */
int ftcs_grid_make(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
                   const struct options *o, struct failure *why);
void ftcs_grid_free(struct ftcs_grid *g);
void ftcs_grid_keep_T(struct ftcs_grid *g); /* frees all arrays except T */

/* Evaluates a source that depends on time at t, s. */
void ftcs_grid_source(struct ftcs_grid *g, double t);

/* The ghosts of one side (everything but its data); the data of all sides at time t, s, which widen `data`, `inflow`
 * and the reach; the ghosts from the unknowns. */
void ftcs_edge_make(struct ftcs_grid *g, const struct problem *p, const struct options *o, enum side s);
void ftcs_edge_data(struct ftcs_grid *g, const struct problem *p, double t);
void ftcs_edge_walls(const struct ftcs_grid *g);

/* m^dim: volume of the cell of unknown i[]. */
double ftcs_grid_cell(const struct ftcs_grid *g, const int i[DIM_MAX]);

/* Number of unknowns; the offset of unknown i[] in T; its coordinates, m; the next unknown, x fastest. */
ptrdiff_t ftcs_grid_points(const struct ftcs_grid *g);
ptrdiff_t ftcs_grid_at(const struct ftcs_grid *g, const int i[DIM_MAX]);
void ftcs_grid_place(const struct ftcs_grid *g, const int i[DIM_MAX], double x[DIM_MAX]);
void ftcs_grid_next(const struct ftcs_grid *g, int i[DIM_MAX]);

/* J m^-3 K^-1, of column i. */
double ftcs_grid_rho_c(const struct ftcs_grid *g, int i);

/* Initial temperature of the grid point at x, K: the value there, its cell average, or its average with the cubic
 * B-spline on the spacings d (m, by axis). */
double ftcs_sample(const struct problem *p, const double *x, const double *d, enum sampling how);

/* method_solve with ftcs for a disc or an annulus, on a grid of rings and rays. */
int ftcs_polar_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                     struct failure *why);

/* method_solve with ftcs for a conductivity that depends on temperature. */
int ftcs_nonlinear_solve(const char *method, const struct problem *p, const struct options *o, struct field *f,
                         struct failure *why);

#endif
