/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_DIFFERENCES_FTCS_LAYERS_H
#define HEATLADDER_SOLVER_DIFFERENCES_FTCS_LAYERS_H

#include "solver/options.h"

/* Two materials in contact at x = interface, in cells of width d (m) about points x (m). */

struct problem;

/* J m^-3 K^-1: average over the cell about x. */
double ftcs_layers_rho_c(const struct problem *p, double d, double x);

/* W m^-1 K^-1: effective conductivity between x and x + d, d of either sign. */
double ftcs_layers_conductivity(const struct problem *p, enum mean mean, double x, double d);

/* W m^-1 K^-1: conductivity of the cell about x along y or z, the average of k over its width. */
double ftcs_layers_across(const struct problem *p, int axis, double d, double x);

/* Parts of the cell about x on either side of the interface: their widths in units of d and their centres, m.
 * Returns the number of parts, 1 or 2. */
int ftcs_layers_parts(const struct problem *p, double d, double x, double share[2], double middle[2]);

#endif
