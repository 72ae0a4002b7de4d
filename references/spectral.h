/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SPECTRAL_H
#define HEATLADDER_REFERENCES_SPECTRAL_H

#include "references/scene.h"

/* Data on a rod or rectangle with homogeneous sides, expanded once by FFTW and evolved exactly to any time.  Knows
 * nothing of closed forms, which makes it the second opinion on them. */

struct spectral;

/* Expands f on the domain of *p, with the sides and material[0] of *p, in n[0] x n[1] modes (n[1] is ignored for a
 * rod).  Sides of an axis must be of one kind (both DIRICHLET or both NEUMANN), and are taken as zero.  f must be
 * smooth and obey the sides for the error to be small.  NULL where the sides differ or there are two materials. */
struct spectral *spectral_alloc(const struct problem *p, const int n[2],
                                double (*f)(const struct problem *p, const double x[2]));
void spectral_free(struct spectral *s);

/* T at x, K, after t >= 0 s.  The error bound is what the last modes of either axis still hold, added up. */
struct exact spectral_at(const struct spectral *s, const double x[2], double t);

#endif
