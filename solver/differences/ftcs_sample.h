/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_SAMPLE_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_SAMPLE_H

#include "solver/method.h"

struct problem;

/* The initial temperature, K, that the grid point at x stands for: the value there, or its average over the point's
 * cell or with the cubic B-spline on spacings d (m, along x and y). */
double ftcs_sample(const struct problem *p, const double x[2], const double d[2], enum sampling how);

#endif
