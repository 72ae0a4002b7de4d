/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SPECTRAL_H
#define HEATLADDER_REFERENCES_SPECTRAL_H

#include "references/scene.h"

/* Data on a rod, rectangle or box with homogeneous boundary conditions, expanded once by FFTW and evolved exactly to
 * any time.  It uses no closed form and serves as an independent second form. */

struct spectral;

/* Expands f on the domain of *p, with its boundary conditions and material[0], in n[0] x n[1] x n[2] modes (those
 * past dim are ignored; f has lo[a] as its coordinate along such an axis).  Both sides of an axis must be DIRICHLET
 * or both NEUMANN; their values are taken as zero.  The error is small if f is smooth and obeys these conditions.
 * Returns NULL if the sides of an axis differ or there are two materials. */
struct spectral *spectral_alloc(const struct problem *p, const int *n,
                                double (*f)(const struct problem *p, const double *x));
void spectral_free(struct spectral *s);

/* T at x, K, at t >= 0 s.  The error bound is the sum of the coefficients of the highest modes of each axis. */
struct exact spectral_at(const struct spectral *s, const double *x, double t);

#endif
