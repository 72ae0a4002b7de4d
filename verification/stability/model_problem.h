/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_MODEL_PROBLEM_H
#define HEATLADDER_VERIFICATION_STABILITY_MODEL_PROBLEM_H

/* A method by itself: n (on a rectangle n x n) particles of spacing dx = 1 and diffusivity 1 along x, so that times
 * are in dx^2/kappa and steps are mesh Fourier numbers. */

#include "solver/space/operator.h"

#include "verification/stability/amplification.h"

struct model_problem {
    const struct method *method;
    int dim;
    int n;                  /* along each axis */
    int insulated;          /* 1: no flux through the walls; 0: they are at 0 K */
    double ratio;           /* kappa_y/kappa_x, to 1; 0: 1 */
    double contact;         /* k and rho c of the upper half of x over those of the lower, so that kappa is 1 in both;
                               0: one material */
    struct options options; /* dx = 1; stepper and stages are those of `step` */
    struct amplification step;
};

enum model_problem_data {
    MODEL_NOISE,   /* in [-1, 1], by the cell of a particle */
    MODEL_IMPULSE, /* 1 K in the middle cell */
    MODEL_HILL     /* half a wave along each axis, 1 K high, and `disturb` times the noise */
};

/* The options resolved (h/dx), and the least n that the method's reach allows where b->n is 0: at least `least`. */
int model_problem_resolve(struct model_problem *b, int least, struct failure *why);

double model_problem_kappa_y(const struct model_problem *b); /* over kappa_x */

/* The problem itself: sides of n m, kappa 1 m^2/s along x, t_end 1 s; `disturb`, K, is for MODEL_HILL. */
struct problem model_problem_setup(const struct model_problem *b, enum model_problem_data data, double disturb);

/* `steps` steps of F = dt kappa/dx^2 by the method's own solve (RKL2: by stepper_march, since a run chooses its own
 * stages).  *largest is max |T| at the end.  STATUS_UNSTABLE where T leaves its bounds. */
int model_problem_run(const struct model_problem *b, const struct problem *p, double F, long long steps,
                      double *largest, struct failure *why);

/* Whether each particle has a row of its own: on a cloud, and where two materials meet. */
int model_problem_has_rows(const struct model_problem *b);

/* The operator of a particle method: a lattice's, or those rows. */
int model_problem_operator(const struct model_problem *b, const struct problem *p, struct heat_operator *a,
                           struct failure *why);

/* Of a particle method on b's jittered (or regular) cloud; the caller frees it. */
int model_problem_cloud(const struct model_problem *b, const struct problem *p, struct cloud *c, struct failure *why);

/* Calls `see` with the neighbourhood of each of the first `count` particles of the cloud; stops at its first status.
 */
typedef int model_problem_see(const struct model_problem *b, const struct neighbourhood *nb, void *with,
                              struct failure *why);
int model_problem_around(const struct model_problem *b, const struct cloud *c, size_t count, model_problem_see *see,
                         void *with, struct failure *why);

#endif
