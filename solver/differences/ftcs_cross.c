/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fluxes of a tensor K that is not diagonal.
 *
 *   face    ("asymmetric") the flux through a face along a has, beside K_aa (T_n - T_i)/d, K_ab times the derivative
 *           along b at the face, the mean of the central differences in its two cells
 *   corner  ("symmetric") grad T at a corner, along each axis the mean of the differences between the cells around
 *           it, gives K grad T there; its divergence is the adjoint of that gradient, so that heat never grows: the
 * mean over the corners of each face (Guenter, Yu, Krueger and Lackner 2005, section 3; Sharma and Hammett 2007,
 *           sections 2 and 3, who show that both leave the range of the data)
 *
 * With s = sin(xi dx/2) and c = cos(xi dx/2) by axis a wave decays at the rate 4/dx^2 times
 *
 *   face    sum of K_aa s_a^2 + sum over a != b of K_ab s_a c_a s_b c_b
 *   corner  w.K w, w_a = s_a times the c of the other axes: blind to the checkerboard
 *
 * Largest step.  K has no negative eigenvalue: K_ab^2 <= K_aa K_bb.  Face, in the plane: 2 K_ab s_a c_a s_b c_b <=
 * K_aa c_a^2 + K_bb c_b^2, so the rate is at most 4/dx^2 (K_aa + K_bb), as without K_ab; in space it is at most 9/8
 * of the trace, where K = b b^T, b along a diagonal, and each s^2 = 3/4.  Corner: sqrt(w.K w) <= sqrt(K_most) times
 * the sum of w, at most 1 in the plane, where it is sin((xi_x + xi_y) dx/2), and 2/sqrt(3) in space, where each s^2 =
 * 1/3.
 *
 *                 rate dx^2/4 at most                dt K_most/dx^2 at most, all K_aa equal
 *   plane         K_xx + K_yy; corner K_most         1/4; corner 1/2
 *   space         9/8 (K_xx + K_yy + K_zz);          4/27;
 *                 corner 4/3 K_most                  corner 3/8
 *
 * Restrictions: one material in a rectangle or a box with periodic sides. */
#include "solver/differences/ftcs.h"

/* m^2 s^-1 */
static double kappa_of(const struct ftcs_grid *g, int a, int b) {
    const struct problem *p = g->p;
    return (a == b ? p->material[0].k[a] : p->cross[problem_pair(a, b)]) / p->material[0].rho_c;
}

/* The ghosts of edges and corners: periodic images axis by axis, each over the ghosts of the axes before. */
static void close_corners(const struct ftcs_grid *g, double *T) {
    for (int a = 0; a < g->p->dim; a++) {
        int n[DIM_MAX], i[DIM_MAX] = {0};
        ptrdiff_t first = 0;
        for (int b = 0; b < DIM_MAX; b++) {
            const int ghosts = b < a ? g->reach : 0; /* of the axes before */
            n[b] = b == a ? 1 : g->n[b] + 2 * ghosts;
            first += (b < g->p->dim ? g->reach - ghosts : 0) * g->stride[b];
        }
        for (i[2] = 0; i[2] < n[2]; i[2]++)
            for (i[1] = 0; i[1] < n[1]; i[1]++)
                for (i[0] = 0; i[0] < n[0]; i[0]++) {
                    double *cell = T + first + i[0] * g->stride[0] + i[1] * g->stride[1] + i[2] * g->stride[2];
                    cell[-g->stride[a]] = cell[(g->n[a] - 1) * g->stride[a]];
                    cell[g->n[a] * g->stride[a]] = cell[0];
                }
    }
}

/* K s^-1: the fluxes of K_ab, a != b, through the faces of the cell at T.  Its own differences cancel. */
static double faces(const struct ftcs_grid *g, double K[][DIM_MAX], const double *T) {
    double sum = 0;
    for (int a = 0; a < g->p->dim; a++)
        for (int b = 0; b < g->p->dim; b++) {
            const ptrdiff_t s = g->stride[a], t = g->stride[b];
            if (a != b) sum += K[a][b] * ((T[s + t] - T[s - t]) - (T[t - s] - T[-s - t])) / (4 * g->d[a] * g->d[b]);
        }
    return sum;
}

/* K m s^-1: K grad T at the corners, by the lowest of the cells around each. */
static void corner_fluxes(const struct ftcs_grid *g, double K[][DIM_MAX], const double *T, const ptrdiff_t *around) {
    const int dim = g->p->dim, count = 1 << dim;
    int n[DIM_MAX], i[DIM_MAX] = {0};
    for (int a = 0; a < DIM_MAX; a++) n[a] = g->n[a] + (a < dim);
    for (i[2] = 0; i[2] < n[2]; i[2]++)
        for (i[1] = 0; i[1] < n[1]; i[1]++)
            for (i[0] = 0; i[0] < n[0]; i[0]++) {
                const ptrdiff_t at = ftcs_at(g, i) - around[count - 1];
                const double *low = T + at;
                double slope[DIM_MAX] = {0};
                for (int cell = 0; cell < count; cell++)
                    for (int a = 0; a < dim; a++) slope[a] += cell >> a & 1 ? low[around[cell]] : -low[around[cell]];
                for (int a = 0; a < dim; a++) {
                    double sum = 0;
                    for (int b = 0; b < dim; b++) sum += K[a][b] * slope[b] * 2 / (count * g->d[b]);
                    g->corner_flux[a][at] = sum;
                }
            }
}

/* K s^-1: the divergence of those of the cell `at`. */
static double corners(const struct ftcs_grid *g, ptrdiff_t at, const ptrdiff_t *around) {
    const int dim = g->p->dim, count = 1 << dim;
    double sum = 0;
    for (int a = 0; a < dim; a++) {
        const double *q = g->corner_flux[a] + at - around[count - 1];
        double out = 0;
        for (int k = 0; k < count; k++) out += k >> a & 1 ? q[around[k]] : -q[around[k]];
        sum += out * 2 / (count * g->d[a]);
    }
    return sum;
}

void ftcs_cross(const struct ftcs_grid *g, double *T) {
    const int dim = g->p->dim, corner = g->o->cross == CROSS_CORNER;
    double K[DIM_MAX][DIM_MAX], *rate = g->cross;
    ptrdiff_t around[1 << DIM_MAX] = {0}; /* offsets of the cells around a corner */
    int i[DIM_MAX] = {0};
    for (int k = 0; k < 1 << dim; k++)
        for (int a = 0; a < dim; a++) around[k] += (k >> a & 1) * g->stride[a];
    for (int k = 0; k < dim * dim; k++) K[k / dim][k % dim] = kappa_of(g, k / dim, k % dim);
    close_corners(g, T);
    if (corner) corner_fluxes(g, K, T, around);
    do *rate++ = corner ? corners(g, ftcs_at(g, i), around) : faces(g, K, T + ftcs_at(g, i));
    while (ftcs_next(g, i));
}
