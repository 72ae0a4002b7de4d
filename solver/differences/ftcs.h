/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_H

#include "solver/field.h"
#include "solver/options.h"
#include "solver/problem.h"

/* The grid of the finite volumes.  Its axes are x, y, z in a rod, rectangle or box, and radius, angle from the axis z
 * and angle around it in a round body (one cell along the second axis in a disc).  A cell is n[0] fastest; arrays by
 * cell have ghosts beyond their walls. */

enum { FTCS_LAYERS = 2 }; /* most layers of ghosts */

/* Ghost m of a side is T = sign T_mirror + offset, by layer and place on the side; m = 0 is next to the grid.  Places
 * follow the other two axes, the lower axis fastest. */
struct ftcs_side {
    int places;                    /* 0: no wall */
    int n[2];                      /* places along the other two axes */
    ptrdiff_t step[2];             /* offsets between them */
    ptrdiff_t ghost[FTCS_LAYERS];  /* offset of the ghost at the first place */
    ptrdiff_t mirror[FTCS_LAYERS]; /* offset of its mirror image */
    double apart[FTCS_LAYERS];     /* m, between the two */
    double *sign, *offset;         /* 1; K.  With k(T) the offset is the value of the wall (ftcs_walls.c). */
};

struct ftcs_grid {
    const struct problem *p;
    const struct options *o;
    const char *method;        /* name for messages */
    int round, changes;        /* 1 for a round body; 1 if walls or source change */
    int reach;                 /* distance of neighbours in cells: 1, with fluxes 2 */
    int width;                 /* 0, 1, 2 for vectors with 2, 4, 8 doubles */
    int n[DIM_MAX];            /* cells by axis; 1 past dim */
    double first[DIM_MAX];     /* coordinate of the first cell */
    double d[DIM_MAX];         /* spacing; 1 past dim */
    double end_cell[SIDES];    /* fraction of the outermost cell inside the domain, 1 or 1/2 */
    ptrdiff_t stride[DIM_MAX]; /* offset to the next cell by axis */
    ptrdiff_t corner;          /* offset of the first cell */
    size_t size, held;         /* doubles: in an array by cell; allocated in total */
    struct ftcs_side side[SIDES];

    /* Conduction: kappa of one material; or, if not NULL, conductances of the faces below each cell and, of the last
     * cell, above it; or theta(T) for T (ftcs_face.c). */
    double kappa[DIM_MAX];          /* m^2 s^-1; 0 past dim; the larger of two materials */
    double *C[DIM_MAX];             /* W K^-1, by face */
    double *weight;                 /* K J^-1, by cell: 1/(rho_c V) */
    ptrdiff_t along[DIM_MAX], base; /* offsets in C and weight, as stride and corner; 0 where they do not vary */
    double *cross;                  /* K s^-1, by cell without ghosts: fluxes of a tensor (ftcs_cross.c); else NULL */
    unsigned insulated;             /* 1 << side: n.K grad T = 0 there (ftcs_cross.c) */
    double *flux[DIM_MAX];          /* K m s^-1, by corner or lower face of each cell */
    double *K[DIM_MAX][DIM_MAX];    /* m^2 s^-1, there; NULL: constant */
    double *law;                    /* k(T): theta, W m^-1, or with other means than kirchhoff k, W m^-1 K^-1 */

    double rho_c;       /* J m^-3 K^-1; the smaller of two materials */
    double dt, start;   /* s: the step; the initial time of the run */
    double alternation; /* odd steps are (1 + alternation) dt, even ones (1 - alternation) dt */
    long long steps, applications;
    int stages;               /* the largest number in a step */
    double range[2];          /* K, of the sampled initial data */
    double data[2], inflow;   /* K: range of initial data and walls; possible effect of source and fluxes */
    double middle, bound;     /* K: a stable solution stays within middle +- bound */
    double *before;           /* K: dt f at the start of the last step but one */
    double time_error;        /* K, as in struct field */
    double *T, *state[3];     /* K; `state` as the stepper needs */
    double *row;              /* scratch, n[0] */
    double *heating;          /* K s^-1, G / rho_c, by cell without ghosts; NULL without a source */
    double *warming[3];       /* coefficients of `heating` in t - since, K s^-(1 + k), where the source changes */
    double since;             /* s */
    struct ftcs_modes *modes; /* transforms around a round body; else NULL */
};

/* ftcs_plan.c: options, points and steps.  Allocates nothing; STATUS_INPUT or STATUS_NOT_APPLICABLE with *why. */
int ftcs_plan(struct ftcs_grid *g, const char *method, int fluxes, const struct problem *p, const struct options *o,
              struct failure *why);

/* ftcs_grid.c: cells, volumes and faces; initial data and source. */
void ftcs_fill(struct ftcs_grid *g);
void ftcs_free(struct ftcs_grid *g, int keep_T);   /* keep_T: all arrays except T */
void ftcs_set_time(struct ftcs_grid *g, double t); /* data of walls and source that change */
void ftcs_set_step(struct ftcs_grid *g, double t); /* coefficients of source_at from t to t + dt */
void ftcs_place(const struct ftcs_grid *g, const int i[DIM_MAX], double x[DIM_MAX]);    /* m, centre of a cell */
void ftcs_point(const struct ftcs_grid *g, const double u[DIM_MAX], double x[DIM_MAX]); /* from grid coordinates */
double ftcs_volume(const struct ftcs_grid *g, const int i[DIM_MAX]);
double ftcs_heat(const struct ftcs_grid *g);
ptrdiff_t ftcs_at(const struct ftcs_grid *g, const int i[DIM_MAX]);
int ftcs_next(const struct ftcs_grid *g, int i[DIM_MAX]); /* 0 after the last cell */

/* ftcs_face.c: the conductance of a face. */
double ftcs_face_rho_c(const struct problem *p, double d, double x);
double ftcs_face_k(const struct problem *p, enum mean mean, int axis, double d, double x);
void ftcs_face_parts(const struct problem *p, double d, double x, double share[2], double middle[2]);
double ftcs_face_law(const struct problem *p, double T);
double ftcs_face_state(const struct problem *p, double T); /* phases: U (ftcs_face.c); else T */
double ftcs_face_temperature(const struct problem *p, double U);
double ftcs_face_wall(const struct ftcs_grid *g, enum side s, double T, double k, double value, double half);
void ftcs_face_refresh(struct ftcs_grid *g, const double *T);

/* ftcs_cross.c: the fluxes of a tensor from the state T with its ghosts, into g->cross. */
void ftcs_cross_make(struct ftcs_grid *g);
void ftcs_cross(const struct ftcs_grid *g, double *T);

/* ftcs_walls.c: the ghosts of a side (all but its data), their data at time t, the ghosts of T. */
void ftcs_wall_make(struct ftcs_grid *g, enum side s);
void ftcs_wall_data(struct ftcs_grid *g, double t);
void ftcs_wall_ghosts(struct ftcs_grid *g, double *T);

/* ftcs_step.c: all steps.  Returns STATUS_OK, or STATUS_UNSTABLE with *why. */
int ftcs_run(struct ftcs_grid *g, struct failure *why);

/* ftcs_round.c */
double ftcs_round_volume(const struct ftcs_grid *g, const int i[DIM_MAX]);
double ftcs_round_face(const struct ftcs_grid *g, int axis, const int i[DIM_MAX]);
void ftcs_round_make(struct ftcs_grid *g);
void ftcs_round_free(struct ftcs_grid *g);
void ftcs_round_angles(const struct ftcs_grid *g, double *T);

/* ftcs_sample.c: the initial value of a cell of width d about x. */
double ftcs_sample(const struct problem *p, const double *x, const double *d, enum sampling how);

#endif
