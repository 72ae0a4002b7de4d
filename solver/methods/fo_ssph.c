/* SPDX-License-Identifier: GPL-3.0-or-later */
/* FO-SSPH: first derivatives from a Taylor expansion of order 1 (Song eqs. 12, 13), applied twice (eqs. 6, 37):
 *   q = -kappa <grad T>,   dT/dt = -<div q>.
 * On a lattice the two sweeps are one wider stencil, the first-derivative stencil convolved with itself.  Modes of
 * wavelength 2 dx are in the null space of the first derivative, and so of this operator.  One material only.  On a
 * cut lattice dummies extend two kernels deep; those by `fit` keep second order and let no mode grow. */
#include "solver/particles/particles.h"
#include "solver/particles/ssph.h"

static int pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                 double C[DIM_MAX][DIM_MAX], struct failure *why) {
    (void)p;
    return ssph_gradient(nb, o->kernel, F, C, why);
}

static const struct scheme scheme = {.name = "fo_ssph", .sweeps = 2, .pairs = pairs};

const struct method method_fo_ssph = {
    .name = "fo_ssph",
    .about = "first-order symmetric SPH: q = -kappa <grad T>, dT/dt = -<div q> (Song eqs. 13, 37)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
};
