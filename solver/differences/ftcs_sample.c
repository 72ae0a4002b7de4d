/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Initial data of the finite differences: point values, or averages
 *
 *   T_i = int B((x - x_i)/dx) T(x, 0) dx / dx,   B the indicator of the cell, or the cubic B-spline (4 dx wide),
 *
 * as a tensor product in the plane and in space.  Averages restore second order for a jump at any place (Kreiss,
 * Thomee, Widlund 1970).  A cell of two materials starts at its heat divided by its heat capacity; the points are
 * then the centres of its two parts.  The quadrature is Gauss-Legendre with four points on each smooth piece.  It is
 * split at the knots of B, at the walls, at jumps of the data, at the images of the jumps, and at a plane of
 * symmetry, which is a wall if half of the domain is computed. */
#include "solver/differences/ftcs.h"

#include <math.h>

enum { GAUSS = 4, CUTS = 3 + 3 * JUMP_MAX, KNOTS = 5 + CUTS };

struct rule {
    int count;
    double at[GAUSS * KNOTS]; /* m */
    double weight[GAUSS * KNOTS];
};

/* The initial data, extended beyond a wall by its boundary condition: odd about a Dirichlet value, even about a
 * Neumann wall except for its slope; periodic sides go on at the opposite side.  Beyond a corner between different
 * sides it is the mean over them, independent of the order of the axes. */
static double continued(const struct problem *p, const double *x) {
    double sum = 0;
    int sides = 0;
    for (int s = 0; s < 2 * p->dim; s++) {
        int a = s / 2;
        double wall = s % 2 ? p->hi[a] : p->lo[a], outside = s % 2 ? x[a] - wall : wall - x[a];
        if (outside <= 0) continue;
        double foot[DIM_MAX] = {x[0], x[1], x[2]}, image[DIM_MAX] = {x[0], x[1], x[2]};
        foot[a] = wall;
        if (p->side[s] == PERIODIC) {
            image[a] = x[a] + (s % 2 ? p->lo[a] - p->hi[a] : p->hi[a] - p->lo[a]);
            return continued(p, image);
        }
        image[a] = 2 * wall - x[a];
        double value = p->wall(p, (enum side)s, foot, 0), inner = continued(p, image);
        if (p->side[s] == ROBIN) { /* k dT/dn = b (T_a - T), midway */
            double k = p->material[s == X_HI ? p->materials - 1 : 0].k[a];
            sum += inner + 2 * (value - inner) / (1 + k / (p->robin[s] * outside));
        } else
            sum += p->side[s] == DIRICHLET
                       ? 2 * value - inner
                       : inner + 2 * outside * value / p->material[s == X_HI ? p->materials - 1 : 0].k[a];
        sides++;
    }
    return sides ? sum / sides : p->initial(p, x);
}

static double bspline(double u) {
    double v = fmax(0, 2 - u);
    return u < 1 ? 2. / 3 - u * u + u * u * u / 2 : v * v * v / 6;
}

/* Inserts the cuts between knot[0] and knot[n-1] into the ascending knots; returns the new n. */
static int cut_in(double *knot, int n, const double *cut, int cuts) {
    for (int c = 0; c < cuts; c++) {
        if (!(cut[c] > knot[0] && cut[c] < knot[n - 1])) continue;
        int k = n++;
        for (; knot[k - 1] > cut[c]; k--) knot[k] = knot[k - 1];
        knot[k] = cut[c];
    }
    return n;
}

static void rule_make(struct rule *r, const struct problem *p, int a, double centre, double d, enum sampling how) {
    static const double node[GAUSS] = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                                       0.86113631159405258};
    static const double share[GAUSS] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                        0.17392742256872693};
    r->count = 1;
    r->at[0] = centre;
    r->weight[0] = 1;
    if (how == SAMPLING_POINT) return;

    int pieces = how == SAMPLING_SPLINE ? 4 : 1, cuts = 2;
    double knot[KNOTS], cut[CUTS] = {p->lo[a], p->hi[a]};
    for (int i = 0; i < p->jumps[a]; i++) {
        cut[cuts++] = p->jump[a][i];
        cut[cuts++] = 2 * p->lo[a] - p->jump[a][i];
        cut[cuts++] = 2 * p->hi[a] - p->jump[a][i];
    }
    if (p->mirror[a]) cut[cuts++] = (p->lo[a] + p->hi[a]) / 2;
    for (int c = 0; c < cuts; c++)
        cut[c] = (cut[c] - centre) / d; /* in units of d, so that the weights sum to 1 to the last digit */
    for (int k = 0; k <= pieces; k++) knot[k] = k - 0.5 * pieces;
    int knots = cut_in(knot, pieces + 1, cut, cuts);

    r->count = 0;
    for (int k = 0; k + 1 < knots; k++)
        for (int q = 0; q < GAUSS; q++, r->count++) {
            double length = knot[k + 1] - knot[k], u = knot[k] + 0.5 * (1 + node[q]) * length;
            r->at[r->count] = centre + u * d;
            r->weight[r->count] = share[q] * length * (pieces == 1 ? 1 : bspline(fabs(u)));
        }
}

static double average(const struct problem *p, const double *x, const double *d, enum sampling how) {
    struct rule rule[DIM_MAX];
    double sum = 0;
    for (int a = 0; a < DIM_MAX; a++)
        if (a < p->dim)
            rule_make(&rule[a], p, a, x[a], d[a], how);
        else
            rule_make(&rule[a], p, a, 0, 1, SAMPLING_POINT);
    for (int k = 0; k < rule[2].count; k++)
        for (int j = 0; j < rule[1].count; j++)
            for (int i = 0; i < rule[0].count; i++)
                sum += rule[2].weight[k] * rule[1].weight[j] * rule[0].weight[i] *
                       continued(p, (double[DIM_MAX]){rule[0].at[i], rule[1].at[j], rule[2].at[k]});
    return sum;
}

double ftcs_sample(const struct problem *p, const double *x, const double *d, enum sampling how) {
    double share[2], middle[2], heat = 0, at[DIM_MAX] = {x[0]}, width[DIM_MAX] = {d[0]};
    ftcs_face_parts(p, d[0], x[0], share, middle);
    if (share[0] == 1 || share[1] == 1) return average(p, x, d, how);
    for (int a = 1; a < p->dim; a++) at[a] = x[a], width[a] = d[a];
    for (int m = 0; m < 2; m++) {
        if (share[m] == 0) continue;
        at[0] = middle[m], width[0] = share[m] * d[0];
        heat += share[m] * p->material[m].rho_c * average(p, at, width, how);
    }
    return heat / ftcs_face_rho_c(p, d[0], x[0]);
}
