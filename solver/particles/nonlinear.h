/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_NONLINEAR_H
#define HEATLADDER_SOLVER_PARTICLES_NONLINEAR_H

#include "solver/method.h"
#include "solver/problem.h"

/* Particles with a conductivity or a wall flux that is not linear in T. */

double nonlinear_k(const struct problem *p, double T);     /* W m^-1 K^-1, >= 0 */
double nonlinear_theta(const struct problem *p, double T); /* W m^-1, the integral of k from k_ref */
double nonlinear_T(const struct problem *p, double theta); /* K, the inverse; odd about k_ref for a power law */

/* particles_solve for such a problem (problem_nonlinearity). */
int nonlinear_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                    struct failure *why);

#endif
