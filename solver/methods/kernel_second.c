/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernel's second derivative (Takeda et al. 1994; the "standard" form of Song's introduction):
 *   dT_i/dt = kappa sum_j V_j (T_j - T_i) lap W_ij,   lap W = (w''(s) + (d - 1) w'(s)/s) / h^(d+2).
 *
 * Exact: for constants; with --volume moment for x^2 and y^2 on the lattice, sum_j w_j x_j^2 = 2 kappa, and, as the
 * stencil is even, for all quadratics there.  On a cloud neither for linear T: errors are O(disorder |grad T| / h).
 * Pair fluxes are equal and opposite, so heat is conserved on any cloud.
 * lap W changes sign: near neighbours, s < 0.89 of the cubic kernel in the plane, have negative weights, and a
 * negative weight that is large enough makes a mode grow.
 * The choice: T_i is taken off, so that a constant stays constant where the sum of lap W does not vanish.
 * Isotropic conductivity only; a particle must have neighbours on every side (correction_surrounds). */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>

/* lap W, m^-(d + 2), at distance r > 0 */
static double laplacian(enum kernel_name kernel, int dim, double h, double r) {
    double s = r / h;
    return (kernel_curvature(kernel, dim, s) + (dim - 1) * kernel_slope(kernel, dim, s) / s) / pow(h, dim + 2);
}

static double volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 2 ? sqrt(dV) : dV, moment = 0; /* what x^2/2 gives on the lattice */
    if (o->volume == VOLUME_RAW) return dV;
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), across = p->dim == 2 ? reach : 0;
    for (int j = -across; j <= across; j++)
        for (int i = -reach; i <= reach; i++)
            if (i || j) moment += laplacian(o->kernel, p->dim, h, hypot(i, j) * spacing) * dV * i * i / 2;
    return dV / (moment * spacing * spacing);
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
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
    return correction_surrounds(nb, why);
}

static const struct scheme scheme = {
    .name = "kernel_second", .isotropic = 1, .sweeps = 1, .volume = volume, .weights = weights};

const struct method method_kernel_second = {
    .name = "kernel_second",
    .about = "the kernel's second derivative, sum_j V_j (T_j - T_i) lap W (Takeda et al. 1994)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " volume",
    .scheme = &scheme,
    .solve = particles_solve,
    .outline = particles_outline,
};
