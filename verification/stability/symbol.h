/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_SYMBOL_H
#define HEATLADDER_VERIFICATION_STABILITY_SYMBOL_H

/* The symbol of a method's operator on the unbounded lattice, lambda(theta) = sum w_j exp(i theta.j): its eigenvalue
 * for the wave of phase theta (radians per particle), in units of kappa/dx^2. */

#include "verification/stability/model_problem.h"

struct symbol {
    int dim;
    int reach[DIM_MAX];
    double *w; /* the whole stencil: (2 reach + 1) weights along each axis, x fastest */
};

/* From operator_stencil for a particle method without a field, whose stencil is even along each axis; else from one
 * Euler step of the method on an impulse. b is resolved. */
int symbol_create(struct symbol *s, const struct model_problem *b, struct failure *why);
void symbol_free(struct symbol *s);

double symbol_weight(const struct symbol *s, int i, int j, int k);     /* 0 outside */
double complex symbol_at(const struct symbol *s, const double *theta); /* theta[dim] */

struct symbol_extreme {
    double limit; /* F up to which |G| <= 1 at every wave number; 0 for none, infinite if all eigenvalues vanish */
    double theta[DIM_MAX]; /* critical phase */
    double radius;         /* max |lambda|, kappa/dx^2 */
    double growth;         /* max Re lambda, kappa/dx^2: zero within round-off if every mode decays */
};

/* Over all wave numbers: FFTW on a zero-padded grid, then a search around the critical one. */
struct symbol_extreme symbol_extreme(const struct symbol *s, const struct amplification *step);

/* Smallest off-centre weight over |w_0|: non-negative if the operator has a maximum principle. */
double symbol_lowest(const struct symbol *s);

#endif
