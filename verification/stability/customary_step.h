/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_CUSTOMARY_STEP_H
#define HEATLADDER_VERIFICATION_STABILITY_CUSTOMARY_STEP_H

#include "verification/stability/model_problem.h"

/* The steps that SPH codes take for conduction, dt = C h^2/kappa, whatever their operator. */

struct customary_step {
    const char *source; /* who, and what h is there */
    double F;           /* dt kappa/dx^2, for the kernel's support of the options */
};

enum { CUSTOMARY_STEPS = 3 };

/* Those that are said of the method of a resolved *b, into out; returns how many: 0 for grids, for steppers other
 * than Euler's, for graded clouds. */
int customary_steps(const struct model_problem *b, struct customary_step out[CUSTOMARY_STEPS]);

#endif
