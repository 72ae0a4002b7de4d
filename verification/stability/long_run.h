/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_LONG_RUN_H
#define HEATLADDER_VERIFICATION_STABILITY_LONG_RUN_H

/* A very long run: an insulated hot rod of 32 particles with noise, a particle method, a step just below its
 * limit. */

#include "verification/stability/model_problem.h"

struct long_run {
    long long steps;
    double largest; /* K, final max T; initially 1 to 2 */
    double rise;    /* K, largest increase of max T between two checks (every 1e4 steps) */
    double drift;   /* relative change of the heat */
    double mean;    /* K */
};

/* Runs `steps` steps of F = dt kappa/dx^2.  Returns STATUS_OK, or the status of the operator or the run. */
int long_run_measure(const struct model_problem *given, double F, long long steps, struct long_run *e,
                     struct failure *why);

#endif
