/* Sampling of the initial data: point, cell or spline (Kreiss, Thomee & Widlund 1970).
 *
 * The average with the B-spline B_m of order m is the integral of T0(x + u dx) B_m(u) over |u| < m/2.  B_m is a
 * polynomial of degree m - 1 between its knots.  Where walls, planes of jumps or their images meet its support, T0 is
 * cut there too, and on each piece Gauss-Legendre with 3 points is exact for degree 5: for quadratic data under a
 * cubic spline.  Elsewhere two points (cell) or three (spline) have its moments up to the third: the average is then
 * met to O(dx^4), and its variance, which is what the start of a matched run counts on, exactly. */
#include "solver/sample.h"

#include <math.h>

enum { GAUSS = 3, PLANES_MAX = 2 + 3 * JUMP_MAX, PIECES_MAX = 4 + PLANES_MAX, NODES_MAX = GAUSS * PIECES_MAX };

static const double gauss_node[GAUSS] = {-0.77459666924148337704, 0, 0.77459666924148337704};
static const double gauss_weight[GAUSS] = {5.0 / 9, 8.0 / 9, 5.0 / 9};

static double b_spline(int m, double u) {
    u = fabs(u);
    if (m == 1) return u < 0.5 ? 1 : 0;
    return u < 1 ? 2.0 / 3 - u * u * (1 - u / 2) : u < 2 ? (2 - u) * (2 - u) * (2 - u) / 6 : 0;
}

/* T0, continued beyond the walls: T0(x) = sign T0(image) + offset. */
static double continued(const struct problem *p, double x, double y) {
    double at[2] = {x, y};
    for (int s = 0; s < 2 * p->dim; s++) {
        int a = s / 2;
        double wall = s % 2 ? p->hi[a] : p->lo[a], beyond = s % 2 ? at[a] - wall : wall - at[a];
        if (beyond <= 0) continue;
        double image[2] = {at[0], at[1]}, foot[2] = {at[0], at[1]};
        image[a] = 2 * wall - at[a], foot[a] = wall;
        double value = p->wall(p, (enum side)s, foot), inside = continued(p, image[0], image[1]);
        if (p->side[s] == DIRICHLET) return 2 * value - inside;
        return inside + value * 2 * beyond / p->material[p->materials == 2 && foot[0] >= p->interface].k[a];
    }
    return p->initial(p, at);
}

static int jumps_inside(double lo, double hi, int jumps, const double *jump) {
    int inside = 0;
    for (int k = 0; k < jumps; k++) inside |= jump[k] > lo && jump[k] < hi;
    return inside;
}

/* Where the data are smooth: few nodes with the moments of the spline up to the third. */
static int smooth_rule(int m, double x, double dx, double *node, double *weight) {
    int n = m == 1 ? 2 : 3;
    double apart = m == 1 ? 1 / sqrt(3) : 1;
    for (int k = 0; k < n; k++) {
        node[k] = x + (k - (n - 1) / 2.0) * apart * dx;
        weight[k] = m == 1 ? 0.5 : k == 1 ? 2.0 / 3 : 1.0 / 6;
    }
    return n;
}

/* Quadrature nodes (m) and weights of the average about x along one axis; returns how many. */
static int axis_rule(int m, double x, double dx, int jumps, const double *jump, double *node, double *weight) {
    double knot[PIECES_MAX + 1];
    int knots = 0;
    for (int k = 0; k <= m; k++) knot[knots++] = x + (k - m / 2.0) * dx;
    if (!jumps_inside(knot[0], knot[m], jumps, jump)) return smooth_rule(m, x, dx, node, weight);
    for (int k = 0; k < jumps; k++) { /* insert, ascending */
        if (jump[k] <= knot[0] || jump[k] >= knot[knots - 1]) continue;
        int at = knots++;
        for (; knot[at - 1] > jump[k]; at--) knot[at] = knot[at - 1];
        knot[at] = jump[k];
    }
    int n = 0;
    for (int k = 0; k + 1 < knots; k++)
        for (int g = 0; g < GAUSS; g++, n++) {
            double half = (knot[k + 1] - knot[k]) / 2;
            node[n] = knot[k] + half * (1 + gauss_node[g]);
            weight[n] = half / dx * gauss_weight[g] * b_spline(m, (node[n] - x) / dx);
        }
    return n;
}

/* Planes along one axis where the continued data may jump: walls of given temperature, which data need not agree
 * with, the problem's own and their images; returns how many. */
static int jump_planes(const struct problem *p, int axis, double *plane) {
    int n = 0;
    for (int hi = 0; hi < 2; hi++)
        if (p->side[2 * axis + hi] == DIRICHLET) plane[n++] = hi ? p->hi[axis] : p->lo[axis];
    for (int k = 0; k < p->jumps[axis]; k++) {
        double own = p->jump[axis][k];
        plane[n++] = own;
        for (int hi = 0; hi < 2; hi++) plane[n++] = 2 * (hi ? p->hi[axis] : p->lo[axis]) - own;
    }
    return n;
}

double sample_initial(const struct problem *p, enum sampling sampling, const double dx[2], const double x[2]) {
    if (sampling == SAMPLING_POINT) return p->initial(p, x);
    int m = sampling == SAMPLING_CELL ? 1 : 4;
    double node[2][NODES_MAX] = {{0}}, weight[2][NODES_MAX] = {{0}, {1}};
    int n[2] = {0, 1};
    for (int a = 0; a < p->dim; a++) {
        double plane[PLANES_MAX];
        int planes = jump_planes(p, a, plane);
        n[a] = axis_rule(m, x[a], dx[a], planes, plane, node[a], weight[a]);
    }
    double sum = 0;
    for (int j = 0; j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) sum += weight[0][i] * weight[1][j] * continued(p, node[0][i], node[1][j]);
    return sum;
}
