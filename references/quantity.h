/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_QUANTITY_H
#define HEATLADDER_REFERENCES_QUANTITY_H

#include "references/scene.h"

/* Quantities derived from a temperature field: flux through a side, heat of the body, temperature at a point. */

enum quantity_kind { QUANTITY_FLUX, QUANTITY_HEAT, QUANTITY_AT };

struct quantity {
    enum quantity_kind kind;
    enum side side; /* of a flux */
    double at[2];   /* m, of a temperature */
};

struct quantity_value {
    double value;
    double error_bound; /* cubature, truncation and rounding */
    int no_value;       /* 1: infinite (the flux through a side whose corner disagrees), or none in a corner */
};

/* Reads flux_x_lo, flux_x_hi, flux_y_lo or flux_y_hi, of a round body flux_r_lo (of its hole) or flux_r_hi (the heat
 * that flows into the body through that side: k dT/dn over a rod's end, W m^-2, integrated along a rectangle's side,
 * W per m of depth), heat (rho_c T integrated over the body, J m^-2 or J per m of depth), at:X or at:X,Y (the
 * temperature there, K).  STATUS_OK or STATUS_INPUT. */
int quantity_read(const char *text, const struct problem *p, struct quantity *q, struct failure *why);

/* The unit of its value on a rod or a rectangle. */
const char *quantity_unit(const struct quantity *q, const struct problem *p);

/* Of the exact solution at t > 0 s (heat and temperature: t >= 0). */
struct quantity_value quantity_exact(const struct quantity *q, const struct scene *s, const struct problem *p,
                                     double t);

#endif
