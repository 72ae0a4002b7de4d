/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brookshaw's operator with Cleary & Monaghan's conductivity (Pamplona eq. 13):
 *   rho_c dT_i/dt = sum_j V k_ij (T_i - T_j) F_ij,   F_ij = (dW/dr) r / (r^2 + eta^2),   eta = 0.1 h.
 * k_ij is 4 k_i k_j / (k_i + k_j) (harmonic), k_i + k_j (arithmetic), or twice the conductance of the line between
 * the particles, 2 r / sum(l / k) (series: exact for every pair across a plane interface).  Pair fluxes are equal
 * and opposite, so heat is conserved on any layout.  On a lattice rho_c is the average over the particle's cell.
 * The cells then have the heat of both materials, and a rod is second order for any interface position.  A contact
 * resistance is one more term of the line (series); the first particle on either side of it then has the heat of its
 * own material up to the interface (layout_part).
 *
 * Where T varies along a contact, brookshaw is of first order in the limit.  A pair that crosses the contact
 * obliquely conducts along it too by the series mean, on average k_1 k_2 ln(k_1/k_2) / (k_1 - k_2) over the points
 * where pairs cross, in place of (k_1 + k_2)/2.  A layer of width O(dx) then conducts too little along the contact,
 * which is an error of O(dx) in T.  It shows late: plane-contact has slopes of 1.71, 1.67, 1.52 and 1.36 down to dx =
 * 1/160, and 2.00 with k_1 = k_2.  contact_ssph, which expands T on either side, has no such layer.
 *
 * The volume V: raw, dx^d; tuned, Pamplona eq. 14, V = area xi / N with N including the ghosts; moment, the V for
 * which the operator is exact for x^2, y^2 and z^2 on the lattice, sum_j w_j x_j^2 = 2 kappa.
 *
 * A tensor (Espanol & Revenga 2003; Biriukov & Price 2019): (dim + 2) e.K e - tr K in place of 2 k, e along the pair.
 * That is K only where directions are even: sum F x^4/r^2 = 3 sum F x^2 y^2/r^2.  On a square lattice, with the ratio
 * m of the two sums, k_y has the part (3 - m)/(2 m + 2) of k_x, below 0 for m > 3, and k_xy the factor 4/(m + 1), so
 * that it has no order; it is here for `limit METHOD --field ANGLE`.  Pairs across b have negative weights for k_perp
 * < k_par/3.  With b along an axis all waves across it grow for
 *
 *     k_perp/k_par < (m - 3)/(3 m - 1) = 0.113, 0.088, 0.028, 0.011 at h/dx = 1.1, 1.2, 1.5, 2;
 *
 * at 15 degrees 0.065, 0.047, 0.007 and none; at 30 and 45 degrees none grows.
 *
 * Weights of an isotropic K are >= 0, so on a cloud the solution is bounded if every particle has a neighbour.  A
 * diagonal K is isotropic, because F depends on the distance only. */
#include "solver/particles/correction.h"
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>

/* -(dW/dr) r / (r^2 + eta^2), m^-(dim + 2), of a kernel of smoothing length h at distance r */
static double pair_weight(enum kernel_name kernel, int dim, double h, double r) {
    double eta = 0.1 * h;
    return -kernel_slope(kernel, dim, r / h) / pow(h, dim + 1) * r / (r * r + eta * eta);
}

static double volume(const struct problem *p, const struct options *o, double h, double dV) {
    double spacing = p->dim == 3 ? cbrt(dV) : p->dim == 2 ? sqrt(dV) : dV;
    if (o->volume == VOLUME_RAW) return dV;
    if (o->volume == VOLUME_MOMENT)
        return dV / correction_lattice_sum(o->kernel, p->dim, h / spacing, 1, 1, pair_weight);
    double xi = o->xi > 0 ? o->xi : 9 * cbrt(h), all = 1, real = 1; /* Pamplona eq. 18 */
    double layers = floor(KERNEL_SUPPORT * h / spacing);
    const struct problem *plate =
        p->whole ? p->whole : p; /* N is that of the whole plate, even if only a part is computed */
    for (int a = 0; a < p->dim; a++) {
        double n = round((plate->hi[a] - plate->lo[a]) / spacing);
        real *= n;
        all *= n + 2 * layers;
    }
    return dV * xi * real / all;
}

/* Twice the conductivity between particle i at x and the point x + d, W m^-1 K^-1. */
static double mean_conductivity(const struct problem *p, enum mean mean, double x, double d) {
    int here = layout_material(p, x), there = layout_material(p, x + d);
    double ki = p->material[here].k[0], kj = p->material[there].k[0];
    if (here == there) return 2 * ki;
    if (mean == MEAN_ARITHMETIC) return ki + kj;
    if (mean != MEAN_SERIES && p->resistance == 0) return 4 * ki * kj / (ki + kj);
    double part = (p->interface - x) / d; /* fraction of the line on this side */
    return 2 / (part / ki + (1 - part) / kj + p->resistance / fabs(d));
}

/* Twice the conductivity of a tensor along d, W m^-1 K^-1. */
static double pair_tensor(const struct problem *p, const double *x, int dim, const double *d) {
    double K[DIM_MAX][DIM_MAX], along = 0, square = 0, trace = 0;
    problem_tensor(p, x, K);
    for (int a = 0; a < dim; a++) {
        for (int b = 0; b < dim; b++) along += K[a][b] * d[a] * d[b];
        square += d[a] * d[a], trace += K[a][a];
    }
    return (dim + 2) * along / square - trace;
}

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)o;
    if (!problem_has_cross(p) || (!p->direction && p->side[X_LO] == PERIODIC)) return STATUS_OK;
    return refuse(why, STATUS_NOT_APPLICABLE,
                  "brookshaw: takes k_xy where it is constant and sides are periodic, without an order; use so_ssph");
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    char place[PLACE_TEXT];
    if (nb->n == 0)
        return refuse(why, STATUS_NUMERICAL,
                      "particle %zu at %s has 0 neighbours and receives no heat; use a larger --h", nb->i,
                      problem_place(nb->dim, nb->x, place));
    for (size_t j = 0; j < nb->n; j++) {
        double F = pair_weight(o->kernel, nb->dim, nb->h, neighbourhood_distance(nb, j));
        double k = problem_has_cross(p) ? pair_tensor(p, nb->x, nb->dim, nb->d[j])
                                        : mean_conductivity(p, o->mean, nb->x[0], nb->d[j][0]);
        w[0][j] = nb->volume * k * F / nb->rho_c;
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "brookshaw",
                                     .two_materials = 1,
                                     .isotropic = 1,
                                     .tensor = 1,
                                     .tuned = 1,
                                     .sweeps = 1,
                                     .check = check,
                                     .volume = volume,
                                     .weights = weights};

const struct method method_brookshaw = {
    .name = "brookshaw",
    .about = "Brookshaw's pair operator with Cleary & Monaghan's conductivity (Pamplona eq. 13)",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS " mean volume xi",
    .scheme = &scheme,
    .solve = particles_solve,
};
