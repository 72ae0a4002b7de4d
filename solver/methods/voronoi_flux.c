/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat fluxes through the faces of Voronoi cells (MacNeal 1953; Mishev 1998, Numer. Methods PDE 14:193):
 *   V_i rho_c dT_i/dt = sum_j A_ij/d_ij K_ij (T_j - T_i),   A_ij the face between the cells of i and j, V_i the cell.
 * With k_x != k_y cells, faces and distances are those of the metric x/sqrt(k_x), y/sqrt(k_y) (voronoi.h), and K =
 * sqrt(k_x k_y).  Between two materials K is that of the resistances in series along the line from i to j, and a cell
 * that the interface cuts has the heat capacity of its parts.
 *
 * Exact: for linear T, and for x^2 + y^2 in the metric, since sum_j A_ij d_ij = 2 d V_i; not for x^2 - y^2 and x y.
 * Kept: fluxes of a pair are equal and opposite to the bit, so heat is kept to rounding.  A_ij >= 0: the maximum
 * principle holds on every cloud, no mode grows, and all steps below 1/max(sum A K/(d V rho_c)) are stable; rates are
 * real.
 *
 * Order.  A_ij/d_ij are the entries of linear finite elements on the Delaunay triangles (the cotangent formula), with
 * the mass lumped into V_i.  Elements are of second order in T.  Lumping moves a cell's heat from its centroid to its
 * particle: int (x - x_i) dV = sum_j A_ij d_ij/3 ((x_j - x_i)/2 + t_ij), t_ij from the middle of the line to that of
 * the face.  The first part is opposite for the two of a pair and telescopes; the second is O(dx^3) a cell: on smooth
 * clouds (a lattice) O(dx^4), else of no sign.  N = dx^-2 cells of independent errors O(dx^3) make
 * sqrt(N) dx^3 = dx^2 in T: second order on every cloud for smooth T, in the largest error but for a logarithm; on a
 * rod, where t is zero, always.  A single Laplacian is wrong by O(1) at a particle: consistency of the rows is not
 * what the order comes from.
 * Two materials: exact for a steady flux across the interface, at any contrast.  A cut cell i gives the part of the
 * other material its own temperature: wrong by (l_i/k_i) q, q the flux, in a volume of O(dx^d), so a rod is of second
 * order with a constant that grows with the steeper side's dT/dx; on a lattice with the interface on faces no cell is
 * cut.  In the plane a pair across it conducts along the interface with the series' K too, where the face's parts
 * conduct side by side: wrong by O(1) in a layer dx wide, first order where T varies along the interface.
 * A start that jumps is averaged over the cells themselves (--sampling cell): the heat of both sides is then exact.
 *
 * Walls: a particle's mirror image is as far beyond the wall as it is in front, and their face is the cell's part of
 * the wall: fluxes through it are those of mirror ghosts, of second order for any side.  A round wall cuts the cells
 * there; a cell's part of it, an arc, conducts over the depth d of its particle, and flux, heat and the maximum
 * principle are kept as inside.  The flux to a held wall is that at d/2, wrong by k d/2 T_nn, which leaves d^2/2 T_nn
 * in T there; to a cooled wall b d^2/2 T_nn, and what a cell holds counts at its particle, not at its middle. Where
 * not: two materials of different k_x/k_y have no common metric. */
#include "solver/particles/particles.h"
#include "solver/space/voronoi.h"
#include "solver/space/voronoi_cell.h"

#include <math.h>

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)o;
    const struct material *m = p->material;
    if (p->materials == 2 && p->dim == 2 && m[0].k[0] * m[1].k[1] != m[0].k[1] * m[1].k[0])
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "voronoi_flux: k_y/k_x is %g in one material and %g in the other, and cells have one metric; "
                      "takes materials with the same k_y/k_x",
                      m[0].k[1] / m[0].k[0], m[1].k[1] / m[1].k[0]);
    return STATUS_OK;
}

/* A cell of a cloud with a particle in each dx x dx ends within the diagonal of one such cell in the metric; nothing
 * beyond twice that cuts it.  2 h is that much, and 6 % more. */
static double search(const struct problem *p) {
    double ratio = p->dim == 2 ? p->material[0].k[1] / p->material[0].k[0] : 1;
    return 1.06 * sqrt(1 + fmax(ratio, 1 / ratio));
}

static double conductivity(const struct material *m, int dim) {
    return dim == 2 ? sqrt(m->k[0] * m->k[1]) : m->k[0];
}

/* W m^-1 K^-1, between x and there: the same bits from either end. */
static double pair_conductivity(const struct problem *p, int dim, double x, double there) {
    int a = layout_material(p, x), b = layout_material(p, there);
    double ka = conductivity(&p->material[a], dim), kb = conductivity(&p->material[b], dim);
    if (a == b) return ka;
    double la = fabs(p->interface - x), lb = fabs(p->interface - there);
    return (la + lb) / (la / ka + lb / kb);
}

static int no_cell(const struct neighbourhood *nb, struct failure *why) {
    return refuse(why, STATUS_NUMERICAL,
                  "particle %zu at (%.6g, %.6g) m has %zu neighbours, which do not close its Voronoi cell", nb->i,
                  nb->x[0], nb->x[1], nb->n);
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[2],
                   struct failure *why) {
    (void)o;
    double scale[2], d[NEIGHBOURS_MAX][2], own[NEIGHBOURS_MAX], volume = nb->volume;
    const double *face = nb->face;
    voronoi_metric(&p->material[0], nb->dim, scale);
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < 2; a++) d[j][a] = nb->d[j][a] * scale[a];
    if (!face) { /* not of a mesh: a lattice */
        if (voronoi_cell(nb->dim, nb->n, d, own, &volume)) return no_cell(nb, why);
        face = own;
    }
    for (size_t j = 0; j < nb->n; j++) {
        double k = pair_conductivity(p, nb->dim, nb->x[0], nb->X ? nb->X[j] : nb->x[0] + nb->d[j][0]);
        double r = nb->dim == 2 ? sqrt(d[j][0] * d[j][0] + d[j][1] * d[j][1]) : fabs(d[j][0]);
        w[0][j] = face[j] * k / r / (volume * nb->rho_c);
    }
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "voronoi_flux",
                                     .two_materials = 1,
                                     .sweeps = 1,
                                     .cells = 1,
                                     .h = search,
                                     .check = check,
                                     .weights = weights};

const struct method method_voronoi_flux = {
    .name = "voronoi_flux",
    .about = "heat fluxes through the faces of Voronoi cells: keeps heat, second order on clouds",
    .accepts = "stepper layout jitter sweeps seed sampling angle walls",
    .scheme = &scheme,
    .solve = particles_solve,
};
