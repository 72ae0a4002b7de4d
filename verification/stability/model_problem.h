/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_MODEL_PROBLEM_H
#define HEATLADDER_VERIFICATION_STABILITY_MODEL_PROBLEM_H

/* A method in isolation: n^dim particles of spacing dx = 1 with diffusivity 1 along x and z.  Times are
 * in dx^2/kappa, and steps are mesh Fourier numbers. */

#include "solver/space/operator.h"

#include "verification/stability/amplification.h"

struct model_problem {
    const struct method *method;
    int dim;
    int n;         /* along each axis */
    int insulated; /* 1: insulated walls; 0: walls at 0 K */
    double ratio;  /* kappa_y/kappa_x; 0: 1 */
    double
        field; /* degrees from x: of a field b, in periodic sides; kappa is 1 along b and `ratio` across; 0: none */
    double contact; /* ratio of k and rho c of the upper half of x to those of the lower, so that kappa is 1 in both;
                       0: one material */
    struct options options; /* dx = 1; `step` has stepper and stages */
    struct amplification step;
};

enum model_problem_data {
    MODEL_NOISE,   /* in [-1, 1], by the cell of a particle */
    MODEL_IMPULSE, /* 1 K in the middle cell */
    MODEL_HILL     /* half a wave along each axis, 1 K high, plus `disturb` times the noise */
};

/* Resolves the options (h/dx).  If b->n is 0 it becomes the smallest n, at least `least`, that the method's reach
 * allows. */
int model_problem_resolve(struct model_problem *b, int least, struct failure *why);

double model_problem_kappa_y(const struct model_problem *b); /* relative to kappa_x */

/* The problem: sides of n m, kappa 1 m^2/s along x, t_end 1 s; `disturb`, K, is for MODEL_HILL. */
struct problem model_problem_setup(const struct model_problem *b, enum model_problem_data data, double disturb);

/* `steps` steps of F = dt kappa/dx^2 by the method's own solve (with given stages: by stepper_march, since a run
 * chooses its own). *largest is the final max |T|.  STATUS_UNSTABLE if T leaves its bounds. */
int model_problem_run(const struct model_problem *b, const struct problem *p, double F, long long steps,
                      double *largest, struct failure *why);

/* 1 if each particle has its own row: on a cloud, and with two materials. */
int model_problem_has_rows(const struct model_problem *b);

/* The operator of a particle method: that of a lattice, or those rows. */
int model_problem_operator(const struct model_problem *b, const struct problem *p, struct heat_operator *a,
                           struct failure *why);

/* The jittered (or regular) cloud of b; the caller frees it. */
int model_problem_cloud(const struct model_problem *b, const struct problem *p, struct cloud *c, struct failure *why);

/* Calls `see` with the neighbourhood of each of the first `count` particles of the cloud; stops at the first
 * failure. */
typedef int model_problem_see(const struct model_problem *b, const struct neighbourhood *nb, void *with,
                              struct failure *why);
int model_problem_around(const struct model_problem *b, const struct cloud *c, size_t count, model_problem_see *see,
                         void *with, struct failure *why);

#endif
