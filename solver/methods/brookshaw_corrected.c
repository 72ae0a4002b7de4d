/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brookshaw's operator with the corrected gradient of the kernel (Randles & Libersky 1996, Bonet & Lok 1999): in the
 * notation of correction.h,
 *   dT_i/dt = 2 kappa/h^2 sum_j F_j (s_j . Gamma_i^-1 s_j) / |s_j|^2 (T_j - T_i).
 *
 * Exact: for |x - x_i|^2 on any cloud, since sum_j F_j s_j . Gamma^-1 s_j = tr(Gamma^-1 Gamma) = d; for all
 * quadratics where the neighbourhood is even along each axis and alike under their exchange.  Not for x - x_i: where
 * sum_j F_j s_j does not vanish, the error is O(disorder |grad T| / h), as Brookshaw's own.
 * Weights are >= 0 where the kernel falls, since Gamma is then positive definite: the maximum principle holds on any
 * cloud.  Heat is not conserved, as Gamma_i differs from Gamma_j.
 * The choice: Gamma at the particle alone.  The mean of Gamma_i^-1 and Gamma_j^-1 would conserve, and be exact for
 * nothing.  Volumes that are alike cancel. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
    (void)p;
    struct correction c;
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        double g[2], *s = c.s[j], r2 = s[0] * s[0] + s[1] * s[1];
        correction_apply(&c, j, g);
        double part = r2 > 0 ? (s[0] * g[0] + s[1] * g[1]) / r2 : 0;
        w[0][j] = 2 * nb->kappa[0] / (nb->h * nb->h) * c.F[j] * part;
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "brookshaw_corrected", .isotropic = 1, .sweeps = 1, .weights = weights};

const struct method method_brookshaw_corrected = {
    .name = "brookshaw_corrected",
    .about = "Brookshaw's pair operator with the corrected gradient of the kernel (Randles & Libersky 1996)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
