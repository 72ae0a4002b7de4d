/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_QUANTITY_H
#define HEATLADDER_REFERENCES_QUANTITY_H

#include "references/scene.h"

/* Derived quantities of a temperature field: heat flux through a side, heat content, temperature at a point, place
 * of a front. */

enum quantity_kind { QUANTITY_FLUX, QUANTITY_HEAT, QUANTITY_AT, QUANTITY_FRONT };

/* Directions in which a front is looked for: all, or within 22.5 degrees of an axis or of a diagonal of the body. */
enum front_sector { FRONT_ALL, FRONT_AXES, FRONT_DIAGONALS, FRONT_SECTORS };

struct quantity {
    enum quantity_kind kind;
    enum side side;           /* for QUANTITY_FLUX */
    double at[DIM_MAX];       /* m, for QUANTITY_AT */
    enum front_sector sector; /* for QUANTITY_FRONT */
};

struct quantity_value {
    double value;
    double error_bound; /* quadrature, truncation and rounding */
    int no_value; /* 1: the value is infinite (flux through a Dirichlet side next to a side at another temperature) or
                     undefined (a corner) */
};

/* Parses the name of a quantity.
 *   flux_x_lo, flux_x_hi, flux_y_lo ... flux_z_hi   heat flow into a rod, rectangle or box through that side
 *   flux_r_lo, flux_r_hi                            the same through the inner or outer wall of a round body
 *   heat                                            rho_c T integrated over the body, J m^(dim-3)
 *   at:X, at:X,Y or at:X,Y,Z                        temperature at a point, K
 *   front                                           place at the melting point of phases, or where k_0 T^n is 0, m
 *   front_axes, front_diagonals                     the latter along the axes or diagonals of a plane or in space
 * A flux is k dT/dn at the end of a rod, W m^-2, or its integral over the side, W m^(dim-3).  Returns STATUS_OK or
 * STATUS_INPUT. */
int quantity_read(const char *text, const struct problem *p, struct quantity *q, struct failure *why);

/* Unit of the value; it depends on the dimension of *p. */
const char *quantity_unit(const struct quantity *q, const struct problem *p);

/* Value for the exact solution at t > 0 s; heat and temperature allow t = 0. */
struct quantity_value quantity_exact(const struct quantity *q, const struct scene *s, const struct problem *p,
                                     double t);

#endif
