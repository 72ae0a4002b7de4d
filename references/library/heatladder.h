/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_H
#define HEATLADDER_H

/* libheatladder: exact solutions of transient heat conduction with bounds of their error, the data of their scenes,
 * and the solvers beside them.  C, C++, and Fortran by heatladder.f90.  SI units.
 *
 * No call ends the process, reads the environment or prints.  Calls from several threads run one after another; each
 * runs on the thread of its caller.  NULL where a pointer is needed is HL_INPUT; `why` may be NULL everywhere.
 * Messages use a decimal point in any locale. */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifdef __GNUC__
#define HL_API __attribute__((visibility("default")))
#else
#define HL_API
#endif

enum {
    HL_OK = 0,
    HL_INPUT = 2,          /* unknown name, or a value out of range */
    HL_NUMERICAL = 3,      /* a singular matrix, or a start out of the range of its data */
    HL_NOT_APPLICABLE = 5, /* the method has no answer to this problem with these options */
    HL_UNSTABLE = 6,       /* temperatures grew without bound; take shorter steps */
    HL_MEMORY = 7          /* out of memory; the memory of the call is released */
};

struct hl_error {
    int status;     /* one of the above */
    char text[480]; /* one line: option, value, limit, remedy */
};

HL_API const char *hl_version(void);
HL_API const char *hl_scene(int i);  /* the name of scene i = 0, 1, ...; NULL past the last */
HL_API const char *hl_method(int i); /* the name of method i */

/* ---- Problems ---- */

struct hl_parameter {
    const char *name;
    double value;     /* the default */
    const char *unit; /* SI; "" for none */
    const char *about;
    const char *const *choice; /* NULL, or the words for the values 0, 1, ..., ended by NULL */
};

struct hl_setting {
    const char *name; /* name of a parameter */
    double value;
};

struct hl_box {
    int dim;             /* 1: a rod; 2; 3 */
    double lo[3], hi[3]; /* m; of a round body the box around it; 0 past dim */
    double hole, radius; /* m, of a round body about 0; 0 of a rod, a rectangle or a box */
    double t_end;        /* s */
};

struct hl_problem; /* a scene at given parameters */

/* Parameter i = 0, 1, ... of the scene into *parameter, and 1; 0 past the last or for an unknown scene. */
HL_API int hl_parameter(const char *scene, int i, struct hl_parameter *parameter);

/* The scene with the settings, ended by a NULL name; NULL: all defaults.  NULL with *why filled where a name is
 * unknown or a value is out of range.  The caller releases it with hl_problem_free. */
HL_API struct hl_problem *hl_problem_create(const char *scene, const struct hl_setting *settings,
                                            struct hl_error *why);
HL_API void hl_problem_free(struct hl_problem *problem); /* NULL: nothing */
HL_API void hl_problem_box(const struct hl_problem *problem, struct hl_box *box);

/* Exact temperatures T[i], K, and bounds of their error at the n points (x[i], y[i], z[i]) and the time t >= 0 s.  y
 * is NULL on a rod, z on a rod and in the plane; bound may be NULL.  At a corner whose sides disagree T is the mean
 * of both and the bound half of their difference.  A status. */
HL_API int hl_exact_at(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y,
                       const double *z, double *T, double *bound, struct hl_error *why);

/* hl_exact_at for rods and planes. */
HL_API int hl_exact(const struct hl_problem *problem, double t, size_t n, const double *x, const double *y, double *T,
                    double *bound, struct hl_error *why);

/* ---- Data of a scene ---- */

struct hl_points {
    size_t n;
    const double *x, *y, *z;    /* m, n each; y is NULL on a rod, z on a rod and in the plane */
    const double *dx, *dy, *dz; /* m, n each: extents of the cell around each point, for "initial_mean"; dy and dz
                                   NULL: dx; all NULL: no cells */
};

/* Quantities of the scene at the points and the time t >= 0 s, as `heatladder reference --what` prints them.  `what`
 * is a comma-separated list of
 *
 *     temperature error_bound flux_x flux_y flux_z initial initial_mean source k_x k_y k_z k_xy k_xz k_yz b_x b_y
 * rho_c wall wall_x wall_y wall_z nearest
 *
 * (`heatladder reference --help` defines them).  Value j of point i is value[j * n + i]; a wall has three values, a
 * nearest wall eight, ten in space, all else one.  A status. */
HL_API int hl_reference(const struct hl_problem *problem, const char *what, double t, const struct hl_points *points,
                        double *value, struct hl_error *why);

/* How many values `what` has at a point, with their names, separated by commas, in names[size] (NULL: not wanted); -1
 * with *why filled where it has an unknown word. */
HL_API int hl_reference_values(const struct hl_problem *problem, const char *what, char *names, size_t size,
                               struct hl_error *why);

/* ---- Solvers ---- */

struct hl_options { /* 0 and NULL: the default of the method */
    double dx;      /* m: particle or grid spacing; required */
    double dt;      /* s; 0: the stepper's own step */
    double fourier; /* dt max(kappa)/dx^2, in place of dt */
    double h;       /* smoothing length over dx */
    double jitter;  /* dx: largest shift of a particle of the layout "jitter", along each axis */
    int order;      /* Taylor order of so_ssph, 2 to 4 */
    unsigned long seed;
    const char *kernel;   /* "cubic", ... */
    const char *stepper;  /* "exact", ...; default: "exact" where the method has it, else the method's own */
    const char *layout;   /* "lattice", "node", "jitter", "relaxed", "hexagonal" */
    const char *sampling; /* "point", "cell", "spline" */
    const char *walls;    /* "mirror", "fixed", ... */
    const char *mean;     /* "auto", "harmonic", "arithmetic", "series", "kirchhoff" */
};

struct hl_field {
    int dim;
    size_t n;
    double *x, *y, *T; /* m, m, K: n each; y is NULL on a rod */
    double *z;         /* m, n; NULL on a rod and in the plane */
    double t;          /* s */
    double dt;         /* s; 0 for "exact" */
    long long steps;   /* 0 for "exact" */
};

/* Solves the problem to its end time.  A status; on HL_OK the caller releases *field with hl_field_free. */
HL_API int hl_solve(const struct hl_problem *problem, const char *method, const struct hl_options *options,
                    struct hl_field *field, struct hl_error *why);
HL_API void hl_field_free(struct hl_field *field); /* NULL: nothing */

#ifdef __cplusplus
}
#endif

#endif
