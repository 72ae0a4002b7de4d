/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences for two materials, on a rod, in the plane or in a box.
 *
 *   rho_c_i dT_i/dt = (k_{i+1/2} (T_{i+1} - T_i) - k_{i-1/2} (T_i - T_{i-1})) / d^2
 *
 * rho_c is the average over the cell.  The series mean is k_{i+1/2} = d / (l_1/k_1 + l_2/k_2), l_m the length of the
 * line between the two points in material m (Patankar 1980, section 4.2-3, for any interface position).  Steady
 * profiles are then exact and the cells have the heat of both materials: second order for any interface position.
 * Along y and z the two parts of a cell that the interface cuts conduct in parallel, with the mean of k_y or k_z over
 * its width.
 * The harmonic and arithmetic means use the conductivities at the two points; they are exact, respectively first
 * order, if the interface is midway.  A point or face within round-off of the interface is on it. */
#include "solver/differences/ftcs_layers.h"

#include "solver/problem.h"

#include <math.h>

/* Distance of x beyond the interface in units of d, with round-off removed. */
static double depth(const struct problem *p, double d, double x) {
    double apart = (x - p->interface) / fabs(d), edge = nearbyint(2 * apart) / 2;
    return fabs(apart - edge) < 1e-9 ? edge : apart;
}

int ftcs_layers_parts(const struct problem *p, double d, double x, double share[2], double middle[2]) {
    double at = p->materials == 2 ? depth(p, d, x) : -1;
    share[0] = fmin(1, fmax(0, 0.5 - at));
    share[1] = 1 - share[0];
    middle[0] = middle[1] = x;
    if (share[0] == 0 || share[1] == 0) return 1;
    middle[0] = p->interface - 0.5 * share[0] * d;
    middle[1] = p->interface + 0.5 * share[1] * d;
    return 2;
}

double ftcs_layers_rho_c(const struct problem *p, double d, double x) {
    double share[2], middle[2];
    ftcs_layers_parts(p, d, x, share, middle);
    return share[0] * p->material[0].rho_c + (share[1] > 0 ? share[1] * p->material[1].rho_c : 0);
}

double ftcs_layers_across(const struct problem *p, int axis, double d, double x) {
    double share[2], middle[2];
    if (p->materials < 2) return p->material[0].k[axis];
    ftcs_layers_parts(p, d, x, share, middle);
    return share[0] * p->material[0].k[axis] + share[1] * p->material[1].k[axis];
}

double ftcs_layers_conductivity(const struct problem *p, enum mean mean, double x, double d) {
    if (p->materials < 2) return p->material[0].k[0];
    double here = depth(p, d, x), there = here + (d > 0 ? 1 : -1);
    double ka = p->material[here >= 0].k[0], kb = p->material[there >= 0].k[0];
    double beyond = fmin(1, fmax(0, fmax(here, there))); /* fraction of the line */
    if (mean == MEAN_ARITHMETIC) return 0.5 * (ka + kb);
    if (mean != MEAN_SERIES) return 2 * ka * kb / (ka + kb);
    return 1 / ((1 - beyond) / p->material[0].k[0] + beyond / p->material[1].k[0]);
}
