/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sampling of the initial data: point, cell or spline (Kreiss, Thomee & Widlund 1970).
 *
 * The average with the B-spline B_m of order m is the integral of T0(x + u dx) B_m(u) over |u| < m/2.  B_m is a
 * polynomial of degree m - 1 between its knots.  If walls, planes of jumps or their images cut its support, T0 is
 * split there too, and Gauss-Legendre with 2 points on each piece is exact for degree 3: for constants under a cubic
 * spline.  For varying data the quadrature errors of adjacent particles cancel: sum_i x_i^k B_m(x - x_i) is a
 * polynomial of degree k < m, so the sums over particles of T_i and x_i T_i are exact for quadratic data, and the
 * remaining error is a quadrupole of O(dx^4).  Elsewhere two points (cell) or three (spline) have the moments of the
 * spline up to the third.  The average then has an error of O(dx^4) and the exact variance, which the matched run
 * requires.
 *
 * Adjacent particles on a lattice share knots and the nodes between them.  T0 is evaluated once at each pair of a
 * node along x and a node along y, and its values are summed along x, then along y. */
#include "solver/space/sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GAUSS = 2, SMOOTH = 3, PLANES_MAX = 2 + 3 * JUMP_MAX }; /* nodes per piece; nodes of a smooth average */

static const double gauss_node[GAUSS] = {-0.57735026918962576451, 0.57735026918962576451};
static const double gauss_weight[GAUSS] = {1, 1};

static double b_spline(int m, double u) {
    u = fabs(u);
    if (m == 1) return u < 0.5 ? 1 : 0;
    return u < 1 ? 2.0 / 3 - u * u * (1 - u / 2) : u < 2 ? (2 - u) * (2 - u) * (2 - u) / 6 : 0;
}

static double continued(const struct problem *p, const double *x);

/* T0 beyond side s: T0(x) = sign T0(image) + offset, or that of the opposite side where they are periodic. */
static double reflected(const struct problem *p, enum side s, const double *x) {
    int a = (int)s / 2;
    double image[DIM_MAX] = {0}, foot[DIM_MAX] = {0};
    for (int d = 0; d < p->dim; d++) image[d] = foot[d] = x[d];
    double wall = s % 2 ? p->hi[a] : p->lo[a], beyond = fabs(x[a] - wall), period = p->hi[a] - p->lo[a];
    image[a] = p->side[s] == PERIODIC ? (s % 2 ? x[a] - period : x[a] + period) : 2 * wall - x[a];
    double inside = continued(p, image);
    if (p->side[s] == PERIODIC) return inside;
    foot[a] = wall;
    double value = p->wall(p, s, foot, 0);
    if (p->side[s] == DIRICHLET) return 2 * value - inside;
    if (problem_law(p, (int)s)->exchange) {
        double ratio = problem_transfer(p, (int)s) * beyond / p->material[layout_material(p, foot[0])].k[a];
        return inside + 2 / (1 + 1 / ratio) * (value - inside); /* also for a ratio of 0 or with overflow */
    }
    return inside + value * 2 * beyond / p->material[layout_material(p, foot[0])].k[a];
}

static inline int is_outside(const struct problem *p, int axis, double x) {
    return x < p->lo[axis] || x > p->hi[axis];
}

/* T0, extended beyond the walls; beyond an edge or a corner, between possibly different sides, the mean of all
 * orders, as for ghosts. */
static double continued(const struct problem *p, const double *x) {
    double sum = 0;
    int sides = 0;
    for (int a = 0; a < p->dim; a++) {
        if (!is_outside(p, a, x[a])) continue;
        sum += reflected(p, (enum side)(2 * a + (x[a] > p->hi[a])), x);
        sides++;
    }
    return sides ? sum / sides : p->initial(p, x);
}

/* The odd extension of data that match a wall's value is smooth up to a jump of the second derivative.  Averages
 * then have an error of O(dx^2) in the layer next to the wall, which cancels this jump except for a dipole of
 * O(dx^4). */
int sample_meets_wall(const struct problem *p, const struct lattice *l, enum side s) {
    int axis = (int)s / 2, along = axis == 0, across = axis == 2 ? 1 : 2;
    for (int line = 0; line < l->n[along] * l->n[across]; line++) {
        int at[DIM_MAX] = {0};
        double foot[DIM_MAX];
        at[along] = line % l->n[along], at[across] = line / l->n[along];
        layout_position(l, at[0], at[1], at[2], foot);
        foot[axis] = s % 2 ? p->hi[axis] : p->lo[axis];
        double start = p->initial(p, foot), value = p->wall(p, s, foot, 0), size = fabs(start) + fabs(value);
        for (int part = 1; part < 4; part++) { /* values at the quarters give the scale for round-off */
            double x[DIM_MAX] = {0};
            memcpy(x, foot, (size_t)l->dim * sizeof *x);
            x[axis] = p->lo[axis] + part / 4.0 * (p->hi[axis] - p->lo[axis]);
            size = fmax(size, fabs(p->initial(p, x)));
        }
        if (fabs(start - value) > 1e-9 * size) return 0;
    }
    return 1;
}

/* Planes normal to an axis at which the extended data may jump: walls at another temperature, jumps of the problem
 * and their images.  Returns their number. */
static int jump_planes(const struct problem *p, const struct lattice *l, int axis, double *plane) {
    int n = 0;
    for (int hi = 0; hi < 2; hi++)
        if (p->side[2 * axis + hi] == DIRICHLET && !sample_meets_wall(p, l, (enum side)(2 * axis + hi)))
            plane[n++] = hi ? p->hi[axis] : p->lo[axis];
    for (int k = 0; k < p->jumps[axis]; k++) {
        double own = p->jump[axis][k];
        plane[n++] = own;
        for (int hi = 0; hi < 2; hi++) plane[n++] = 2 * (hi ? p->hi[axis] : p->lo[axis]) - own;
    }
    return n;
}

/* One axis of a lattice: particles x_i = first + i dx, knots first + (q - m/2) dx; particle i has the knots q = i to
 * i + m. */
struct axis {
    int m, n, planes;
    double first, dx, plane[PLANES_MAX];
};

static double knot(const struct axis *a, int q) {
    return a->first + (q - a->m / 2.0) * a->dx;
}

static int is_cut(const struct axis *a, int i) {
    int inside = 0;
    double lo = knot(a, i), hi = knot(a, i + a->m);
    for (int k = 0; k < a->planes; k++) inside |= a->plane[k] > lo && a->plane[k] < hi;
    return inside;
}

/* The average about particle i is sum_k weight[begin[i] + k] T0(node[first[i] + k]), begin[i] + k < begin[i + 1]. */
struct rule {
    size_t nodes;
    double *node, *weight;
    size_t *first, *begin;
};

/* Nodes between knots q and q + 1, split at planes. share[k] is the quadrature weight of node k without the
 * spline. */
static void add_cell(const struct axis *a, int q, struct rule *r, double *share) {
    double edge[PLANES_MAX + 2] = {knot(a, q), knot(a, q + 1)};
    int edges = 2;
    for (int k = 0; k < a->planes; k++) { /* insert in ascending order */
        if (a->plane[k] <= edge[0] || a->plane[k] >= edge[edges - 1]) continue;
        int at = edges++;
        for (; edge[at - 1] > a->plane[k]; at--) edge[at] = edge[at - 1];
        edge[at] = a->plane[k];
    }
    for (int k = 0; k + 1 < edges; k++)
        for (int g = 0; g < GAUSS; g++) {
            double half = (edge[k + 1] - edge[k]) / 2;
            r->node[r->nodes] = edge[k] + half * (1 + gauss_node[g]);
            share[r->nodes++] = half / a->dx * gauss_weight[g];
        }
}

/* For smooth data: few nodes with the moments of the spline up to the third.  For the cubic spline these are the
 * particle and its two neighbours, for the cell the points dx / sqrt(12) to either side. *next: first particle
 * without a node. */
static void add_smooth(const struct axis *a, int i, struct rule *r, int *next) {
    double *w = r->weight + r->begin[i];
    if (a->m == 1) {
        r->first[i] = r->nodes;
        for (int k = 0; k < 2; k++) {
            r->node[r->nodes++] = a->first + (i + (k - 0.5) / sqrt(3)) * a->dx;
            w[k] = 0.5;
        }
        r->begin[i + 1] = r->begin[i] + 2;
        return;
    }
    if (*next < i - 1) *next = i - 1;
    for (; *next <= i + 1; ++*next) r->node[r->nodes++] = a->first + *next * a->dx;
    r->first[i] = r->nodes - 3;
    w[0] = w[2] = 1.0 / 6, w[1] = 2.0 / 3;
    r->begin[i + 1] = r->begin[i] + 3;
}

static struct axis axis_of(const struct problem *p, int m, const struct lattice *l, int dim) {
    struct axis a = {.m = m, .n = l->n[dim], .first = l->first[dim], .dx = l->dx[dim]};
    a.planes = jump_planes(p, l, dim, a.plane);
    return a;
}

static int is_same_axis(const struct axis *a, const struct axis *b) {
    int same = a->n == b->n && a->first == b->first && a->dx == b->dx && a->planes == b->planes;
    for (int k = 0; k < a->planes && same; k++) same = a->plane[k] == b->plane[k];
    return same;
}

static struct rule rule_create(const struct axis *a) {
    int m = a->m, n = a->n, cells = n + m - 1, next = -1, last = -1;
    size_t cuts = 0, *cell = xcalloc((size_t)cells + 1, sizeof *cell);
    for (int i = 0; i < n; i++) cuts += (size_t)is_cut(a, i);
    size_t touched = cuts * (size_t)m < (size_t)cells ? cuts * (size_t)m : (size_t)cells;
    size_t most = GAUSS * (touched + (size_t)a->planes), nodes = most + 2 * (size_t)n + 2;
    size_t weights = GAUSS * cuts * (size_t)(m + a->planes) + SMOOTH * (size_t)n;
    struct rule r = {.first = xcalloc((size_t)n, sizeof *r.first), .begin = xcalloc((size_t)n + 1, sizeof *r.begin)};
    r.node = xcalloc(nodes, sizeof *r.node);
    r.weight = xcalloc(weights, sizeof *r.weight);
    double *share = xcalloc(most, sizeof *share);
    for (int q = 0; q < cells; q++) { /* for particles q - m + 1 to q */
        if (q < n && is_cut(a, q)) last = q + m;
        cell[q] = r.nodes;
        if (q < last) add_cell(a, q, &r, share);
    }
    cell[cells] = r.nodes;
    for (int i = 0; i < n; i++) {
        if (!is_cut(a, i)) {
            add_smooth(a, i, &r, &next);
            continue;
        }
        double *w = r.weight + r.begin[i];
        r.first[i] = cell[i];
        r.begin[i + 1] = r.begin[i] + cell[i + m] - cell[i];
        for (size_t k = cell[i]; k < cell[i + m]; k++)
            *w++ = share[k] * b_spline(m, (r.node[k] - (a->first + i * a->dx)) / a->dx);
    }
    free(cell);
    free(share);
    return r;
}

static void rule_free(struct rule *r) {
    free(r->node);
    free(r->weight);
    free(r->first);
    free(r->begin);
}

/* T[i] for the particles along x, at y = at[1] and z = at[2]; value: work space of x->nodes */
static void average_row(const struct problem *p, const struct rule *x, int n, double at[DIM_MAX], double *value,
                        double *T) {
    int outside = 0;
    for (int a = 1; a < p->dim; a++) outside |= is_outside(p, a, at[a]);
    for (size_t k = 0; k < x->nodes; k++) {
        at[0] = x->node[k];
        value[k] = outside || is_outside(p, 0, at[0]) ? continued(p, at) : p->initial(p, at);
    }
    for (int i = 0; i < n; i++) {
        const double *v = value + x->first[i], *w = x->weight + x->begin[i];
        double sum = 0;
        for (size_t k = 0; k < x->begin[i + 1] - x->begin[i]; k++) sum += w[k] * v[k];
        T[i] = sum;
    }
}

/* Adds the part of node k of a rule to the averages T of n rows, planes or boxes of `size` values each. */
static void add_node(const struct rule *r, size_t k, int n, size_t size, const double *part, double *T) {
    for (int j = 0; j < n; j++) {
        if (k < r->first[j] || k - r->first[j] >= r->begin[j + 1] - r->begin[j]) continue;
        double w = r->weight[r->begin[j] + k - r->first[j]], *to = T + (size_t)j * size;
        for (size_t i = 0; i < size; i++) to[i] += w * part[i];
    }
}

/* The averages along the first `dim` axes, at the other coordinates of `at`. */
static void average(const struct problem *p, const struct rule *rules, int dim, const struct lattice *l,
                    double at[DIM_MAX], double *T) {
    const struct rule *last = &rules[dim - 1];
    size_t size = 1;
    for (int a = 0; a + 1 < dim; a++) size *= (size_t)l->n[a];
    double *part = xcalloc(dim == 1 ? last->nodes : size, sizeof *part);
    if (dim == 1) {
        average_row(p, last, l->n[0], at, part, T);
    } else {
        memset(T, 0, size * (size_t)l->n[dim - 1] * sizeof *T);
        for (size_t k = 0; k < last->nodes; k++) {
            at[dim - 1] = last->node[k];
            average(p, rules, dim - 1, l, at, part);
            add_node(last, k, l->n[dim - 1], size, part, T);
        }
    }
    free(part);
}

static void sample_points(const struct problem *p, const struct lattice *l, double *T) {
    const int nx = l->n[0];
    double *x = xcalloc((size_t)nx, sizeof *x), at[DIM_MAX];
    for (int i = 0; i < nx; i++) {
        layout_position(l, i, 0, 0, at);
        x[i] = at[0];
    }
    for (int k = 0; k < l->n[2]; k++)
        for (int j = 0; j < l->n[1]; j++) {
            layout_position(l, 0, j, k, at);
            for (int i = 0; i < nx; i++) {
                at[0] = x[i];
                *T++ = p->initial(p, at);
            }
        }
    free(x);
}

void sample_lattice(const struct problem *p, enum sampling sampling, const struct lattice *l, double *T) {
    struct axis axis[DIM_MAX];
    struct rule rules[DIM_MAX];
    double at[DIM_MAX] = {0};
    int owner[DIM_MAX]; /* the first axis with the same rule */
    if (sampling == SAMPLING_POINT) {
        sample_points(p, l, T);
        return;
    }
    for (int a = 0; a < l->dim; a++) {
        axis[a] = axis_of(p, sampling == SAMPLING_CELL ? 1 : 4, l, a);
        for (owner[a] = 0; owner[a] < a && !is_same_axis(&axis[a], &axis[owner[a]]);) owner[a]++;
        rules[a] = owner[a] == a ? rule_create(&axis[a]) : rules[owner[a]];
    }
    average(p, rules, l->dim, l, at, T);
    for (int a = 0; a < l->dim; a++)
        if (owner[a] == a) rule_free(&rules[a]);
}

double sample_initial(const struct problem *p, enum sampling sampling, const double *dx, const double *x) {
    double T;
    struct lattice l = {.dim = p->dim, .n = {1, 1, 1}, .dx = {1, 1, 1}};
    memcpy(l.dx, dx, (size_t)p->dim * sizeof *dx);
    memcpy(l.first, x, (size_t)p->dim * sizeof *x);
    sample_lattice(p, sampling, &l, &T);
    return T;
}

double sample_cell(const struct problem *p, enum sampling sampling, const double *dx, const double *x) {
    double beyond = layout_beyond(p, dx[0], x[0]), heat = 0;
    if (p->resistance > 0) {
        double part[DIM_MAX] = {0}, middle[DIM_MAX] = {0};
        part[0] = layout_part(p, dx[0], x[0], &middle[0]);
        return sample_initial(p, sampling, part, middle);
    }
    if (beyond == 0 || beyond == 1) return sample_initial(p, sampling, dx, x);
    for (int m = 0; m < 2; m++) {
        double part[DIM_MAX] = {0}, middle[DIM_MAX] = {0};
        memcpy(part, dx, (size_t)p->dim * sizeof *part);
        memcpy(middle, x, (size_t)p->dim * sizeof *middle);
        part[0] = (m ? beyond : 1 - beyond) * dx[0];
        middle[0] = p->interface + (m ? part[0] : -part[0]) / 2;
        heat += p->material[m].rho_c * part[0] * sample_initial(p, sampling, part, middle);
    }
    return heat / (dx[0] * layout_rho_c(p, dx[0], x[0]));
}
