/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SO-SSPH: the second derivatives directly, from one Taylor expansion of order p >= 2 (Song eqs. 10, 11):
 *   dT/dt = kappa_x <T_xx> + kappa_y <T_yy> + kappa_z <T_zz> + 2 kappa_xy <T_xy> + 2 kappa_xz <T_xz> + ...
 * --order 3 or 4 keeps more terms; 4 is fourth order on a lattice and off it.  One material only: kappa stands
 * outside the derivative. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"
#include "solver/particles/walls.h"

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)p;
    if (o->order && (o->order < 2 || o->order > SSPH_ORDER_MAX))
        return refuse(why, STATUS_INPUT, "--order %d: so_ssph takes 2 to %d", o->order, SSPH_ORDER_MAX);
    return STATUS_OK;
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    (void)p;
    double target[SSPH_TERMS_MAX] = {0};
    for (int a = 0; a < nb->dim; a++) {
        target[ssph_second(nb->dim, a)] = nb->kappa[a];
        for (int b = 0; b < a; b++) target[ssph_mixed(nb->dim, b, a)] = 2 * nb->cross[problem_pair(b, a)];
    }
    return ssph_weights(nb, o->kernel, o->order ? o->order : 2, target, w[0], why);
}

static const struct scheme scheme = {
    .name = "so_ssph", .sweeps = 1, .tensor = 1, .check = check, .weights = weights, .at_wall = walls_one_sided};

const struct method method_so_ssph = {
    .name = "so_ssph",
    .about = "second-order symmetric SPH: kappa <T_xx> from one Taylor expansion (Song eq. 11)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " order",
    .scheme = &scheme,
    .solve = particles_solve,
};
