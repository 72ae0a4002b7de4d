/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_PARTICLES_CONDUCTION_H
#define HEATLADDER_SOLVER_PARTICLES_CONDUCTION_H

#include "solver/particles/particles.h"

/* Particles with a conductivity that depends on T: laws, ghosts and rates. */

double conduction_k(const struct problem *p, double T);     /* W m^-1 K^-1, >= 0 */
double conduction_theta(const struct problem *p, double T); /* W m^-1, the integral of k from k_ref */
double conduction_T(const struct problem *p, double theta); /* K, the inverse; odd about k_ref for a power law */

struct conduction;

/* *c (owned by the caller) for the method of *s and resolved options.  Returns a status of the assembly. */
int conduction_create(struct conduction **c, const struct problem *p, const struct options *o, const struct scheme *s,
                      const struct lattice *l, struct failure *why);
void conduction_free(struct conduction *c);

/* dT/dt (K s^-1) of the particles at time t in out; T in the particles' order. */
void conduction_rate(struct conduction *c, const double *T, double t, double *out);

const struct cloud *conduction_cloud(const struct conduction *c);

/* Bound of the spectrum for the largest k in the state of the last rate, s^-1. */
double conduction_bound(const struct conduction *c);
/* K: range of the temperatures of walls and air so far, and the largest rate of heating by source and flux, K s^-1.
 */
void conduction_range(const struct conduction *c, double *lo, double *hi, double *heating);

size_t conduction_pairs(const struct conduction *c); /* sum over particles of the number of neighbours */
size_t conduction_bytes(const struct conduction *c);

/* 1 if these particles support a k that depends on T. */
int conduction_supports(const struct scheme *s);

/* particles_solve for such a problem. */
int nonlinear_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                    struct failure *why);

#endif
