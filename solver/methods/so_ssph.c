/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SO-SSPH: the second derivatives directly, from one Taylor expansion of order p >= 2 (Song eqs. 10, 11):
 *   dT/dt = kappa_x <T_xx> + kappa_y <T_yy> + kappa_z <T_zz> + 2 kappa_xy <T_xy> + 2 kappa_xz <T_xz> + ...
 * --order 3 or 4 keeps more terms; 4 is fourth order on a lattice and off it.  One material only: kappa stands
 * outside the derivative.
 *
 * Along a field K varies and (div K) . grad T is added, of the same expansion.  Beyond a held plane wall T is odd in
 * the mirror image.  With K_nt that is exact to first degree: T_t = 0 on the wall makes T_nn = -2 K_nt/K_nn T_nt.
 * The truncation error, of order 0 in a layer one kernel wide, costs dx^2 in T, which is 0 at the wall. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"
#include "solver/particles/walls.h"

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)p;
    if (o->order && (o->order < 2 || o->order > SSPH_ORDER_MAX))
        return refuse(why, STATUS_INPUT, "--order %d: so_ssph takes 2 to %d", o->order, SSPH_ORDER_MAX);
    return STATUS_OK;
}

/* K/rho_c at the particle, m^2 s^-1, and its divergence, m s^-1, by central differences. */
static void along_field(const struct problem *p, const struct neighbourhood *nb, double K[DIM_MAX][DIM_MAX],
                        double drift[DIM_MAX]) {
    const double step = 1e-4 * nb->h;
    double beside[2][DIM_MAX][DIM_MAX];
    problem_tensor(p, nb->x, K);
    for (int a = 0; a < nb->dim; a++) {
        for (int side = 0; side < 2; side++) {
            double x[DIM_MAX] = {nb->x[0], nb->x[1], nb->x[2]};
            x[a] += side ? step : -step;
            problem_tensor(p, x, beside[side]);
        }
        for (int b = 0; b < nb->dim; b++) drift[b] += (beside[1][a][b] - beside[0][a][b]) / (2 * step * nb->rho_c);
    }
    for (int a = 0; a < nb->dim; a++)
        for (int b = 0; b < nb->dim; b++) K[a][b] /= nb->rho_c;
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    double target[SSPH_TERMS_MAX] = {0}, K[DIM_MAX][DIM_MAX], drift[DIM_MAX] = {0};
    if (p->direction) along_field(p, nb, K, drift);
    for (int a = 0; a < nb->dim; a++) {
        target[a] = nb->h * drift[a];
        target[ssph_second(nb->dim, a)] = p->direction ? K[a][a] : nb->kappa[a];
        for (int b = 0; b < a; b++)
            target[ssph_mixed(nb->dim, b, a)] = 2 * (p->direction ? K[a][b] : nb->cross[problem_pair(b, a)]);
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
