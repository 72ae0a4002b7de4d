/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_OPTIONS_H
#define HEATLADDER_SOLVER_OPTIONS_H

/* The numerical options of a method: stepper, kernel, layout, sampling, walls, steps. */

#include "solver/status.h"

enum kernel_name {
#define KERNEL(NAME, name) KERNEL_##NAME,
#include "solver/kernels.def"
#undef KERNEL
};
enum stepper_name {
    STEPPER_AUTO, /* the default that fits the problem */
#define STEPPER(NAME, name) STEPPER_##NAME,
#include "solver/steppers.def"
#undef STEPPER
};
enum layout_name { LAYOUT_LATTICE, LAYOUT_NODE, LAYOUT_JITTER, LAYOUT_RELAXED, LAYOUT_HEXAGONAL };
enum sampling { SAMPLING_POINT, SAMPLING_CELL, SAMPLING_SPLINE };
/* Beyond WALLS_FIXED, and for WALLS_FIXED on a cut lattice, dummy particles follow particles/walls.c.
 * WALLS_ONE_SIDED has no dummies. */
enum walls { WALLS_MIRROR, WALLS_FIXED, WALLS_DISTANCE, WALLS_AVERAGE, WALLS_IMAGE, WALLS_FIT, WALLS_ONE_SIDED };
/* MEAN_AUTO: harmonic between two materials, series with a contact resistance, kirchhoff where k depends on T. */
enum mean { MEAN_AUTO, MEAN_HARMONIC, MEAN_ARITHMETIC, MEAN_SERIES, MEAN_KIRCHHOFF };
/* Fluxes of a tensor that is not diagonal: through faces, or from gradients at the corners of cells. */
enum cross { CROSS_FACE, CROSS_CORNER };
enum domain { DOMAIN_SYMMETRY, DOMAIN_WHOLE };
enum volume { VOLUME_MOMENT, VOLUME_RAW, VOLUME_TUNED };

/* Names on the command line, indexed by the enums, ended by NULL. */
extern const char *const kernel_words[], *const stepper_words[];
extern const char *const layout_words[], *const sampling_words[], *const walls_words[], *const domain_words[];
extern const char *const mean_words[], *const cross_words[], *const volume_words[];

struct assembled;
struct field;

struct options {
    double dx;      /* m, particle spacing along x (and along y, except for STEPPER_MATCHED with k_x != k_y) */
    double aspect;  /* dy over dx of the cells in a case for an external program; 0: 1 */
    double dt;      /* s; 0: not given.  The step used is t_end / ceil(t_end / dt), a whole number of steps. */
    double fourier; /* mesh Fourier number dt max(kappa) / dx^2; 0: not given */
    double h;       /* smoothing length over dx; 0: the default, 1.1 max(order, 2) / 2 */
    int h_iso;      /* 1: --h iso */
    int order;      /* Taylor order of so_ssph, 2 to 4; 0: not given */
    double xi;      /* --volume tuned: Pamplona's xi, m; 0: their xi = 9 h^(1/3) */
    enum kernel_name kernel;
    enum stepper_name stepper;
    enum layout_name layout;
    double jitter; /* particles are displaced uniformly within +-jitter dx of the lattice (relaxed: initially) */
    int sweeps;    /* LAYOUT_RELAXED: maximum number of sweeps; 0: the default, 2000 */
    unsigned long seed;
    double shift;              /* shift of the lattice of a rod or rectangle along each axis, in dx, 0 to 1 */
    int has_origin, has_angle; /* 0: drawn from the seed */
    double origin[3], angle;   /* lattice of a round body: origin in dx, angle about z in degrees */
    enum sampling sampling;
    enum walls walls;
    enum mean mean;
    enum cross cross;
    enum volume volume;
    enum domain domain;          /* for scenes with mirror planes: compute only the necessary part, or all */
    const struct field *placed;  /* borrowed: a field of the same layout and seed, whose relaxed particles are reused;
                                    NULL for none */
    struct assembled *assembled; /* borrowed: rows and start (particles.h) that runs of the same problem with other
                                    time steps share; the first one fills it.  NULL: a run has its own. */
    int threads;                 /* maximum number of threads of a run; 0 or 1: one */
    int lanes;                   /* doubles per vector in the hot loops, 2, 4 or 8; 0: options_lanes_most() */
};

/* Doubles in the widest vector of this machine: 2, 4 or 8.  Results are the same for all widths, bit for bit. */
int options_lanes_most(void);

/* Refuses numbers out of range and options that exclude or need each other; every run passes it.  `dx` may be 0, not
 * given.  Returns STATUS_OK or STATUS_INPUT. */
int options_check(const struct options *o, struct failure *why);

/* m, cell size of a case along axis 0 or 1. */
double options_spacing(const struct options *o, int axis);

/* 1 for layouts other than a lattice: each particle has its own row of weights. */
int options_is_cloud(const struct options *o);

/* 1 for the matched run, whose step, spacing along y and start depend on the scene */
int options_is_matched(const struct options *o);

#endif
