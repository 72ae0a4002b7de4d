/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSPM (Chen, Beraun & Carney, Int. J. Numer. Meth. Engng 46, 231, 1999): the Taylor series weighted in turn with the
 * kernel's first and second derivatives, each order taken less what the orders before it have.  In the notation of
 * correction.h, with W_mj = V_j (w_xx, w_xy, w_yy)_m at s_j and m, n running over xx, xy, yy,
 *   h <grad T> = Gamma^-1 sum_j F_j s_j (T_j - T_i),
 *   sum_n K_mn u_n = sum_j W_mj (T_j - T_i - s_j . h <grad T>),   K_mn = sum_j W_mj q_n(s_j),
 *   dT_i/dt = (kappa_x u_xx + kappa_y u_yy) / h^2,   q = (x^2/2, x y, y^2/2).
 *
 * Exact: for linear T on any cloud; for quadratics where third moments vanish, as on a lattice.  Elsewhere <grad T>
 * takes up part of a quadratic that K does not know of (Fatehi & Manzari's K does), an error that does not fall with
 * h.  Heat is not conserved, and weights change sign with w_xx. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>

/* V_j (w_xx, w_xy, w_yy) / h^d, of the radial kernel w: w_ab = w'' e_a e_b + (w'/s) (delta_ab - e_a e_b). */
static void curvatures(const struct neighbourhood *nb, enum kernel_name kernel, const struct correction *c, size_t j,
                       double out[CORRECTION_TERMS]) {
    const double *s = c->s[j];
    double unit = nb->dim == 2 ? nb->h * nb->h : nb->h, r2 = s[0] * s[0] + s[1] * s[1], r = sqrt(r2);
    double along = nb->volume / unit * kernel_curvature(kernel, nb->dim, r), across = -c->F[j];
    out[0] = out[1] = out[2] = 0;
    if (r2 == 0) return;
    out[0] = (along * s[0] * s[0] + across * s[1] * s[1]) / r2;
    out[1] = (along - across) * s[0] * s[1] / r2;
    out[2] = (along * s[1] * s[1] + across * s[0] * s[0]) / r2;
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
    (void)p;
    struct correction c;
    double A[2] = {0, 0}, K[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}};
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
        for (int a = 0; a < 2; a++) A[a] += w[0][j] * c.s[j][a];
    }
    for (size_t j = 0; j < nb->n; j++) {
        double g[2];
        correction_apply(&c, j, g);
        w[0][j] -= c.F[j] * (A[0] * g[0] + A[1] * g[1]);
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "cspm", .sweeps = 1, .weights = weights};

const struct method method_cspm = {
    .name = "cspm",
    .about = "corrective smoothed particle method: Taylor's series order by order (Chen, Beraun & Carney 1999)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
