#ifndef HEATLADDER_SOLVER_METHOD_H
#define HEATLADDER_SOLVER_METHOD_H

#include <stddef.h>

/* What a method offers, what it is asked for (struct options), and what it gives back (struct field). */

struct problem;
struct scheme; /* operator.h: how a particle method weighs its neighbours */

enum { STATUS_OK = 0, STATUS_GATE = 1, STATUS_INPUT = 2, STATUS_NUMERICAL = 3 }; /* also the exit statuses */

struct failure {
    int status;     /* STATUS_OK, STATUS_INPUT or STATUS_NUMERICAL */
    char text[480]; /* one line, without a newline: what, its value, what would be valid; where and when */
};

/* Fills *f (printf-like) and returns status, so that a function can end with `return fail(f, STATUS_INPUT, ...)`. */
int fail(struct failure *f, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* calloc that ends the program where memory is out; count = 0 gives a block that can be freed. */
void *xcalloc(size_t count, size_t size);

enum kernel_name { KERNEL_CUBIC, KERNEL_QUARTIC, KERNEL_WENDLAND };
enum stepper { STEPPER_AUTO, STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2, STEPPER_EXACT, STEPPER_MATCHED };
enum layout_name { LAYOUT_LATTICE, LAYOUT_NODE, LAYOUT_JITTER };
enum sampling { SAMPLING_POINT, SAMPLING_CELL, SAMPLING_SPLINE };
enum walls { WALLS_MIRROR, WALLS_FIXED };
enum mean { MEAN_HARMONIC, MEAN_ARITHMETIC, MEAN_SERIES };
enum domain { DOMAIN_FOLDED, DOMAIN_WHOLE };
enum volume { VOLUME_MOMENT, VOLUME_RAW, VOLUME_TUNED };

/* The words of the command line, in the order of the enums, ended by NULL. */
extern const char *const kernel_words[],
    *const stepper_words[], *const layout_words[], *const sampling_words[], *const walls_words[],
                                                                                *const mean_words[],
                                                                                    *const volume_words[],
                                                                                        *const domain_words[];

struct options {
    double dx;      /* m, particle spacing along x (along y too, but for STEPPER_MATCHED with k_x != k_y) */
    double dt;      /* s; 0: not given.  The step used is t_end / ceil(t_end / dt), so that steps are whole. */
    double fourier; /* mesh Fourier number dt max(kappa) / dx^2; 0: not given */
    double h;       /* smoothing length over dx; 0: the default, 1.1 max(order, 2) / 2 */
    int h_iso;      /* 1: --h iso */
    int order;      /* Taylor order of so_ssph, 2 to 4; 0: not given */
    double xi;      /* --volume tuned: Pamplona's xi, m; 0: their xi = 9 h^(1/3) */
    enum kernel_name kernel;
    enum stepper stepper;
    enum layout_name layout;
    double jitter; /* particles lie uniformly within +-jitter dx of the lattice's */
    unsigned long seed;
    enum sampling sampling;
    enum walls walls;
    enum mean mean;
    enum volume volume;
    enum domain domain; /* of a scene with mirror planes: the part that has to be computed, or all */
    int threads;        /* threads that one run may use; 0 or 1: one */
};

struct field { /* owned arrays: field_free */
    int dim;
    size_t n;
    int shape[2];      /* lattice points along x and y (1 for a rod), x fastest; {0, 0} where there is no lattice */
    double spacing[2]; /* m */
    double *x, *y;     /* m, n each; y is NULL for a rod */
    double *T;         /* K, n */
    double *weight;    /* m^d, n: the volume that each point stands for in a norm; NULL where all are alike */
    double time;       /* s, the time that T belongs to (t_end) */
    double h;          /* smoothing length over dx, as settled; 0 for a method without one */
    double dt;         /* s, 0 for the exact stepper */
    long long steps;   /* time steps; 0 for the exact stepper */
    int stages;        /* operator applications a step */
    double heat[2];    /* J m^(d-3): sum of rho_c T volume at the start and at the end */
    double range[2];   /* K, lowest and highest of the sampled initial data */
    double bound;      /* s^-1: upper bound of the operator's spectrum; 0 where none is known */
    long long updates; /* particle updates: particles x operator applications */
    long long interactions; /* pairs evaluated: updates x neighbours */
    size_t bytes;           /* held while time runs, places and temperatures among them */
    double seconds;         /* wall time of the whole call */
    double step_seconds;    /* wall time of the time loop alone */
};

void field_alloc(struct field *f, int dim, size_t n); /* zeroes *f, allocates x, T, and y for dim 2 */
void field_free(struct field *f);

struct method {
    const char *name;
    const char *about;   /* one line, with its equation */
    const char *accepts; /* the options that have a meaning here, separated by blanks: "stepper kernel h ..." */
    const struct scheme *scheme; /* NULL for a method that is not a particle method */
    /* 0 and a filled *f (its arrays owned by the caller), or a status with *why filled and *f untouched */
    int (*solve)(const struct problem *p, const struct options *o, struct field *f, struct failure *why);
};

extern const struct method *const methods[]; /* ended by NULL */

#endif
