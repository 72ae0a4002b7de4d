/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laplacians by the kernel's derivatives as they are, for comparison: on a cloud none is exact for linear T.
 *
 * kernel_second (Takeda et al. 1994; the "standard" form of Song's introduction):
 *   dT_i/dt = kappa sum_j V_j (T_j - T_i) lap W_ij,   lap W = (w''(s) + (d - 1) w'(s)/s) / h^(d+2).
 * Exact: for constants; with --volume moment for x^2 and y^2 on the lattice, sum_j w_j x_j^2 = 2 kappa, and, as the
 * stencil is even, for all quadratics there.  On a cloud errors are O(disorder |grad T| / h).  Pair fluxes are equal
 * and opposite, so heat is conserved on any cloud.  lap W changes sign: near neighbours, s < 0.89 of the cubic kernel
 * in the plane, have negative weights, and a negative weight that is large enough makes a mode grow.  T_i is taken
 * off, so that a constant stays constant where the sum of lap W does not vanish.  Isotropic conductivity only; a
 * particle must have neighbours on every side.
 *
 * flux_divergence (Lucy 1977; Pamplona 2019, eq. 10):
 *   q_i = -kappa sum_j V_j (T_j - T_i) grad W_ij,   dT_i/dt = -sum_j V_j (q_j - q_i) . grad W_ij.
 * Exact: for constants; with --volume moment, where sum_j V_j x_j dW/dx = 1 on the lattice, for linear T in each
 * sweep there, and so for quadratics in both.  On a cloud the gradient of a linear T is wrong by O(disorder), and its
 * differences by O(disorder / h).  As printed the sum takes differences of fluxes: a pair gives both particles the
 * same, not the opposite, so heat is conserved on a lattice only.  Modes of wavelength 2 dx are in the null space, as
 * with fo_ssph, whose moment matrix this one lacks.  Differences of T in the gradient too: without them a constant
 * would have a gradient on a cloud.
 *
 * conjugate (Biriukov & Price 2019, MNRAS 483:4901; the difference and the symmetric gradient of Phantom and GADGET):
 *   q_i = -k sum_j V_j (T_j - T_i) grad W_ij,   rho_c dT_i/dt = -sum_j V_j (q_i + q_j) . grad W_ij.
 * With (a, b) = sum_i V_i a_i b_i the second sum is minus the adjoint of the first, (T, div q) = -(grad T, q),
 * whatever the cloud: the operator is -G* kappa G.  Kept: heat, since a pair's parts are equal and opposite.  Never
 * grows: (T, A T) = -kappa |G T|^2 <= 0 on every cloud.  Exact: as flux_divergence, which it is on the lattice.  On a
 * cloud it does not converge.  The gradient of a linear T is Gamma_i grad T, Gamma_i = sum_j V_j d_ij grad W_ij,
 * wrong by O(disorder), so that it conducts k_e <= k <Gamma^2> (T linear is one of the fields over which k_e is
 * least; wiggles between particles, which G hardly sees, take it lower), a limit of its own for each kind of cloud.
 * The step is some five times that of a direct second derivative: G sees no wave shorter than a few dx.
 *
 * In both of two sweeps a particle with all neighbours on one line has no flux across it (correction_spans): refused.
 */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>

/* ---- kernel_second ---- */

/* lap W, m^-(d + 2), at distance r > 0 */
static double laplacian(enum kernel_name kernel, int dim, double h, double r) {
    double s = r / h;
    return (kernel_curvature(kernel, dim, s) + (dim - 1) * kernel_slope(kernel, dim, s) / s) / pow(h, dim + 2);
}

static double second_volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV, moment = 0; /* the sum for x^2/2 on the lattice */
    if (o->volume == VOLUME_RAW) return dV;
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), across = p->dim == 2 ? reach : 0;
    for (int j = -across; j <= across; j++)
        for (int i = -reach; i <= reach; i++)
            if (i || j) moment += laplacian(o->kernel, p->dim, h, hypot(i, j) * spacing) * dV * i * i / 2;
    return dV / (moment * spacing * spacing);
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The widest angle without a neighbour; one at the same place counts for none. */
static double widest_gap(const struct neighbourhood *nb) {
    double angle[NEIGHBOURS_MAX], widest = 0;
    size_t n = 0;
    for (size_t j = 0; j < nb->n; j++)
        if (nb->d[j][0] != 0 || nb->d[j][1] != 0) angle[n++] = atan2(nb->d[j][1], nb->d[j][0]);
    if (n == 0) return 2 * M_PI;
    qsort(angle, n, sizeof *angle, compare);
    for (size_t k = 0; k + 1 < n; k++) widest = fmax(widest, angle[k + 1] - angle[k]);
    return fmax(widest, angle[0] + 2 * M_PI - angle[n - 1]);
}

/* Weights depend on the distance alone: where one half of the plane (of the rod) is without neighbours, all a.d_j >=
 * 0 along some a, linear T stays only by weights that change sign and happen to cancel (Seibold 2008, Comput. Methods
 * Appl. Mech. Engrg. 198:592, of positive stencils). */
static int surrounds(const struct neighbourhood *nb, struct failure *why) {
    int side[4] = {0}; /* the quarter around each half axis: one in each leaves less than half of the plane */
    for (size_t j = 0; j < nb->n; j++) {
        double x = nb->d[j][0], y = nb->d[j][1];
        if (x > fabs(y)) side[0] = 1;
        if (-x > fabs(y)) side[1] = 1;
        if (y > fabs(x)) side[2] = 1;
        if (-y > fabs(x)) side[3] = 1;
    }
    if (side[0] && side[1] && (nb->dim == 1 || (side[2] && side[3]))) return STATUS_OK;
    double rounding = 1e-9;
    if (nb->dim == 2 && widest_gap(nb) < M_PI - rounding) return STATUS_OK;
    return refuse(
        why, STATUS_NUMERICAL,
        "particle %zu at (%.6g, %.6g) m has %zu neighbours, none in one half of the %s: a linear temperature "
        "could not stay; use a larger --h or less --jitter",
        nb->i, nb->x[0], nb->x[1], nb->n, nb->dim == 2 ? "plane" : "rod");
}

static int second_weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                          double *w[2], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = hypot(nb->d[j][0], nb->d[j][1]);
        if (!(r > 0))
            return refuse(why, STATUS_NUMERICAL,
                          "particle %zu at (%.6g, %.6g) m has another of its %zu neighbours at the same place: the "
                          "kernel's second derivative makes no sense there",
                          nb->i, nb->x[0], nb->x[1], nb->n);
        w[0][j] = nb->kappa[0] * nb->volume * laplacian(o->kernel, nb->dim, nb->h, r);
    }
    return surrounds(nb, why);
}

static const struct scheme second = {
    .name = "kernel_second", .isotropic = 1, .sweeps = 1, .volume = second_volume, .weights = second_weights};

const struct method method_kernel_second = {
    .name = "kernel_second",
    .about = "the kernel's second derivative, sum_j V_j (T_j - T_i) lap W (Takeda et al. 1994)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &second,
    .solve = particles_solve,
};

/* ---- flux_divergence, conjugate ---- */

/* -(dW/dr) / r, m^-(d + 2), at distance r > 0 */
static double slope_over_distance(enum kernel_name kernel, int dim, double h, double r) {
    return -kernel_slope(kernel, dim, r / h) / (r * pow(h, dim + 1));
}

/* V such that the gradient of linear T is exact on the lattice. */
static double gradient_volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV, moment = 0; /* the gradient of x on the lattice */
    if (o->volume == VOLUME_RAW) return dV;
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), across = p->dim == 2 ? reach : 0;
    for (int j = -across; j <= across; j++)
        for (int i = -reach; i <= reach; i++)
            if (i) moment += slope_over_distance(o->kernel, p->dim, h, hypot(i, j) * spacing) * dV * i * i;
    return dV / (moment * spacing * spacing);
}

static int gradient_pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                          double C[3], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = hypot(nb->d[j][0], nb->d[j][1]), both = nb->volume * nb->volume;
        F[j] = r > 0 ? both * slope_over_distance(o->kernel, nb->dim, nb->h, r) : 0;
    }
    C[0] = C[2] = 1 / nb->volume, C[1] = 0;
    return correction_spans(nb, F, why);
}

static const struct scheme divergence = {
    .name = "flux_divergence", .sweeps = 2, .volume = gradient_volume, .pairs = gradient_pairs};

const struct method method_flux_divergence = {
    .name = "flux_divergence",
    .about = "the divergence of the flux by the kernel's gradient, twice (Pamplona eq. 10)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &divergence,
    .solve = particles_solve,
};

static const struct scheme conjugate = {
    .name = "conjugate", .sweeps = 2, .adjoint = 1, .volume = gradient_volume, .pairs = gradient_pairs};

const struct method method_conjugate = {
    .name = "conjugate",
    .about = "the flux by the kernel's gradient, and its adjoint: keeps heat, never grows (Biriukov & Price 2019)",
    .accepts = PARTICLES_OPTIONS " walls volume",
    .scheme = &conjugate,
    .solve = particles_solve,
};
