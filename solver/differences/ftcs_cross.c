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
 * 1/3.  In the plane |w_x| + |w_y| <= 1 makes the largest K_aa the bound: `limit ftcs --cross corner --field ANGLE`.
 *
 *                 rate dx^2/4 at most                dt K_most/dx^2 at most, all K_aa equal
 *   plane         K_xx + K_yy; corner K_most         1/4; corner 1/2
 *   space         9/8 (K_xx + K_yy + K_zz);          4/27;
 *                 corner 4/3 K_most                  corner 3/8
 *
 * K that varies is that of the faces, or of the corners.  With k_par along b and T constant along b, data of the wave
 * number q across b at the angle theta decay, where they should stay, at the rate k_par/rho_c times
 *
 *   face    q^4 dx^2/16 sin^2(2 theta)
 *   corner  q^6 dx^4/2304 sin^2(4 theta)
 *
 * from the two formulas above: fluxes at corners leak at fourth order.
 *
 * Beyond a held wall T is 2 T_wall - T at the mirror image: of second order whatever K, since T is uniform along the
 * wall.  Steps of a K that varies are those of the largest K.
 *
 * Insulated wall across x: n.K grad T = 0 makes T_x = -(K_xy/K_xx) T_y on it.  No flux passes, that of K_xy included.
 * A face across y beside the wall takes this T_x, with its own T_y, as one of the two that its cells average; a
 * corner on the wall is left with (K_yy - K_xy^2/K_xx) T_y along it.  Both minimize the sum of g.K g over the T_x on
 * the wall, g the two differences that meet in a corner of a cell, or the means at a corner: heat does not grow.  T_y
 * half a cell away from the wall makes the flux along it wrong by dx in one row of cells, a source of dx^2: second
 * order.
 *
 * The error is dx^2 w.  w has the equation of T, with the source
 *
 *   face    (K_xx T_xxxx + K_yy T_yyyy)/12 + K_xy (T_xxxy + T_xyyy)/3
 *   corner  that and (K_xx + K_yy) T_xxyy/4
 *
 * w = -T_xx/8 on a held wall across x, and on an insulated one K_xx w_x + K_xy w_y is minus
 *
 *   face    K_xx T_xxx/24 + K_xy (T_xxy/8 + T_yyy/6) - K_xy^2/K_xx T_xyy/4
 *   corner  K_xx T_xxx/24 + K_xy (T_xxy/8 + T_yyy/6) + (K_xx + K_yy - K_xy^2/K_xx) T_xyy/4
 *
 * The scene `oblique` with its defaults leaves E1 = 0.454 dx^2 by faces and 0.593 dx^2 by corners.
 *
 * Restrictions: one material in a rectangle or a box with periodic or uniform held sides; insulated ones in the
 * plane, beside a constant K. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

/* ---- K ---- */

static double *reserve(struct ftcs_grid *g, size_t count) {
    g->held += count;
    return xcalloc(count, sizeof(double));
}

/* Loops over the cells and the first ones beyond the upper ends of the axes in `more`; 0 at the end. */
static int next(const struct ftcs_grid *g, unsigned more, int i[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) {
        if (++i[a] < g->n[a] + (int)(more >> a & 1)) return 1;
        i[a] = 0;
    }
    return 0;
}

/* Row a of K, at the lower face of each cell along a, or at its lower corner. */
static void make_row(struct ftcs_grid *g, int a) {
    const struct problem *p = g->p;
    const int corner = g->o->cross == CROSS_CORNER;
    const unsigned all = (1u << p->dim) - 1, more = corner ? all : 1u << a;
    int i[DIM_MAX] = {0};
    for (int b = 0; b < p->dim; b++) g->K[a][b] = reserve(g, g->size);
    do {
        double x[DIM_MAX], K[DIM_MAX][DIM_MAX];
        for (int b = 0; b < DIM_MAX; b++) x[b] = g->first[b] + (i[b] - (more >> b & 1) / 2.) * g->d[b];
        problem_tensor(p, x, K);
        for (int b = 0; b < p->dim; b++) g->K[a][b][ftcs_at(g, i)] = K[a][b] / g->rho_c;
    } while (next(g, more, i));
}

void ftcs_cross_make(struct ftcs_grid *g) {
    g->cross = reserve(g, (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2]);
    for (int a = 0; a < g->p->dim; a++) g->flux[a] = reserve(g, g->size);
    for (int a = 0; a < g->p->dim && g->p->direction; a++) make_row(g, a);
    for (int s = 0; s < SIDES && !g->p->is_even; s++) g->insulated |= (unsigned)(g->p->side[s] == NEUMANN) << s;
}

/* ---- Ghosts ---- */

static int inside(int i, int n) {
    return i < 0 ? 0 : i < n ? i : n - 1;
}

/* The ghosts of edges and corners: images axis by axis, each of the ghosts of the axes before too.  A held side is
 * uniform beyond its ends. */
static void close_corners(const struct ftcs_grid *g, double *T) {
    static const int others[DIM_MAX][2] = {{1, 2}, {0, 2}, {0, 1}};
    for (int s = 0; s < 2 * g->p->dim; s++) {
        const struct ftcs_side *e = &g->side[s];
        const int more[2] = {others[s / 2][0] < s / 2, others[s / 2][1] < s / 2};
        for (int j = -more[1]; j < e->n[1] + more[1]; j++)
            for (int i = -more[0]; i < e->n[0] + more[0]; i++) {
                const int place = inside(i, e->n[0]) + inside(j, e->n[1]) * e->n[0];
                const ptrdiff_t at = i * e->step[0] + j * e->step[1];
                T[e->ghost[0] + at] = e->sign[place] * T[e->mirror[0] + at] + e->offset[place];
            }
    }
}

/* ---- Fluxes ---- */

/* K m^-1: the derivatives at the lower face along a of the cell at T. */
static void face_slopes(const struct ftcs_grid *g, int a, const double *T, double slope[DIM_MAX]) {
    const ptrdiff_t s = g->stride[a];
    for (int b = 0; b < g->p->dim; b++) {
        const ptrdiff_t t = g->stride[b];
        slope[b] = a == b ? (T[0] - T[-s]) / g->d[a] : ((T[t] - T[-t]) + (T[t - s] - T[-t - s])) / (4 * g->d[b]);
    }
}

/* K m^-1: the derivatives at the lower corner of the cell at T. */
static void corner_slopes(const struct ftcs_grid *g, const ptrdiff_t *around, const double *T,
                          double slope[DIM_MAX]) {
    const int dim = g->p->dim, count = 1 << dim;
    const double *low = T - around[count - 1];
    for (int a = 0; a < dim; a++) {
        slope[a] = 0;
        for (int k = 0; k < count; k++) slope[a] += k >> a & 1 ? low[around[k]] : -low[around[k]];
        slope[a] *= 2 / (count * g->d[a]);
    }
}

/* 1 if i is 0 or `last` along a, and an insulated wall is there. */
static int is_insulated(const struct ftcs_grid *g, int a, int i, int last) {
    return (i == 0 && g->insulated >> 2 * a & 1) || (i == last && g->insulated >> (2 * a + 1) & 1);
}

/* Adds T_a of an insulated wall in the plane, which even images lack: half of it where the slope is the mean of the
 * wall and another face. */
static void insulate(double K[DIM_MAX][DIM_MAX], int a, double part, double slope[DIM_MAX]) {
    slope[a] -= part * K[0][1] / K[a][a] * slope[1 - a];
}

/* Component a of K grad T, K m s^-1; `constant`, m^2 s^-1, unless K varies. */
static double along(const struct ftcs_grid *g, double constant[DIM_MAX][DIM_MAX], int a, ptrdiff_t at,
                    const double slope[DIM_MAX]) {
    double sum = 0;
    for (int b = 0; b < g->p->dim; b++) sum += (g->K[a][b] ? g->K[a][b][at] : constant[a][b]) * slope[b];
    return sum;
}

/* Those at the lower corners: all components of one slope. */
static void corner_fluxes(const struct ftcs_grid *g, double constant[DIM_MAX][DIM_MAX], const ptrdiff_t *around,
                          const double *T) {
    double slope[DIM_MAX];
    int i[DIM_MAX] = {0};
    do {
        const ptrdiff_t at = ftcs_at(g, i);
        corner_slopes(g, around, T + at, slope);
        for (int a = 0; a < g->p->dim && g->insulated; a++)
            if (is_insulated(g, a, i[a], g->n[a])) insulate(constant, a, 1, slope);
        for (int a = 0; a < g->p->dim; a++) g->flux[a][at] = along(g, constant, a, at, slope);
    } while (next(g, (1u << g->p->dim) - 1, i));
}

/* That through the lower faces along a. */
static void face_fluxes(const struct ftcs_grid *g, double constant[DIM_MAX][DIM_MAX], int a, const double *T) {
    double slope[DIM_MAX];
    int i[DIM_MAX] = {0};
    do {
        const ptrdiff_t at = ftcs_at(g, i);
        face_slopes(g, a, T + at, slope);
        for (int k = 1; k <= g->p->dim && g->insulated; k++) { /* a wall that the face is on comes last */
            const int b = (a + k) % g->p->dim, on = a == b;
            if (is_insulated(g, b, i[b], g->n[b] - !on)) insulate(constant, b, on ? 1 : 0.5, slope);
        }
        g->flux[a][at] = along(g, constant, a, at, slope);
    } while (next(g, 1u << a, i));
}

static void fluxes(const struct ftcs_grid *g, const ptrdiff_t *around, const double *T) {
    const struct problem *p = g->p;
    double constant[DIM_MAX][DIM_MAX] = {{0}};
    if (!p->direction) problem_tensor(p, p->lo, constant);
    for (int a = 0; a < DIM_MAX; a++)
        for (int b = 0; b < DIM_MAX; b++) constant[a][b] /= g->rho_c;
    if (g->o->cross == CROSS_CORNER) corner_fluxes(g, constant, around, T);
    for (int a = 0; a < p->dim && g->o->cross == CROSS_FACE; a++) face_fluxes(g, constant, a, T);
}

/* K s^-1: the divergence of the fluxes around the cell `at`. */
static double divergence(const struct ftcs_grid *g, ptrdiff_t at, const ptrdiff_t *around) {
    const int dim = g->p->dim, count = 1 << dim;
    double sum = 0;
    for (int a = 0; a < dim; a++) {
        const double *q = g->flux[a] + at;
        double out = 0;
        for (int k = 0; k < count; k++) out += k >> a & 1 ? q[around[k]] : -q[around[k]];
        sum += g->o->cross == CROSS_CORNER ? out * 2 / (count * g->d[a]) : (q[g->stride[a]] - q[0]) / g->d[a];
    }
    return sum;
}

void ftcs_cross(const struct ftcs_grid *g, double *T) {
    ptrdiff_t around[1 << DIM_MAX] = {0}; /* offsets of the cells around a corner */
    double *rate = g->cross;
    int i[DIM_MAX] = {0};
    for (int k = 0; k < 1 << g->p->dim; k++)
        for (int a = 0; a < g->p->dim; a++) around[k] += (k >> a & 1) * g->stride[a];
    close_corners(g, T);
    fluxes(g, around, T);
    do *rate++ = divergence(g, ftcs_at(g, i), around);
    while (ftcs_next(g, i));
}
