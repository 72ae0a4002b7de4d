/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_PLAN_STEPS_H
#define HEATLADDER_VERIFICATION_CHOOSE_PLAN_STEPS_H

#include "solver/method.h"

struct experiment;

struct plan_steps {
    double steps; /* 0: none, no coarser run is possible or the steps are out of reach */
    int runs;     /* that it rests on: the run itself, where it is small, or two coarser ones */
    double dx[2]; /* m, theirs */
};

/* How many steps verification/run/time_step.h will choose for a run whose time step *e leaves open: 1 for `first`, or
 * 2 where the run itself is not to be made. */
struct plan_steps plan_steps_predict(const struct experiment *e, int first);

/* Particles of spacing dx, m, that fill the domain; not rounded. */
double plan_steps_particles(const struct problem *p, double dx);

#endif
