/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PROBLEM_H
#define HEATLADDER_SOLVER_PROBLEM_H

/* The problem:  rho_c dT/dt = d/dx(k_x dT/dx) + d/dy(k_y dT/dy) + G on a rod [lo[0], hi[0]], a rectangle or another
 * shape.  Data only; SI units.  Sides and coefficients are steady, and so is the source except for `source_rate`, so
 * that dT/dt = A T + g with constant A and g. */

enum side { X_LO, X_HI, Y_LO, Y_HI };
/* PERIODIC sides come in pairs, without a wall. */
enum side_kind { DIRICHLET, NEUMANN, ROBIN, PERIODIC };
enum { PARAM_MAX = 12, JUMP_MAX = 4, MATERIAL_MAX = 2 };

struct shape; /* shape.h */

struct material {
    double k[2];  /* W m^-1 K^-1, along x and y */
    double rho_c; /* J m^-3 K^-1 */
};

struct problem {
    int dim;                   /* 1 or 2 */
    double lo[2], hi[2];       /* m; a rod has lo[1] = hi[1] = 0; for other shapes the bounding box */
    const struct shape *shape; /* NULL: a rod or a rectangle */
    double radius[2];          /* m, of a round body about 0: radius of its hole (0: none) and of the outer wall */
    double t_end;              /* s */
    int materials;             /* material[0] is at x < interface, material[1] at x >= interface */
    double interface;          /* m */
    struct material material[MATERIAL_MAX];
    enum side_kind side[4];      /* indexed by enum side; in a round body X_LO is the hole, X_HI the outer wall */
    double robin[4];             /* W m^-2 K^-1, >= 0, of a ROBIN side: b in k dT/dn = b (T_a - T) */
    double start;                /* K, uniform initial value if `initial` is problem_start */
    double held[4];              /* by side, if `wall` is problem_held */
    int jumps[2];                /* number of planes x = const and y = const at which the data jump */
    double jump[2][JUMP_MAX];    /* m, ascending */
    int mirror[2];               /* 1 if the whole problem is even about the middle of that axis */
    const struct problem *whole; /* this is its upper half or quarter; NULL for a whole problem */
    const void *data;            /* context of the functions below if no scene made them; NULL for a scene */
    double param[PARAM_MAX];     /* parameters of the scene, in the order of its table */

    /* Initial temperature at x[0], x[1], K; on a jump, the value of the closed piece (Song eq. 43). */
    double (*initial)(const struct problem *p, const double x[2]);
    /* Dirichlet: wall temperature, K.  Neumann: heat flux into the body, k dT/dn, W m^-2.  Robin: ambient
     * temperature T_a, K (Song eq. 4). x is projected to the wall along the axis of the side; its other coordinate
     * may be a few spacings outside (ghosts at corners).  On a round wall only the direction of x matters. */
    double (*wall)(const struct problem *p, enum side s, const double x[2]);
    /* Source at t = 0, W m^-3; NULL if there is none. x may be a few spacings outside. */
    double (*source)(const struct problem *p, const double x[2]);
    /* Constant rate of change of the source, W m^-3 s^-1; NULL if the source is steady.  Zero on Dirichlet sides,
     * with zero normal derivative on the others, so that the ghosts of `source` remain valid. */
    double (*source_rate)(const struct problem *p, const double x[2]);
};

/* Largest diffusivity over all materials and axes, m^2 s^-1. */
double problem_diffusivity(const struct problem *p);

/* Uniform `initial` and `wall`: p->start, and p->held[s]. */
double problem_start(const struct problem *p, const double x[2]);
double problem_held(const struct problem *p, enum side s, const double x[2]);

/* Total source at x and time t, W m^-3; 0 if there is none. */
double problem_source(const struct problem *p, const double x[2], double t);

#endif
