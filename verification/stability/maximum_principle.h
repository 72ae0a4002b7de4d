/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_MAXIMUM_PRINCIPLE_H
#define HEATLADDER_VERIFICATION_STABILITY_MAXIMUM_PRINCIPLE_H

/* The maximum principle of a particle method on the lattice: non-negative off-centre weights and steps up to 1/|w_0|
 * make every new temperature a weighted mean of old ones. */

#include "verification/stability/model_problem.h"

struct maximum_principle {
    double lowest;     /* smallest off-centre weight over |w_0| */
    double undershoot; /* K, in runs on an impulse of 1 K, 1 to 32 steps of 0.9/|w_0| */
};

/* Negative weights and undershoots below this count as round-off of a sum of 100 terms. */
#define MAXIMUM_ROUNDING 1e-13

/* For the method of *given at h/dx = h.  Returns STATUS_OK, or the status of the weights or of a run. */
int maximum_principle_find(const struct model_problem *given, double h, struct maximum_principle *x,
                           struct failure *why);

/* h/dx number k of MAXIMUM_COUNT from 0.6 to 3 */
enum { MAXIMUM_COUNT = 49 };
double maximum_principle_h(int k);

#endif
