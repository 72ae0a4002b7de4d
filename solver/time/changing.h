/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_CHANGING_H
#define HEATLADDER_SOLVER_TIME_CHANGING_H

#include "solver/time/stepper.h"

/* Walls and sources that change in time, in the updates of a step.  NULL stands for steady data: changing_begin and
 * changing_free then do nothing. */
struct changing;

/* For the march *m; a->g becomes an array of the result.  Adds its bytes to *bytes. */
struct changing *changing_create(struct heat_operator *a, const struct march *m, size_t *bytes);
void changing_free(struct changing *c);

/* Starts a step of length dt at the time t, s. */
void changing_begin(struct changing *c, double t, double dt);

/* Sets a->g for the update *u, the next one of the step. */
void changing_update(struct changing *c, const struct update *u);

#endif
