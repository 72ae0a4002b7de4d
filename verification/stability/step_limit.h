/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_STEP_LIMIT_H
#define HEATLADDER_VERIFICATION_STABILITY_STEP_LIMIT_H

/* The largest stable step of a method, three times over: as published, by von Neumann's analysis, by trying.  Each is
 * F = dt kappa/dx^2. */

#include "verification/stability/model_problem.h"

struct step_limit {
    double published;   /* NaN where no paper has a number */
    const char *source; /* of `published` */
    double von_neumann; /* the symbol's; of clouds the eigenvalues'; 0 where some mode grows at any step */
    double measured;    /* between decay and growth, to 1 %; 0 where there is growth at any step */
    double growth;      /* largest real part of the eigenvalues, kappa/dx^2 */
    double radius;      /* largest |lambda|, kappa/dx^2 */
    double theta[2];    /* rad a particle, the wave number that sets von_neumann; NaN for clouds */
    double beta;        /* von_neumann as Pamplona's beta of eq. 15, F (dx/h)^2; NaN without an h */
    size_t particles;   /* whose eigenvalues those are */
    int grows;          /* 1: an eigenvalue has a positive real part, past rounding */
};

/* The first two and what goes with them; l->measured is NaN.  b is resolved. */
int step_limit_predict(const struct model_problem *b, struct step_limit *l, struct failure *why);

/* By bisection on real runs of b.  STATUS_OK, or what the runs were refused with other than growth. */
int step_limit_measure(const struct model_problem *b, double *measured, struct failure *why);

/* Whether noise grows in `steps` steps of F: 1, 0, or -1 with *why filled. */
int step_limit_grows(const struct model_problem *b, double F, long long steps, struct failure *why);

enum { LIMIT_ROD = 48, LIMIT_SQUARE = 24, LIMIT_SQUARE_JITTER = 14, LIMIT_STEPS = 1000 };

/* Resolves *b on so many particles that limits are looked for on; and the model problem of a command `limit`. */
int step_limit_model(struct model_problem *b, struct failure *why);
int step_limit_setup(const struct method *m, const struct options *o, int dim, double ratio, double contact,
                     int stages, struct model_problem *b, struct failure *why);

/* The steps that SPH codes take for conduction, dt = C h^2/kappa, whatever their operator. */

struct customary_step {
    const char *source; /* who, and what h is there */
    double F;           /* dt kappa/dx^2, for the kernel's support of the options */
};

enum { CUSTOMARY_STEPS = 3 };

/* Those that are said of the method of a resolved *b, into out; returns how many: 0 for grids and for steppers other
 * than Euler's. */
int customary_steps(const struct model_problem *b, struct customary_step out[CUSTOMARY_STEPS]);

#endif
