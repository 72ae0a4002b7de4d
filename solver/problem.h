/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PROBLEM_H
#define HEATLADDER_SOLVER_PROBLEM_H

/* What is solved:  rho_c dT/dt = d/dx(k_x dT/dx) + d/dy(k_y dT/dy) + G
 * on a rod [lo[0], hi[0]], a rectangle or another shape.  Data only; SI units.  Sides and coefficients do not change
 * in time, nor does the source but for `source_rate`, so that dT/dt = A T + g with one A and one g. */

enum side { X_LO, X_HI, Y_LO, Y_HI };
/* PERIODIC, in pairs: no wall, the body goes on at the opposite side. */
enum side_kind { DIRICHLET, NEUMANN, ROBIN, PERIODIC };
enum { PARAM_MAX = 12, JUMP_MAX = 4, MATERIAL_MAX = 2 };

struct shape; /* shape.h */

struct material {
    double k[2];  /* W m^-1 K^-1, along x and y */
    double rho_c; /* J m^-3 K^-1 */
};

struct problem {
    int dim;                   /* 1 or 2 */
    double lo[2], hi[2];       /* m; a rod has lo[1] = hi[1] = 0; else the box around the body */
    const struct shape *shape; /* NULL: the body is that box */
    double radius[2];          /* m, of a round shape about 0: of its hole (0: none), and of the outer wall */
    double t_end;              /* s */
    int materials;             /* material[0] lies at x < interface, material[1] at x >= interface */
    double interface;          /* m */
    struct material material[MATERIAL_MAX]; /* */
    enum side_kind side[4];                 /* indexed by enum side; round: X_LO the hole, X_HI the outer wall */
    double robin[4];                        /* W m^-2 K^-1, >= 0, of a ROBIN side: b of k dT/dn = b (T_a - T) */
    double start;                           /* K, everywhere, where `initial` is problem_start */
    double held[4];                         /* by side, where `wall` is problem_held */
    int jumps[2];                           /* how many planes x = const, y = const the initial data jump across */
    double jump[2][JUMP_MAX];               /* m, ascending */
    int mirror[2];                          /* 1 where the whole problem is even about the middle of that axis */
    const struct problem *whole;            /* what this is the upper half or quarter of; NULL for a whole problem */
    const void *data;                       /* of the functions below where no scene made them; NULL of a scene */
    double param[PARAM_MAX];                /* the scene's own parameters, in the order of its table */

    /* K at x[0], x[1]; on a jump, the value of the closed piece (Song eq. 43) */
    double (*initial)(const struct problem *p, const double x[2]);
    /* Dirichlet: the wall's temperature, K.  Neumann: the heat flux into the body, k dT/dn, W m^-2.  Robin: the
     * ambient temperature T_a, K (Song eq. 4).  x is taken to the wall along the axis of the side; its other
     * coordinate may lie a few spacings outside (ghosts at corners).  On a round wall the direction of x counts. */
    double (*wall)(const struct problem *p, enum side s, const double x[2]);
    /* W m^-3, at t = 0; NULL where there is none.  x may lie a few spacings outside */
    double (*source)(const struct problem *p, const double x[2]);
    /* W m^-3 s^-1, what the source gains in time, the same at all times; NULL where it gains nothing.  Zero on
     * Dirichlet sides and without a slope across the others, so that ghosts are those of `source` */
    double (*source_rate)(const struct problem *p, const double x[2]);
};

/* The largest diffusivity of all materials and axes, m^2 s^-1. */
double problem_diffusivity(const struct problem *p);

/* An `initial` and a `wall` that are the same at each x: p->start, and p->held[s]. */
double problem_start(const struct problem *p, const double x[2]);
double problem_held(const struct problem *p, enum side s, const double x[2]);

/* The whole source at x and the time t, W m^-3; 0 where there is none. */
double problem_source(const struct problem *p, const double x[2], double t);

#endif
