/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_STEP_LIMIT_H
#define HEATLADDER_VERIFICATION_STABILITY_STEP_LIMIT_H

/* The largest stable step of a method, by three routes: as published, by von Neumann analysis, and measured.  All
 * are F = dt kappa/dx^2. */

#include "verification/stability/model_problem.h"

struct json;

struct step_limit {
    double published;      /* NaN if no paper gives a value */
    const char *source;    /* source of `published` */
    double von_neumann;    /* from the symbol; for clouds from the eigenvalues; 0 if some mode grows at any step */
    double measured;       /* between decay and growth, to 1 %; 0 if there is growth at any step */
    double growth;         /* largest real part of the eigenvalues, kappa/dx^2 */
    double radius;         /* largest |lambda|, kappa/dx^2 */
    double theta[DIM_MAX]; /* radians per particle, the critical wave number; NaN for clouds */
    double beta;           /* von_neumann in terms of Pamplona's beta of eq. 15, F (dx/h)^2; NaN without h */
    size_t particles;      /* number of particles in the eigenvalue problem */
    int grows;             /* 1: an eigenvalue has a significant positive real part */
};

/* Sets everything except l->measured, which is NaN. b is resolved. */
int step_limit_predict(const struct model_problem *b, struct step_limit *l, struct failure *why);

/* Bisection on actual runs of b.  Returns STATUS_OK, or the status of a run that failed for another reason than
 * growth. */
int step_limit_measure(const struct model_problem *b, double *measured, struct failure *why);

/* 1 if noise grows in `steps` steps of F, else 0; -1 on failure, with *why. */
int step_limit_grows(const struct model_problem *b, double F, long long steps, struct failure *why);

/* Particles along an axis; under jitter few enough for the eigenvalues of a full matrix. */
enum { LIMIT_ROD = 48, LIMIT_SQUARE = 24, LIMIT_SQUARE_JITTER = 14, LIMIT_CUBE = 12, LIMIT_CUBE_JITTER = 7 };
enum { LIMIT_STEPS = 1000 };

/* Resolves *b with the number of particles of limit searches; and the model problem of the command `limit`. */
int step_limit_model(struct model_problem *b, struct failure *why);
int step_limit_setup(const struct method *m, const struct options *o, int dim, double ratio, double field,
                     double contact, int stages, struct model_problem *b, struct failure *why);

/* Customary steps of SPH codes for conduction, dt = C h^2/kappa, independent of their operator. */

struct customary_step {
    const char *source; /* publication, and its definition of h */
    double F;           /* dt kappa/dx^2, for the kernel's support of the options */
};

enum { CUSTOMARY_STEPS = 3 };

/* The customary steps for the method of a resolved *b.  Returns their number: 0 for grids, and for steppers other
 * than Euler's. */
int step_limit_customary(const struct model_problem *b, struct customary_step out[CUSTOMARY_STEPS]);

/* Writes the members of the `limit --json` contract into an open object. */
void step_limit_json(const struct model_problem *b, const struct step_limit *l, struct json *j);

#endif
