/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FAULT_FITS_H
#define HEATLADDER_VERIFICATION_FAULT_FAULT_FITS_H

/* Fits of every fault that a problem can have to the errors of two rungs. */

#include "verification/fault/fault.h"
#include "verification/fault/fit.h"

struct diagnosis_rung;

/* Relative change of a size from rung to rung below which it counts as constant: the finest spacings of the battery
 * have the ratio 4/3, by which a size in a unit with another power of dx changes at least. */
static const double FAULT_STEADY = 0.25;
static const char FAULT_DIFFUSIVE[] = "dx^2/kappa"; /* a unit of time */
enum { FAULT_FITS = 120 };

struct fault_fit {
    struct fault fault;
    struct fit fine, coarse;
    double unit[2];   /* the unit of the size at the fine and the coarse rung: a step, a cell, or 1 */
    double drift;     /* |log| of the change of the size in its unit; INFINITY if the size is not constant */
    const char *name; /* name of the unit */
    double steps[2];  /* for a clock with known steps: the size at both rungs */
};

/* Fits all faults to two rungs, the fine one first; returns their number, at most FAULT_FITS. */
int fault_fits_all(const struct problem *p, const struct diagnosis_rung *rung, struct fault_fit *c);

/* Sets the unit in which the size of *c is constant from rung to rung, and the remaining change.  If a program does
 * not report its time steps, they may have a fixed length or be a fraction of dx^2/kappa. */
void fault_scaling(const struct problem *p, struct fault_fit *c, const struct diagnosis_rung *fine,
                   const struct diagnosis_rung *coarse);

#endif
