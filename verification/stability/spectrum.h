/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_SPECTRUM_H
#define HEATLADDER_VERIFICATION_STABILITY_SPECTRUM_H

/* All eigenvalues of an operator with rows, by GSL's dense nonsymmetric solver; practical up to n = 400. */

#include "solver/space/operator.h"
#include "verification/stability/amplification.h"

struct spectrum {
    size_t n;
    double complex *lambda; /* s^-1 */
    double limit;           /* s: the largest dt at which no mode grows; 0 if one has a positive real part */
    double radius;          /* s^-1: max |lambda| */
    double growth;          /* s^-1: max Re lambda */
    double twist;           /* s^-1: max |Im lambda| */
};

enum { SPECTRUM_MAX = 625 };

/* STATUS_INPUT if n is larger than SPECTRUM_MAX, STATUS_NUMERICAL if GSL does not converge. */
int spectrum_create(struct spectrum *s, const struct heat_operator *a, const struct amplification *step,
                    struct failure *why);
void spectrum_free(struct spectrum *s);

/* Smallest real part that counts as positive: above the rounding error of n eigenvalues. */
double spectrum_rounding(const struct spectrum *s);

#endif
