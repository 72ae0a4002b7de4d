/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Schwaiger's operator (Int. J. Numer. Meth. Engng 75, 647, 2008), without its terms for free surfaces, since ghosts
 * complete the support.  Taylor's expansion of Brookshaw's sum, in the notation of correction.h, is
 *   2 sum_j F_j (T_j - T_i) = 2 N . h grad T + Gamma : h^2 grad grad T + ...,   N = sum_j F_j s_j,
 * and so, with the corrected gradient and tr(Gamma^-1)/d for what Gamma does to the trace,
 *   dT_i/dt = kappa/h^2 tr(Gamma^-1)/d 2 sum_j F_j (T_j - T_i - s_j . h <grad T>).
 *
 * Exact: for linear T on any cloud; for quadratics where the neighbourhood is even along each axis and alike under
 * their exchange.  Elsewhere tr(Gamma^-1) Gamma/d is not the identity, and <grad T> is wrong by O(h) where third
 * moments remain: an error that does not fall with h at a given disorder.
 * Heat is not conserved, and weights can be negative: 1 - N . Gamma^-1 s_j changes sign.
 * The choice: Randles & Libersky's gradient for <grad T>; constant kappa outside. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
    (void)p;
    struct correction c;
    double N[2] = {0, 0};
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < 2; a++) N[a] += c.F[j] * c.s[j][a];
    double trace = (c.inverse[0][0] + (nb->dim == 2 ? c.inverse[1][1] : 0)) / nb->dim;
    for (size_t j = 0; j < nb->n; j++) {
        double g[2];
        correction_apply(&c, j, g);
        w[0][j] = 2 * trace * nb->kappa[0] / (nb->h * nb->h) * c.F[j] * (1 - N[0] * g[0] - N[1] * g[1]);
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "schwaiger", .isotropic = 1, .sweeps = 1, .weights = weights};

const struct method method_schwaiger = {
    .name = "schwaiger",
    .about = "Schwaiger's pair operator less the corrected gradient, over the trace of its moments (2008)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
