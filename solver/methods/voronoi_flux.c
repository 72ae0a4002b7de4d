/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat fluxes through the faces of Voronoi cells (MacNeal 1953; Mishev 1998, Numer. Methods PDE 14:193):
 *   V_i rho_c dT_i/dt = sum_j A_ij/d_ij K_ij (T_j - T_i),   A_ij the face between the cells of i and j, V_i the cell.
 * With k_x != k_y cells, faces and distances are those of the metric x/sqrt(k_x), y/sqrt(k_y) (voronoi.h), and
 * K = sqrt(k_x k_y).  Between two materials K follows from the resistances in series along the line from i to j, with
 * that of the contact, and a cell cut by the interface has the heat capacity of its parts.  With a contact resistance
 * T jumps within a cut cell, so each particle has the heat capacity of its own material up to the interface.
 *
 * Exact: for linear T, and for x^2 + y^2 in the metric, since sum_j A_ij d_ij = 2 d V_i; not for x^2 - y^2 and x y.
 * Conservation: the fluxes of a pair are equal and opposite to the bit, so heat is conserved to round-off.
 * A_ij >= 0: the maximum principle holds on every cloud, no mode grows, and all steps below 1/max(sum A K/(d V
 * rho_c)) are stable; the eigenvalues are real.
 *
 * Order: A_ij/d_ij are the entries of linear finite elements on the Delaunay triangles (the cotangent formula), with
 * the mass lumped into V_i.  The elements are second order in T.  Lumping moves the heat of a cell from its centroid
 * to its particle: int (x - x_i) dV = sum_j A_ij d_ij/3 ((x_j - x_i)/2 + t_ij), with t_ij from the middle of the
 * line to that of the face.  The first part has opposite signs for a pair and telescopes; the second is O(dx^3) per
 * cell: O(dx^4) on smooth clouds (a lattice), otherwise of random sign.  N = dx^-2 cells with independent errors
 * O(dx^3) add up to sqrt(N) dx^3 = dx^2 in T: second order on every cloud for smooth T, in the maximum norm up to a
 * logarithm; on a rod, where t is zero, always.  The error of a single Laplacian is O(1) at a particle: the order
 * does not follow from consistency of the rows.
 *
 * Two materials: exact for a steady flux across the interface at any contrast.  A cut cell i assigns its own
 * temperature to the part of the other material, with an error (l_i/k_i) q, q the flux, in a volume of O(dx^d).  A
 * rod is therefore second order with a constant that grows with dT/dx of the steeper side; on a lattice with the
 * interface on faces no cell is cut.  In the plane a pair across the interface also conducts along it with the
 * series K, although the parts of the face conduct in parallel: an O(1) error in a layer dx wide, first order if T
 * varies along the interface.  Initial data with a jump are averaged over the cells themselves (--sampling cell), so
 * the heat of both sides is exact.
 *
 * Walls: a particle's mirror image is at the same distance behind the wall, and their common face is the cell's part
 * of the wall.  The fluxes through it are those of mirror ghosts, second order for any boundary condition.  A round
 * wall cuts the cells; the cell's part of it, an arc, conducts over the depth d of its particle, with flux, heat and
 * maximum principle as inside.  The flux to a Dirichlet wall is that at d/2, with an error k d/2 T_nn, which leaves
 * d^2/2 T_nn in T there; at a cooled wall it is b d^2/2 T_nn, and the heat of a cell is assigned to its particle,
 * not its centroid.
 *
 * Restrictions: two materials need the same k_x/k_y, for a common metric. */
#include "solver/particles/particles.h"
#include "solver/space/voronoi.h"

#include <math.h>

static int check(const struct problem *p, const struct options *o, struct failure *why) {
    (void)o;
    const struct material *m = p->material;
    if (p->materials == 2 && p->dim == 2 && m[0].k[0] * m[1].k[1] != m[0].k[1] * m[1].k[0])
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "voronoi_flux: k_y/k_x is %g in one material and %g in the other, but cells have one metric; "
                      "use materials with the same k_y/k_x",
                      m[0].k[1] / m[0].k[0], m[1].k[1] / m[1].k[0]);
    return STATUS_OK;
}

/* With a particle in each dx x dx square, a cell ends within the diagonal of one such square in the metric, and
 * nothing beyond twice that cuts it. 2 h is this distance plus 6 %. */
static double cell_search_h(const struct problem *p) {
    double ratio = p->dim == 2 ? p->material[0].k[1] / p->material[0].k[0] : 1;
    return 1.06 * sqrt(1 + fmax(ratio, 1 / ratio));
}

static double conductivity(const struct material *m, int dim) {
    return dim == 2 ? sqrt(m->k[0] * m->k[1]) : m->k[0];
}

/* W m^-1 K^-1, between x and there: the same bits from both ends. */
static double pair_conductivity(const struct problem *p, int dim, double x, double there) {
    int a = layout_material(p, x), b = layout_material(p, there);
    double ka = conductivity(&p->material[a], dim), kb = conductivity(&p->material[b], dim);
    if (a == b) return ka;
    double la = fabs(p->interface - x), lb = fabs(p->interface - there);
    return (la + lb) / (la / ka + lb / kb + p->resistance);
}

static int no_cell(const struct neighbourhood *nb, struct failure *why) {
    return refuse(why, STATUS_NUMERICAL,
                  "particle %zu at (%.6g, %.6g) m has %zu neighbours, which do not close its Voronoi cell", nb->i,
                  nb->x[0], nb->x[1], nb->n);
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    (void)o;
    double scale[2], d[NEIGHBOURS_MAX][2], own[NEIGHBOURS_MAX], volume = nb->volume;
    const double *face = nb->face;
    voronoi_metric(&p->material[0], nb->dim, scale);
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < 2; a++) d[j][a] = nb->d[j][a] * scale[a];
    if (!face) { /* on a lattice, without a mesh */
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
                                     .h = cell_search_h,
                                     .check = check,
                                     .weights = weights};

const struct method method_voronoi_flux = {
    .name = "voronoi_flux",
    .about = "heat fluxes through the faces of Voronoi cells: conserves heat, second order on clouds",
    .accepts = "stepper layout jitter sweeps seed sampling angle walls",
    .scheme = &scheme,
    .solve = particles_solve,
};
