/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies that hold the wall's temperature (Pamplona Fig. 3): T_d = T_w.
 *
 * The wall then lies where the dummies are, up to dx away from where it is: first order. */
#include "solver/particles/walls.h"

static int fill(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    (void)w, (void)d, (void)why;
    out->offset = site->walls == 2 ? (site->value[0] + site->value[1]) / 2 : site->value[0];
    return STATUS_OK;
}

const struct wall_treatment walls_fixed = {
    .name = "fixed", .about = "dummies hold the wall's temperature", .kinds = 1u << DIRICHLET, .fill = fill};
