/* Sampling of the initial data: point, cell or spline (Kreiss, Thomee & Widlund 1970).
 *
 * The average with the B-spline B_m of order m is the integral of T0(x + u dx) B_m(u) over |u| < m/2.  B_m is a
 * polynomial of degree m - 1 between its knots.  Where walls, planes of jumps or their images meet its support, T0 is
 * cut there too, and on each piece Gauss-Legendre with 3 points is exact for degree 5: for quadratic data under a
 * cubic spline.  Elsewhere two points (cell) or three (spline) have its moments up to the third: the average is then
 * met to O(dx^4), and its variance, which is what the start of a matched run counts on, exactly.
 *
 * Knots of neighbours on a lattice coincide, and so do the nodes between them: T0 is evaluated once at each pair of a
 * node along x and a node along y, and its values are summed along x, then along y. */
#include "solver/sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GAUSS = 3, PLANES_MAX = 2 + 3 * JUMP_MAX };

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
    for (int a = 0; a < p->dim; a++) {
        int hi = at[a] > p->hi[a];
        if (!hi && at[a] >= p->lo[a]) continue;
        enum side s = (enum side)(2 * a + hi);
        double wall = hi ? p->hi[a] : p->lo[a], image[2] = {x, y}, foot[2] = {x, y};
        image[a] = 2 * wall - at[a], foot[a] = wall;
        double value = p->wall(p, s, foot), inside = continued(p, image[0], image[1]);
        if (p->side[s] == DIRICHLET) return 2 * value - inside;
        double beyond = fabs(at[a] - wall);
        return inside + value * 2 * beyond / p->material[p->materials == 2 && foot[0] >= p->interface].k[a];
    }
    return p->initial(p, at);
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

/* One axis of a lattice: particles x_i = first + i dx, knots first + (q - m/2) dx; particle i has those of q = i to
 * i + m. */
struct axis {
    int m, n, planes;
    double first, dx, plane[PLANES_MAX];
    unsigned char *cut; /* n: 1 where a plane lies between the outermost knots */
};

struct share { /* of a node in the average about a particle */
    int particle;
    double weight;
};

struct rule {
    double *node;       /* m */
    size_t nodes, *end; /* of a node's shares, which begin where those of the node before it end */
    struct share *share;
};

static double knot(const struct axis *a, int q) {
    return a->first + (q - a->m / 2.0) * a->dx;
}

static void add_node(struct rule *r, double at) {
    r->node[r->nodes] = at;
    r->end[r->nodes] = r->nodes ? r->end[r->nodes - 1] : 0;
    r->nodes++;
}

static void add_share(struct rule *r, int particle, double weight) {
    r->share[r->end[r->nodes - 1]++] = (struct share){particle, weight};
}

/* Between knots q and q + 1, for those of the particles that reach there which are cut. */
static void add_cell(const struct axis *a, int q, struct rule *r) {
    double edge[PLANES_MAX + 2] = {knot(a, q), knot(a, q + 1)};
    int edges = 2, begin = q - a->m + 1 > 0 ? q - a->m + 1 : 0, end = q < a->n ? q + 1 : a->n, any = 0;
    for (int i = begin; i < end; i++) any |= a->cut[i];
    for (int k = 0; k < a->planes && any; k++) { /* insert, ascending */
        if (a->plane[k] <= edge[0] || a->plane[k] >= edge[edges - 1]) continue;
        int at = edges++;
        for (; edge[at - 1] > a->plane[k]; at--) edge[at] = edge[at - 1];
        edge[at] = a->plane[k];
    }
    for (int k = 0; k + 1 < edges && any; k++)
        for (int g = 0; g < GAUSS; g++) {
            double half = (edge[k + 1] - edge[k]) / 2, node = edge[k] + half * (1 + gauss_node[g]);
            add_node(r, node);
            for (int i = begin; i < end; i++) {
                double u = (node - (a->first + i * a->dx)) / a->dx;
                if (a->cut[i]) add_share(r, i, half / a->dx * gauss_weight[g] * b_spline(a->m, u));
            }
        }
}

/* Where the data are smooth: few nodes with the moments of the spline up to the third.  The cubic's are the particle
 * and the two beside it, the cell's lie dx / sqrt(12) to either side. */
static void add_smooth(const struct axis *a, struct rule *r) {
    if (a->m == 1)
        for (int k = 0; k < 2 * a->n; k++) {
            if (a->cut[k / 2]) continue;
            add_node(r, a->first + (k / 2 + (k % 2 - 0.5) / sqrt(3)) * a->dx);
            add_share(r, k / 2, 0.5);
        }
    else
        for (int q = -1; q <= a->n; q++) {
            int begin = q > 0 ? q - 1 : 0, end = q + 2 < a->n ? q + 2 : a->n, any = 0;
            for (int i = begin; i < end; i++) any |= !a->cut[i];
            if (any) add_node(r, a->first + q * a->dx);
            for (int i = begin; i < end; i++)
                if (!a->cut[i]) add_share(r, i, i == q ? 2.0 / 3 : 1.0 / 6);
        }
}

static struct rule rule_create(const struct problem *p, int m, const struct lattice *l, int dim) {
    struct axis a = {.m = m, .n = l->n[dim], .first = l->first[dim], .dx = l->dx[dim]};
    a.planes = jump_planes(p, dim, a.plane);
    a.cut = xcalloc((size_t)a.n, 1);
    size_t cuts = 0, n = (size_t)a.n, span = (size_t)(m + a.planes);
    for (int i = 0; i < a.n; i++) {
        for (int k = 0; k < a.planes; k++) a.cut[i] |= a.plane[k] > knot(&a, i) && a.plane[k] < knot(&a, i + m);
        cuts += a.cut[i];
    }
    struct rule r = {.node = xcalloc(2 * n + 2 + GAUSS * cuts * span, sizeof *r.node)};
    r.end = xcalloc(2 * n + 2 + GAUSS * cuts * span, sizeof *r.end);
    r.share = xcalloc(3 * n + GAUSS * cuts * span, sizeof *r.share);
    for (int q = 0; q < a.n + m - 1; q++) add_cell(&a, q, &r);
    add_smooth(&a, &r);
    free(a.cut);
    return r;
}

static void rule_free(struct rule *r) {
    free(r->node);
    free(r->end);
    free(r->share);
}

void sample_lattice(const struct problem *p, enum sampling sampling, const struct lattice *l, double *T) {
    size_t nx = (size_t)l->n[0], n = nx * (size_t)l->n[1];
    if (sampling == SAMPLING_POINT) {
        for (size_t k = 0; k < n; k++) {
            double at[2];
            layout_position(l, (int)(k % nx), (int)(k / nx), at);
            T[k] = p->initial(p, at);
        }
        return;
    }
    int m = sampling == SAMPLING_CELL ? 1 : 4;
    double zero = 0, *row = xcalloc(nx, sizeof *row);
    struct share one = {0, 1};
    size_t once = 1;
    struct rule x = rule_create(p, m, l, 0), rod = {&zero, 1, &once, &one};
    struct rule y = l->dim == 2 ? rule_create(p, m, l, 1) : rod;
    memset(T, 0, n * sizeof *T);
    for (size_t b = 0, v = 0; b < y.nodes; b++) {
        memset(row, 0, nx * sizeof *row);
        for (size_t a = 0, u = 0; a < x.nodes; a++) {
            double value = continued(p, x.node[a], y.node[b]);
            for (; u < x.end[a]; u++) row[x.share[u].particle] += x.share[u].weight * value;
        }
        for (; v < y.end[b]; v++) {
            double *to = T + (size_t)y.share[v].particle * nx, weight = y.share[v].weight;
            for (size_t i = 0; i < nx; i++) to[i] += weight * row[i];
        }
    }
    rule_free(&x);
    if (l->dim == 2) rule_free(&y);
    free(row);
}

double sample_initial(const struct problem *p, enum sampling sampling, const double dx[2], const double x[2]) {
    double T;
    struct lattice l = {.dim = p->dim, .n = {1, 1}, .dx = {dx[0], dx[1]}, .first = {x[0], x[1]}};
    sample_lattice(p, sampling, &l, &T);
    return T;
}
