/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies by distance (Morris, Fox & Zhu 1997, J. Comput. Phys. 136:214): of each pair of a particle i and a dummy d
 *   T_d = T_w - (d_d/d_i) (T_i - T_w),   1 + d_d/d_i at most 1.5 as published, or R (--ratio-most),
 * d the distances from the wall.  Exact for linear T across the wall while the bound does not bind: it does for most
 * pairs, d_d > d_i/2, so that the wall's pull is too weak by a share that does not fall with dx.
 *
 * The bound buys the step.  Half of a particle's own weight, 1.45 kappa/dx^2, is beyond a wall that it is next to,
 * and counts R times: the largest step is 2/(1.45 (1 + R)) dx^2/kappa, and in a disc 0.226, 0.126 and 0.0137 at R =
 * 5, 10 and 100 (predicted 0.230, 0.125, 0.0137).  Without a bound the order is two, in the largest error too. */
#include "solver/particles/walls.h"

static int fill(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    (void)w, (void)d, (void)why;
    out->offset = site->walls == 2 ? (site->value[0] + site->value[1]) / 2 : site->value[0];
    return STATUS_OK;
}

const struct wall_treatment walls_distance = {.name = "distance",
                                              .about = "dummies extrapolated for each pair (Morris, Fox & Zhu 1997)",
                                              .kinds = 1u << DIRICHLET,
                                              .pairs = 1,
                                              .fill = fill};
