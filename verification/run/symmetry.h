/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_SYMMETRY_H
#define HEATLADDER_VERIFICATION_RUN_SYMMETRY_H

/* A problem that is even about the middle of an axis is solved on its upper half alone. */

#include "solver/method.h"
#include "solver/problem.h"

/* *half: *whole cut at the middle of every axis that it is even about, where the lattice has an even number of
 * particles along it: an insulated side there, at X_LO or Y_LO.  It refers to *whole.  cut[a] is 1 for an axis that
 * was cut; returns how many were. */
int symmetry_reduce(const struct problem *whole, const struct options *o, struct problem *half, int cut[2]);

/* method->solve on the reduced problem, and the field of the whole restored: its counts of work and bytes are those
 * of the part that was computed.  The whole problem where nothing can be cut, or where --domain whole asks for it. */
int symmetry_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                   struct failure *why);

#endif
