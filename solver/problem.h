/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PROBLEM_H
#define HEATLADDER_SOLVER_PROBLEM_H

/* The problem:  rho_c dT/dt = div(K grad T) + G on a rod [lo[0], hi[0]], a rectangle, a box or another shape, K a
 * symmetric tensor, most often diagonal.  Data only; SI units.  Coefficients are steady.  The walls are steady except
 * for `wall_rate`, and the source except for `source_rate`: without them dT/dt = A T + g with constant A and g.  A
 * point x has `dim` coordinates. */

enum { DIM_MAX = 3, SIDES = 2 * DIM_MAX };
enum side { X_LO, X_HI, Y_LO, Y_HI, Z_LO, Z_HI };
/* PERIODIC sides come in pairs, without a wall. */
enum side_kind { DIRICHLET, NEUMANN, ROBIN, PERIODIC }; /* problem_laws[kind] has what follows from a kind */
enum { PARAM_MAX = 20, JUMP_MAX = 4, MATERIAL_MAX = 2 };

struct shape; /* shape.h */

struct material {
    double k[DIM_MAX]; /* W m^-1 K^-1, by axis */
    double rho_c;      /* J m^-3 K^-1 */
};

/* Conductivity of an isotropic material that depends on T, with u = T - k_ref: constant, k_0 (1 + k_beta u), or
 * k_0 u^k_n (0 for u <= 0).  material[0].k is then the largest value of the exact solution.  Phases: a solid below
 * k_ref and a liquid above, with k and rho_c of their own, and latent heat at k_ref, the melting point.  material[0]
 * is then the phase of the larger diffusivity. */
enum k_law { K_CONSTANT, K_LINEAR, K_POWER, K_PHASES };

struct problem {
    int dim;                         /* 1 to 3 */
    double lo[DIM_MAX], hi[DIM_MAX]; /* m; 0 along axes past dim; for other shapes the bounding box */
    const struct shape *shape;       /* NULL: a rod, a rectangle or a box */
    double radius[2];  /* m, of a round body about 0: radius of its hole (0: none) and of the outer wall */
    double t_end;      /* s */
    int materials;     /* material[0] is at x < interface, material[1] at x >= interface */
    double interface;  /* m */
    double resistance; /* m^2 K W^-1, of the interface of a rod: T falls by resistance times the flux; 0: none */
    struct material material[MATERIAL_MAX];
    double cross[DIM_MAX]; /* W m^-1 K^-1: k_xy, k_xz, k_yz of one material; 0: a diagonal tensor */
    /* Conduction along a field: sets the unit vector b at x, K = k_perp I + (k_par - k_perp) b b^T.  NULL: K is
     * constant.  material[0].k is then k_par, the largest. */
    void (*direction)(const struct problem *p, const double *x, double b[DIM_MAX]);
    double k_par, k_perp; /* W m^-1 K^-1 */
    int is_diagonal;      /* 1: K of a field without its cross terms, a fault of a code; ftcs only */
    int is_even;          /* 1: n.grad T = 0, not n.K grad T = 0, on insulated sides of a tensor; the same */
    enum k_law k_law;
    int k_frozen;                   /* 1: k of the initial temperature at all times, a fault of a code; ftcs only */
    double k_0;                     /* W m^-1 K^-1; times K^-k_n of a power law */
    double k_beta, k_ref, k_n;      /* K^-1, K, 1 */
    double phase_k[2];              /* W m^-1 K^-1: solid, liquid */
    double phase_rho_c[2];          /* J m^-3 K^-1 */
    double latent;                  /* J m^-3 */
    double root;                    /* 1: a root that the setup of a scene finds for its other functions */
    enum side_kind side[SIDES];     /* indexed by enum side; in a round body X_LO is the hole, X_HI the outer wall */
    double robin[SIDES];            /* W m^-2 K^-1, >= 0, of a ROBIN side: b in k dT/dn = b (T_a - T) */
    double start;                   /* K, uniform initial value if `initial` is problem_start */
    double held[SIDES];             /* by side, if `wall` is problem_held */
    int jumps[DIM_MAX];             /* by axis: number of planes x_a = const at which the data jump */
    double jump[DIM_MAX][JUMP_MAX]; /* m, ascending */
    int kinked[DIM_MAX];            /* by axis: 1 if the initial data have a kink at the plane x_a = kink[a] */
    double kink[DIM_MAX];           /* m */
    int breaks_on_curves;           /* 1 if the initial data jump or bend on a curve or surface */
    int mirror[DIM_MAX];            /* 1 if the whole problem is even about the middle of that axis */
    const struct problem *whole;    /* this is its upper half, quarter or octant; NULL for a whole problem */
    const void *data;               /* context of the functions below if no scene made them; NULL for a scene */
    double param[PARAM_MAX];        /* parameters of the scene, in the order of its table */

    /* Initial temperature at x, K; on a jump, the value of the closed piece (Song eq. 43). */
    double (*initial)(const struct problem *p, const double *x);
    /* Dirichlet: wall temperature, K.  Neumann: heat flux into the body, k dT/dn, W m^-2.  Robin: ambient
     * temperature T_a, K (Song eq. 4). x is projected to the wall along the axis of the side; its other coordinates
     * may be a few spacings outside (ghosts at corners).  On a round wall only the direction of x matters.  t: s. */
    double (*wall)(const struct problem *p, enum side s, const double *x, double t);
    /* Rate of change of `wall`, per s; NULL if all walls are steady. */
    double (*wall_rate)(const struct problem *p, enum side s, const double *x, double t);
    /* Source at t = 0, W m^-3; NULL if there is none. x may be a few spacings outside. */
    double (*source)(const struct problem *p, const double *x);
    /* Constant rate of change of the source, W m^-3 s^-1; NULL if the source is steady.  Zero on Dirichlet sides,
     * with zero normal derivative on the others, so that the ghosts of `source` remain valid. */
    double (*source_rate)(const struct problem *p, const double *x);
    /* Source at time t, W m^-3, if it changes in another way; `source` and `source_rate` are then NULL. */
    double (*source_at)(const struct problem *p, const double *x, double t);
};

/* How to add a wall law, a heat flux q(T) into the body that depends on the temperature T of the wall:
 *   1. its kind in enum side_kind, and its coefficients in struct problem
 *   2. its row in problem_laws (problem.c): names, number, q as `exchange`, and nonlinear = 1 if q is not linear in T
 *   3. its coefficients in verification/case/case_file.c (write_side) and references/columns.c (wall_values), and its
 *      word and number in the tables of verification/README.md
 *   4. a scene with such a wall
 * A problem with a nonlinear law is solved by solver/particles/nonlinear.c and, if k depends on T too, by the finite
 * differences.  All solvers of dT/dt = A T + g refuse it.  A law linear in T is one of the kinds above. */
struct wall_law {
    const char *name; /* for messages */
    const char *word; /* in a case */
    int number;       /* in `reference --what wall_x`; 0: no wall */
    int is_flux;      /* 1: `wall` is the flux into the body; 0: a temperature */
    /* d q, W m^-1, for surroundings at `value` and a wall at T, and its derivative by T; NULL: T or q is given. */
    double (*exchange)(const struct problem *p, enum side s, double d, double value, double T, double *slope);
    int nonlinear;
};
extern const struct wall_law problem_laws[]; /* by enum side_kind */
const struct wall_law *problem_law(const struct problem *p, int side);

/* 1 where `wall` is a temperature: of the wall, or of the air at it. */
int problem_has_wall_temperature(const struct problem *p, int side);

/* W m^-2 K^-1: b of a wall with the linear law q = b (T_a - T); 0 for other sides. */
double problem_transfer(const struct problem *p, int side);

/* NULL if the equation and the walls are linear in T; else what is not, for messages. */
const char *problem_nonlinearity(const struct problem *p);

/* Index in `cross` of the axes a and b. */
static inline int problem_pair(int a, int b) {
    return a + b - 1;
}

/* 1 if K is not diagonal. */
int problem_has_cross(const struct problem *p);

/* K of one material at x, W m^-1 K^-1. */
void problem_tensor(const struct problem *p, const double *x, double K[DIM_MAX][DIM_MAX]);

/* Largest diffusivity over all materials and axes, m^2 s^-1. */
double problem_diffusivity(const struct problem *p);

/* Uniform `initial` and `wall`: p->start, and p->held[s]. */
double problem_start(const struct problem *p, const double *x);
double problem_held(const struct problem *p, enum side s, const double *x, double t);

/* Widens [*lo, *hi] by the values of `wall` at x during the run (of changing walls, at 65 times). */
void problem_wall_range(const struct problem *p, enum side s, const double *x, double *lo, double *hi);

/* A problem with its clock set forward: wall, wall_rate and source at its time 0 are those of *of at `time`. */
struct later {
    struct problem problem;
    const struct problem *of;
    double time; /* s */
};

/* Fills *l, which may not move while it is in use. */
void problem_later(const struct problem *p, double time, struct later *l);

/* 1 if walls or source change in time. */
int problem_changes(const struct problem *p);

/* Period of the fastest wall that changes, s, as 2 pi (half its range)/(its largest rate); INFINITY if all are
 * steady. */
double problem_wall_period(const struct problem *p);

enum { PACE_TEXT = 160 };
/* For messages of runs that left the range of their data: how many steps of dt a period of the walls has, if they are
 * too few, with the step that it needs; else "".  Returns text. */
const char *problem_wall_pace(const struct problem *p, double dt, char text[PACE_TEXT]);

/* Total source at x and time t, W m^-3; 0 if there is none. */
double problem_source(const struct problem *p, const double *x, double t);

enum { PLACE_TEXT = 50 };
/* "(x, y) m", in space "(x, y, z) m", for messages; returns text. */
const char *problem_place(int dim, const double *x, char text[PLACE_TEXT]);

#endif
