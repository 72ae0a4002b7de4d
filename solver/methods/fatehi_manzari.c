/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fatehi & Manzari's second derivatives (Comput. Math. Appl. 61, 482, 2011), their fourth scheme: each component
 * of Brookshaw's sum, minus the corrected gradient, with a matrix that makes it exact for quadratics.  In the
 * notation of correction.h, with e_j = s_j/|s_j| and m, n running over xx, xy, yy, xz, yz, zz,
 *   S_m = sum_j F_j (e_j e_j)_m (T_j - T_i - s_j . h <grad T>) = sum_j omega_mj (T_j - T_i),
 *   omega_mj = F_j ((e_j e_j)_m - A_m . Gamma^-1 s_j),   A_m = sum_j F_j (e_j e_j)_m s_j,
 *   dT_i/dt = sum_m z_m S_m / h^2,   sum_m z_m K_mn = (kappa_x, 0, kappa_y, 0, 0, kappa_z)_n,   K_mn = sum_j omega_mj
 * q_n(s_j), q = (x^2/2, x y, y^2/2, x z, y z, z^2/2).
 *
 * Exact: for all quadratics on any cloud with a regular K; the error is O(h), and O(h^2) if odd moments vanish.
 * Heat is not conserved, and weights can be negative.  Anisotropic kappa along the axes needs no special
 * treatment. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"

#define INLINE static inline __attribute__((always_inline))

/* F_j (e_j e_j)_m */
INLINE void dyads(int dim, const struct correction *c, size_t j, double out[CORRECTION_TERMS]) {
    const double *s = c->s[j];
    double r2 = s[0] * s[0] + s[1] * s[1] + s[2] * s[2], F = r2 > 0 ? c->F[j] / r2 : 0;
    for (int b = 0, n = 0; b < dim; b++)
        for (int a = 0; a <= b; a++) out[n++] = F * s[a] * s[b];
}

/* omega and K */
INLINE void sums(int dim, const struct correction *c, double omega[][CORRECTION_TERMS],
                 double K[][CORRECTION_TERMS]) {
    double A[CORRECTION_TERMS][DIM_MAX] = {{0}};
    const int terms = dim * (dim + 1) / 2;
    for (size_t j = 0; j < c->n; j++) {
        dyads(dim, c, j, omega[j]);
        for (int m = 0; m < terms; m++)
            for (int a = 0; a < dim; a++) A[m][a] += omega[j][m] * c->s[j][a];
    }
    for (size_t j = 0; j < c->n; j++) {
        double g[DIM_MAX], q[CORRECTION_TERMS];
        correction_apply(c, j, g);
        correction_quadratics(dim, c->s[j], q);
        for (int m = 0; m < terms; m++) {
            double sum = 0;
            for (int a = 0; a < dim; a++) sum += A[m][a] * g[a];
            omega[j][m] -= c->F[j] * sum;
            for (int n = 0; n < terms; n++) K[m][n] += omega[j][m] * q[n];
        }
    }
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    (void)p;
    struct correction c;
    double omega[NEIGHBOURS_MAX][CORRECTION_TERMS], K[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}};
    double target[CORRECTION_TERMS], z[CORRECTION_TERMS];
    int terms = correction_target(nb, target);
    if (correction_create(nb, o->kernel, &c, why)) return why->status;
    if (nb->dim == 1) sums(1, &c, omega, K);
    if (nb->dim == 2) sums(2, &c, omega, K);
    if (nb->dim == 3) sums(3, &c, omega, K);
    if (correction_solve(nb, "matrix of second moments", terms, K, target, z, why)) return why->status;
    for (size_t j = 0; j < nb->n; j++) {
        w[0][j] = 0;
        for (int m = 0; m < terms; m++) w[0][j] += z[m] * omega[j][m];
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "fatehi_manzari", .sweeps = 1, .weights = weights};

const struct method method_fatehi_manzari = {
    .name = "fatehi_manzari",
    .about = "Fatehi & Manzari's second derivatives, exact for quadratics on any cloud (2011)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
};
