/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laplacians with a corrected kernel gradient, for comparison with fatehi_manzari, which is exact for quadratics.
 * The notation is that of correction.h.  None conserves heat, since Gamma_i differs from Gamma_j.
 *
 * brookshaw_corrected (Randles & Libersky 1996, Bonet & Lok 1999): Brookshaw's operator with that gradient,
 *   dT_i/dt = 2 kappa/h^2 sum_j F_j (s_j . Gamma_i^-1 s_j) / |s_j|^2 (T_j - T_i).
 * Exact: for |x - x_i|^2 on any cloud, since sum_j F_j s_j .  Gamma^-1 s_j = tr(Gamma^-1 Gamma) = d; for all
 * quadratics if the neighbourhood is even along each axis and symmetric under their exchange.  Not for x - x_i: if
 * sum_j F_j s_j does not vanish, the error is O(disorder |grad T| / h), as for Brookshaw's own.  For a decreasing
 * kernel Gamma is positive definite and the weights are >= 0: the maximum principle holds on any cloud.
 *
 * schwaiger (Int. J. Numer. Meth. Engng 75, 647, 2008), without its terms for free surfaces, since ghosts
 * complete the support.  The Taylor expansion of Brookshaw's sum is
 *   2 sum_j F_j (T_j - T_i) = 2 N . h grad T + Gamma : h^2 grad grad T + ...,   N = sum_j F_j s_j.
 * With the corrected gradient, and tr(Gamma^-1)/d to compensate the effect of Gamma on the trace,
 *   dT_i/dt = kappa/h^2 tr(Gamma^-1)/d 2 sum_j F_j (T_j - T_i - s_j . h <grad T>).
 * Exact: for linear T on any cloud; for quadratics if the neighbourhood is even along each axis and symmetric under
 * their exchange.  Elsewhere tr(Gamma^-1) Gamma/d is not the identity, and third moments give <grad T> an error of
 * O(h): an error that does not decrease with h at a given disorder.  Weights can be negative.
 *
 * cspm (Chen, Beraun & Carney, Int. J. Numer. Meth. Engng 46, 231, 1999): the Taylor series weighted in turn with
 * the first and second derivatives of the kernel, each order without the previous ones.  With W_mj = V_j (w_xx,
 * w_xy, w_yy)_m at s_j and m, n running over xx, xy, yy (in space also xz, yz, zz),
 *   h <grad T> = Gamma^-1 sum_j F_j s_j (T_j - T_i),
 *   sum_n K_mn u_n = sum_j W_mj (T_j - T_i - s_j . h <grad T>),   K_mn = sum_j W_mj q_n(s_j),
 *   dT_i/dt = (kappa_x u_xx + kappa_y u_yy) / h^2,   q = (x^2/2, x y, y^2/2).
 * Exact: for linear T on any cloud; for quadratics if third moments vanish, as on a lattice.  Elsewhere <grad T>
 * includes part of a quadratic that K does not account for, an error that does not decrease with h.  Weights change
 * sign with w_xx. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>

/* ---- brookshaw_corrected ---- */

static int weights_brookshaw(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                             double *w[], struct failure *why) {
    (void)p;
    struct correction c;
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        double g[DIM_MAX], *s = c.s[j], r2 = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
        correction_apply(&c, j, g);
        double part = r2 > 0 ? (s[0] * g[0] + s[1] * g[1] + s[2] * g[2]) / r2 : 0;
        w[0][j] = 2 * nb->kappa[0] / (nb->h * nb->h) * c.F[j] * part;
    }
    return STATUS_OK;
}

static const struct scheme brookshaw = {
    .name = "brookshaw_corrected", .isotropic = 1, .sweeps = 1, .weights = weights_brookshaw};

const struct method method_brookshaw_corrected = {
    .name = "brookshaw_corrected",
    .about = "Brookshaw's pair operator with the corrected gradient of the kernel (Randles & Libersky 1996)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &brookshaw,
    .solve = particles_solve,
};

/* ---- schwaiger ---- */

static int weights_schwaiger(const struct problem *p, const struct options *o, const struct neighbourhood *nb,
                             double *w[], struct failure *why) {
    (void)p;
    struct correction c;
    double N[DIM_MAX] = {0}, trace = 0;
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < nb->dim; a++) N[a] += c.F[j] * c.s[j][a];
    for (int a = 0; a < nb->dim; a++) trace += c.inverse[a][a];
    for (size_t j = 0; j < nb->n; j++) {
        double g[DIM_MAX];
        correction_apply(&c, j, g);
        w[0][j] = 2 * (trace / nb->dim) * nb->kappa[0] / (nb->h * nb->h) * c.F[j] *
                  (1 - N[0] * g[0] - N[1] * g[1] - N[2] * g[2]);
    }
    return STATUS_OK;
}

static const struct scheme schwaiger = {
    .name = "schwaiger", .isotropic = 1, .sweeps = 1, .weights = weights_schwaiger};

const struct method method_schwaiger = {
    .name = "schwaiger",
    .about = "Schwaiger's pair operator less the corrected gradient, over the trace of its moments (2008)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &schwaiger,
    .solve = particles_solve,
};

/* ---- cspm ---- */

/* V_j (w_xx, w_xy, w_yy) / h^dim of the radial kernel w: w_ab = w'' e_a e_b + (w'/s) (delta_ab - e_a e_b). */
static void curvatures(const struct neighbourhood *nb, enum kernel_name kernel, const struct correction *c, size_t j,
                       double out[CORRECTION_TERMS]) {
    const double *s = c->s[j];
    double unit = 1, r2 = s[0] * s[0] + s[1] * s[1] + s[2] * s[2], r = sqrt(r2);
    for (int a = 0; a < nb->dim; a++) unit *= nb->h;
    double along = nb->volume / unit * kernel_curvature(kernel, nb->dim, r), across = -c->F[j];
    for (int b = 0, n = 0; b < nb->dim; b++)
        for (int a = 0; a <= b; a++, n++) {
            out[n] = (a == b ? along : along - across) * s[a] * s[b];
            for (int d = 0; d < nb->dim && a == b; d++) out[n] += d != a ? across * s[d] * s[d] : 0;
            out[n] = r2 > 0 ? out[n] / r2 : 0;
        }
}

static int weights_cspm(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                        struct failure *why) {
    (void)p;
    struct correction c;
    double A[DIM_MAX] = {0}, K[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}};
    double W[NEIGHBOURS_MAX][CORRECTION_TERMS], target[CORRECTION_TERMS], z[CORRECTION_TERMS];
    int terms = correction_target(nb, target);
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        double q[CORRECTION_TERMS];
        curvatures(nb, o->kernel, &c, j, W[j]);
        correction_quadratics(nb->dim, c.s[j], q);
        for (int m = 0; m < terms; m++)
            for (int n = 0; n < terms; n++) K[m][n] += W[j][m] * q[n];
    }
    if (correction_solve(nb, "matrix of the kernel's second derivatives", terms, K, target, z, why))
        return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        w[0][j] = 0;
        for (int m = 0; m < terms; m++) w[0][j] += z[m] * W[j][m];
        for (int a = 0; a < nb->dim; a++) A[a] += w[0][j] * c.s[j][a];
    }
    for (size_t j = 0; j < nb->n; j++) {
        double g[DIM_MAX];
        correction_apply(&c, j, g);
        w[0][j] -= c.F[j] * (A[0] * g[0] + A[1] * g[1] + A[2] * g[2]);
    }
    return STATUS_OK;
}

static const struct scheme cspm = {.name = "cspm", .sweeps = 1, .weights = weights_cspm};

const struct method method_cspm = {
    .name = "cspm",
    .about = "corrective smoothed particle method: Taylor's series order by order (Chen, Beraun & Carney 1999)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &cspm,
    .solve = particles_solve,
};
