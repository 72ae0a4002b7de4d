/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The conjugate pair of first derivatives (Biriukov & Price 2019, MNRAS 483:4901; the difference and the symmetric
 * gradient of Phantom and GADGET codes):
 *   q_i = -k sum_j V_j (T_j - T_i) grad W_ij,   rho_c dT_i/dt = -sum_j V_j (q_i + q_j) . grad W_ij.
 *
 * With (a, b) = sum_i V_i a_i b_i the second sum is minus the adjoint of the first, (T, div q) = -(grad T, q),
 * whatever the cloud: the operator is -G* kappa G. Kept: heat, since a pair's parts are equal and opposite.  Never
 * grows: (T, A T) = -kappa |G T|^2 <= 0 on every cloud. Exact: for constants; with --volume moment for quadratics on
 * the lattice, where it is flux_divergence. On a cloud it does not converge.  The gradient of a linear T is Gamma_i
 * grad T, Gamma_i = sum_j V_j d_ij grad W_ij, wrong by O(disorder), so that it conducts k_e <= k <Gamma^2> (T linear
 * is one of the fields over which k_e is least; wiggles between particles, which G hardly sees, take it lower), a
 * limit of its own for each kind of cloud. Modes of wavelength 2 dx lie in the null space on the lattice.  The step
 * is some five times that of a direct second derivative: G sees no wave shorter than a few dx. */
#include "solver/particles/kernel_gradient.h"
#include "solver/particles/particles.h"

static const struct scheme scheme = {
    .name = "conjugate", .sweeps = 2, .adjoint = 1, .volume = kernel_gradient_volume, .pairs = kernel_gradient_pairs};

const struct method method_conjugate = {
    .name = "conjugate",
    .about = "the flux by the kernel's gradient, and its adjoint: keeps heat, never grows (Biriukov & Price 2019)",
    .accepts = PARTICLES_OPTIONS " walls volume",
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
