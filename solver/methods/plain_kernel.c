/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laplacians from uncorrected kernel derivatives, for comparison.  On a cloud none is exact for linear T.
 *
 * kernel_second (Takeda et al. 1994; the "standard" form of Song's introduction):
 *   dT_i/dt = kappa sum_j V_j (T_j - T_i) lap W_ij,   lap W = (w''(s) + (d - 1) w'(s)/s) / h^(d+2).
 * Exact: for constants; with --volume moment for x^2 and y^2 on the lattice, sum_j w_j x_j^2 = 2 kappa, and, since
 * the stencil is even, for all quadratics there.  On a cloud errors are O(disorder |grad T| / h).  Pair fluxes are
 * equal and opposite, so heat is conserved on any cloud. lap W changes sign: near neighbours, s < 0.89 for the cubic
 * kernel in the plane, have negative weights, and a sufficiently large negative weight makes a mode grow.  The
 * difference T_j - T_i keeps a constant steady if the sum of lap W does not vanish.  Isotropic conductivity only; a
 * particle needs neighbours on every side.
 *
 * flux_divergence (Lucy 1977; Pamplona 2019, eq. 10):
 *   q_i = -kappa sum_j V_j (T_j - T_i) grad W_ij,   dT_i/dt = -sum_j V_j (q_j - q_i) . grad W_ij.
 * Exact: for constants; with --volume moment, sum_j V_j x_j dW/dx = 1 on the lattice, for linear T in each sweep
 * there, and so for quadratics in both.  On a cloud the gradient of a linear T has an error of O(disorder), and its
 * differences of O(disorder / h).  The printed sum uses differences of fluxes: a pair gives both particles the same
 * contribution, not the opposite, so heat is conserved on a lattice only.  Modes of wavelength 2 dx are in the null
 * space, as for fo_ssph, but without its moment matrix.  The gradient uses differences of T, since otherwise a
 * constant would have a gradient on a cloud.
 *
 * conjugate (Biriukov & Price 2019, MNRAS 483:4901; the difference and the symmetric gradient of Phantom and
 * GADGET):
 *   q_i = -k sum_j V_j (T_j - T_i) grad W_ij,   rho_c dT_i/dt = -sum_j V_j (q_i + q_j) . grad W_ij.
 * With (a, b) = sum_i V_i a_i b_i the second sum is minus the adjoint of the first, (T, div q) = -(grad T, q), on
 * any cloud: the operator is -G* kappa G.  Heat is conserved, since the contributions to a pair are equal and
 * opposite.  No mode grows: (T, A T) = -kappa |G T|^2 <= 0 on every cloud.  Exactness is that of flux_divergence,
 * which it equals on the lattice.  On a cloud it does not converge.  The gradient of a linear T is Gamma_i grad T,
 * Gamma_i = sum_j V_j d_ij grad W_ij, with an error of O(disorder), so the effective conductivity is k_e <= k
 * <Gamma^2> (linear T is one of the fields over which k_e is minimal; oscillations between particles, nearly
 * invisible to G, reduce it further), a separate limit for each kind of cloud.  The stable step is about five times
 * that of a direct second derivative, since G is blind to waves shorter than a few dx.
 *
 * A tensor: as in fo_ssph.
 *
 * Both two-sweep operators refuse a particle with all neighbours on one line, which has no flux across it
 * (correction_spans). */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdlib.h>

/* ---- kernel_second ---- */

/* lap W, m^-(dim + 2), at distance r > 0 */
static double laplacian(enum kernel_name kernel, int dim, double h, double r) {
    double s = r / h;
    return (kernel_curvature(kernel, dim, s) + (dim - 1) * kernel_slope(kernel, dim, s) / s) / pow(h, dim + 2);
}

static double second_volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV;
    if (o->volume == VOLUME_RAW) return dV;
    /* the operator applied to x^2/2 on the lattice */
    double moment = correction_lattice_sum(o->kernel, p->dim, h, spacing, dV, laplacian) / 2;
    return dV / (moment * spacing * spacing);
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Widest angle without a neighbour; a neighbour at the same position is ignored. */
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

static int second_check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)o;
    if (p->dim < 3) return STATUS_OK;
    return refuse(why, STATUS_NOT_APPLICABLE, "kernel_second: on a rod and in the plane only; use so_ssph");
}

/* Weights depend on the distance only.  If one half of the plane (of the rod) has no neighbours, a . d_j >= 0 along
 * some a, and linear T is steady only if weights of both signs happen to cancel (Seibold 2008, Comput. Methods
 * Appl. Mech. Engrg. 198:592, on positive stencils). */
static int surrounds(const struct neighbourhood *nb, struct failure *why) {
    int side[4] = {0}; /* the quadrant around each half axis: with one neighbour in each, no half plane is empty */
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
        "cannot be steady; use a larger --h or less --jitter",
        nb->i, nb->x[0], nb->x[1], nb->n, nb->dim == 2 ? "plane" : "rod");
}

static int second_weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                          double *w[], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = hypot(nb->d[j][0], nb->d[j][1]);
        if (!(r > 0))
            return refuse(why, STATUS_NUMERICAL,
                          "particle %zu at (%.6g, %.6g) m has another of its %zu neighbours at the same place: the "
                          "kernel's second derivative is undefined there",
                          nb->i, nb->x[0], nb->x[1], nb->n);
        w[0][j] = nb->kappa[0] * nb->volume * laplacian(o->kernel, nb->dim, nb->h, r);
    }
    return surrounds(nb, why);
}

static const struct scheme second = {.name = "kernel_second",
                                     .isotropic = 1,
                                     .sweeps = 1,
                                     .check = second_check,
                                     .volume = second_volume,
                                     .weights = second_weights};

const struct method method_kernel_second = {
    .name = "kernel_second",
    .about = "the kernel's second derivative, sum_j V_j (T_j - T_i) lap W (Takeda et al. 1994)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &second,
    .solve = particles_solve,
};

/* ---- flux_divergence, conjugate ---- */

/* -(dW/dr) / r, m^-(dim + 2), at distance r > 0 */
static double slope_over_distance(enum kernel_name kernel, int dim, double h, double r) {
    return -kernel_slope(kernel, dim, r / h) / (r * pow(h, dim + 1));
}

/* The volume V for which the gradient of linear T is exact on the lattice. */
static double gradient_volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 3 ? cbrt(dV) : p->dim == 2 ? sqrt(dV) : dV;
    if (o->volume == VOLUME_RAW) return dV;
    double moment = correction_lattice_sum(o->kernel, p->dim, h, spacing, dV, slope_over_distance);
    return dV / (moment * spacing * spacing);
}

static int gradient_pairs(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *F,
                          double C[DIM_MAX][DIM_MAX], struct failure *why) {
    (void)p;
    for (size_t j = 0; j < nb->n; j++) {
        double r = neighbourhood_distance(nb, j), both = nb->volume * nb->volume;
        F[j] = r > 0 ? both * slope_over_distance(o->kernel, nb->dim, nb->h, r) : 0;
    }
    for (int a = 0; a < nb->dim; a++)
        for (int b = 0; b < nb->dim; b++) C[a][b] = a == b ? 1 / nb->volume : 0;
    return correction_spans(nb, F, why);
}

static const struct scheme divergence = {
    .name = "flux_divergence", .sweeps = 2, .tensor = 1, .volume = gradient_volume, .pairs = gradient_pairs};

const struct method method_flux_divergence = {
    .name = "flux_divergence",
    .about = "the divergence of the flux by the kernel's gradient, twice (Pamplona eq. 10)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &divergence,
    .solve = particles_solve,
};

static const struct scheme conjugate = {
    .name = "conjugate", .sweeps = 2, .tensor = 1, .adjoint = 1, .volume = gradient_volume, .pairs = gradient_pairs};

const struct method method_conjugate = {
    .name = "conjugate",
    .about = "the flux by the kernel's gradient, and its adjoint: conserves heat, no growth (Biriukov & Price 2019)",
    .accepts = PARTICLES_OPTIONS " walls volume",
    .scheme = &conjugate,
    .solve = particles_solve,
};
