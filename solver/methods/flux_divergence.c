/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The divergence of the flux (Lucy 1977; Pamplona 2019, eq. 10): the kernel's gradient, twice,
 *   q_i = -kappa sum_j V_j (T_j - T_i) grad W_ij,   dT_i/dt = -sum_j V_j (q_j - q_i) . grad W_ij.
 *
 * Exact: for constants; with --volume moment, where sum_j V_j x_j dW/dx = 1 on the lattice, for linear T in each
 * sweep there, and so for quadratics in both.  On a cloud the gradient of a linear T is wrong by O(disorder), and its
 * differences by O(disorder / h).
 * As printed the sum takes differences of fluxes: a pair gives both particles the same, not the opposite, so heat is
 * conserved on a lattice only.  Modes of wavelength 2 dx lie in the null space, as with fo_ssph, whose moment matrix
 * is what this one lacks.
 * A particle all of whose neighbours lie on one line has no flux across it (correction_spans): refused.
 * The choice: differences of T in the gradient too, without which a constant would have one on a cloud. */
#include "solver/particles/correction.h"
#include "solver/particles/kernel_gradient.h"
#include "solver/particles/particles.h"

static const struct scheme scheme = {
    .name = "flux_divergence", .sweeps = 2, .volume = kernel_gradient_volume, .pairs = kernel_gradient_pairs};

const struct method method_flux_divergence = {
    .name = "flux_divergence",
    .about = "the divergence of the flux by the kernel's gradient, twice (Pamplona eq. 10)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
