/* SPDX-License-Identifier: GPL-3.0-or-later */
/* FO-SSPH: first derivatives from a Taylor expansion of order 1 (Song eqs. 12, 13), applied twice (eqs. 6, 37):
 *   q = -kappa <grad T>,   dT/dt = -<div q>.
 * On a lattice the two sweeps are one wider stencil, the first-derivative stencil convolved with itself.  Modes of
 * wavelength 2 dx are in the null space of the first derivative, and so of this operator.  One material only.  On a
 * cut lattice dummies extend two kernels deep; those by `fit` keep second order and let no mode grow.
 *
 * A tensor: q = K <grad T>, K of the particle; of a ghost, that of its place beyond the wall.  On a lattice all
 * derivatives of a wave are short by the same part if |q_x| = |q_y|: T along b stays on its line, without a leak.
 * Beyond a held plane wall T is odd, and K grad T goes on smoothly where T does; else the error of order 0 in a layer
 * two kernels wide costs dx^2 in T, as in so_ssph.  K of the mirror image, with K_nt of the other sign, makes the
 * operator the adjoint of its gradient and is of order 1.2 where b crosses the wall.  With k_perp below 1 % of k_par
 * and b at 0.1 to 0.2 rad to a wall a mode grows there at 5e-4 kappa_par/dx^2; the run warns.  Off a lattice modes
 * grow at once. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"

static int pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                 double C[DIM_MAX][DIM_MAX], struct failure *why) {
    (void)p;
    return ssph_gradient(nb, o->kernel, F, C, why);
}

static const struct scheme scheme = {.name = "fo_ssph", .sweeps = 2, .tensor = 1, .pairs = pairs};

const struct method method_fo_ssph = {
    .name = "fo_ssph",
    .about = "first-order symmetric SPH: q = -kappa <grad T>, dT/dt = -<div q> (Song eqs. 13, 37)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
};
