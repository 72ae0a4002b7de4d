/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The Voronoi cells of a cloud.
 *
 * One cell, by clipping (Rycroft 2009, Chaos 19:041111): a square about the particle is cut by the bisectors of its
 * neighbours, up to twice the distance of the farthest vertex; no bisector beyond reaches the cell.  A bisector that
 * passes a vertex at less than TOUCH d does not cut, so that four particles on a circle (a lattice, or any pair and
 * its images) leave no face of the size of round-off.
 *
 * A round wall cuts each edge at its intersection with the circle; both particles of a pair find the same point, so
 * their face is the same.  The area inside a circle is an integral along the polygon: for an edge inside, the
 * triangle with the centre; for one outside, the sector of its angle.  The angles of the sectors sum to the part of
 * the circle inside the cell.  The areas therefore sum to that of the body and the walls to its circles, to
 * round-off, for any intersection.
 *
 * The mesh: candidates for neighbours come from square bins, ring by ring; the distance to the edge of the searched
 * rings bounds the complete region.  Plane walls need no cut: the mirror image of a particle cuts its cell there, and
 * all points closer to the image of another particle are beyond the wall.  The image of a particle in a round wall,
 * at the same distance behind it, represents the exterior.  Both particles of a pair find their common face and store
 * the mean of the two, with the same bits.  Faces below NOTHING spacings are omitted. */
#include "solver/space/voronoi.h"

#include "solver/space/blocks.h"
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>

/* ---- One cell ---- */

static const double TOUCH = 1e-13;

static void start_square(struct voronoi_polygon *p, double half) {
    static const double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    p->n = 4, p->farthest = 2 * half * half;
    for (int k = 0; k < 4; k++) p->x[k] = half * x[k], p->y[k] = half * y[k], p->edge[k] = VORONOI_NONE;
}

int voronoi_cell_cut(struct voronoi_polygon *p, double a, double b, double c, double touch, uint32_t edge) {
    double s[VORONOI_CORNERS + 1], most = -HUGE_VAL;
    struct voronoi_polygon q;
    for (int k = 0; k < p->n; k++) {
        s[k] = a * p->x[k] + b * p->y[k] - c;
        most = s[k] > most ? s[k] : most;
    }
    if (most <= touch) return 0;
    s[p->n] = s[0];
    q.n = 0, q.farthest = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        if (q.n + 2 > VORONOI_CORNERS) return -1;
        if (s[k] <= 0) q.x[q.n] = p->x[k], q.y[q.n] = p->y[k], q.edge[q.n++] = p->edge[k];
        if ((s[k] <= 0) == (s[k + 1] <= 0)) continue;
        double t = s[k] / (s[k] - s[k + 1]);
        q.x[q.n] = p->x[k] + t * (p->x[next] - p->x[k]), q.y[q.n] = p->y[k] + t * (p->y[next] - p->y[k]);
        q.edge[q.n++] = s[k] <= 0 ? edge : p->edge[k];
    }
    p->n = q.n, p->farthest = 0;
    for (int k = 0; k < q.n; k++) {
        double r2 = q.x[k] * q.x[k] + q.y[k] * q.y[k];
        p->x[k] = q.x[k], p->y[k] = q.y[k], p->edge[k] = q.edge[k];
        p->farthest = r2 > p->farthest ? r2 : p->farthest;
    }
    return 0;
}

double voronoi_cell_area(const struct voronoi_polygon *p) {
    double twice = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        twice += p->x[k] * p->y[next] - p->x[next] * p->y[k];
    }
    return twice / 2;
}

int voronoi_cell_closes(const struct voronoi_polygon *p) {
    for (int k = 0; k < p->n; k++)
        if (p->edge[k] == VORONOI_NONE) return 0;
    return p->n > 2;
}

void voronoi_cell_offer(struct voronoi_candidates *c, const double d[2], uint32_t point) {
    if (c->n == c->room) {
        c->room = c->room ? 2 * c->room : 256;
        c->at = xcheck(realloc(c->at, c->room * sizeof *c->at), c->room, sizeof *c->at);
    }
    c->at[c->n++] = (struct voronoi_candidate){{d[0], d[1]}, d[0] * d[0] + d[1] * d[1], point};
}

/* Moves the `near` nearest points to the front, in ascending order. */
static void sort_nearest(struct voronoi_candidates *c, size_t near) {
    for (size_t k = 0; k < near && k < c->n; k++) {
        size_t least = k;
        for (size_t j = k + 1; j < c->n; j++)
            if (c->at[j].r2 < c->at[least].r2) least = j;
        struct voronoi_candidate held = c->at[k];
        c->at[k] = c->at[least], c->at[least] = held;
    }
}

enum { SORTED = 6 };

/* Cuts a square of half width `half` by all bisectors; the first ones cut most. */
static int cut_all(struct voronoi_candidates *c, double half, struct voronoi_polygon *cell) {
    sort_nearest(c, SORTED);
    start_square(cell, half);
    for (size_t k = 0; k < c->n; k++) {
        const struct voronoi_candidate *j = &c->at[k];
        if (!(j->r2 > 0)) return -1;
        if (j->r2 >= 4 * cell->farthest) continue;
        if (voronoi_cell_cut(cell, j->d[0], j->d[1], j->r2 / 2, TOUCH * j->r2, j->point)) return -1;
    }
    return 0;
}

/* On a rod: the nearest point on either side, as a polygon of height 1. */
static int cut_rod(const struct voronoi_candidates *c, struct voronoi_polygon *cell) {
    double side[2] = {-HUGE_VAL, HUGE_VAL};
    uint32_t point[2] = {VORONOI_NONE, VORONOI_NONE};
    for (size_t k = 0; k < c->n; k++) {
        double x = c->at[k].d[0];
        int s = x > 0;
        if (!(c->at[k].r2 > 0)) return -1;
        if (fabs(x) < fabs(side[s])) side[s] = x, point[s] = c->at[k].point;
    }
    double lo = side[0] / 2, hi = side[1] / 2;
    *cell = (struct voronoi_polygon){
        4, {lo, hi, hi, lo}, {-0.5, -0.5, 0.5, 0.5}, {VORONOI_NONE, point[1], VORONOI_NONE, point[0]}, 0};
    cell->farthest = fmax(lo * lo, hi * hi);
    return 0;
}

int voronoi_cell_make(int dim, struct voronoi_candidates *c, double half, struct voronoi_polygon *cell) {
    return dim == 1 ? cut_rod(c, cell) : cut_all(c, half, cell);
}

int voronoi_cell(int dim, size_t n, double (*d)[2], double *face, double *volume) {
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell; /* no corners if there is no cell */
    cell.n = 0;
    double farthest = 0; /* m^2 */
    for (size_t j = 0; j < n; j++) {
        voronoi_cell_offer(&c, d[j], (uint32_t)j);
        farthest = fmax(farthest, c.at[j].r2);
        face[j] = 0;
    }
    int status = n ? voronoi_cell_make(dim, &c, sqrt(farthest), &cell) : -1;
    for (int k = 0; k < cell.n && !status; k++) {
        int next = k + 1 < cell.n ? k + 1 : 0;
        if (cell.edge[k] == VORONOI_NONE)
            status = dim == 2 ? -1 : 0;
        else
            face[cell.edge[k]] = hypot(cell.x[next] - cell.x[k], cell.y[next] - cell.y[k]);
    }
    if (dim == 1 && !status) status = isfinite(cell.farthest) ? 0 : -1;
    *volume = status ? 0 : voronoi_cell_area(&cell);
    free(c.at);
    return status;
}

/* ---- A cell cut by a round wall ---- */

static double cross(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

static double angle(const double a[2], const double b[2]) {
    return atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
}

/* The part t[0] to t[1] of the edge from a to b inside the circle; t[0] = t[1] if there is none. */
static void within(const double a[2], const double b[2], double R, double t[2]) {
    double e[2] = {b[0] - a[0], b[1] - a[1]}, square = e[0] * e[0] + e[1] * e[1],
           middle = -(a[0] * e[0] + a[1] * e[1]);
    double half = middle * middle + square * (R * R - a[0] * a[0] - a[1] * a[1]);
    t[0] = t[1] = 0;
    if (!(half > 0)) return;
    t[0] = fmin(fmax((middle - sqrt(half)) / square, 0), 1);
    t[1] = fmin(fmax((middle + sqrt(half)) / square, 0), 1);
}

/* Adds the contribution of the edge from a to b to area and angle of the circle of radius R; returns the length
 * inside. */
static double add_edge(const double a[2], const double b[2], double R, double t[2], double *area, double *arc) {
    double end[2][2], length = hypot(b[0] - a[0], b[1] - a[1]);
    within(a, b, R, t);
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 2; k++) end[s][k] = a[k] + t[s] * (b[k] - a[k]);
    double outside = (t[0] > 0 ? angle(a, end[0]) : 0) + (t[1] < 1 ? angle(end[1], b) : 0);
    *area += (cross(end[0], end[1]) + R * R * outside) / 2;
    *arc += outside;
    return length * (t[1] - t[0]);
}

struct voronoi_round voronoi_round(const struct voronoi_polygon *cell, const double at[2], const double radius[2]) {
    struct voronoi_round r = {.area = 0};
    double area[2] = {0, 0}, arc[2] = {0, 0}, t[2];
    for (int k = 0; k < cell->n; k++) {
        int next = k + 1 < cell->n ? k + 1 : 0;
        const double a[2] = {at[0] + cell->x[k], at[1] + cell->y[k]};
        const double b[2] = {at[0] + cell->x[next], at[1] + cell->y[next]};
        double hole = radius[0] > 0 ? add_edge(a, b, radius[0], t, &area[0], &arc[0]) : 0;
        r.face[k] = add_edge(a, b, radius[1], t, &area[1], &arc[1]) - hole;
        if (!(r.face[k] > 0)) continue;
        for (int s = 0; s < 2; s++) {
            double x = cell->x[k] + t[s] * (b[0] - a[0]), y = cell->y[k] + t[s] * (b[1] - a[1]);
            r.farthest = fmax(r.farthest, x * x + y * y);
        }
    }
    r.area = area[1] - area[0];
    for (int s = 0; s < 2; s++) r.wall[s] = arc[s] * radius[s];
    return r;
}

/* ---- The mesh ---- */

static const double NOTHING = 1e-10;

struct mesh { /* input of the cells */
    const struct problem *p;
    const struct cloud *c;
    struct cloud places; /* in the metric; arrays of *c if the metric is Euclidean */
    struct neighbours bins;
    double scale[2], interface; /* m, in the metric; NAN with one material */
    double spacing;             /* m */
    double reach;               /* m, reach of the ghosts beyond the walls */
    size_t points;              /* number of points with bisectors, without the images beyond round walls */
    uint32_t *image; /* images of each particle beyond the inner and the outer wall of a round body; else NULL */
};

void voronoi_metric(const struct material *m, int dim, double scale[2]) {
    scale[0] = dim == 2 && m->k[0] != m->k[1] ? pow(m->k[1] / m->k[0], 0.25) : 1;
    scale[1] = 1 / scale[0];
}

static void collect_images(struct mesh *m) {
    const struct cloud *c = m->c;
    m->points = c->n;
    m->image = xcalloc(2 * c->n, sizeof *m->image);
    for (size_t g = c->n; g < c->total; g++)
        m->image[2 * c->source[g] + (hypot(c->x[g], c->y[g]) > m->p->radius[1])] = (uint32_t)g;
}

static void mesh_create(struct mesh *m, const struct problem *p, const struct cloud *c) {
    *m = (struct mesh){.p = p, .c = c, .places = *c, .points = c->total};
    m->spacing = c->dim == 2 ? sqrt(c->volume) : c->volume;
    if (p->shape) collect_images(m);
    voronoi_metric(&p->material[0], p->dim, m->scale);
    m->interface = p->materials == 2 ? p->interface * m->scale[0] : NAN;
    m->reach = c->reach * fmin(m->scale[0], m->scale[1]);
    if (m->scale[0] != 1) {
        m->places.x = xcalloc(c->total, sizeof *c->x);
        m->places.y = xcalloc(c->total, sizeof *c->y);
        for (size_t i = 0; i < c->total; i++)
            m->places.x[i] = c->x[i] * m->scale[0], m->places.y[i] = c->y[i] * m->scale[1];
    }
    neighbours_create(&m->bins, &m->places, 1.5 * m->spacing * fmax(m->scale[0], m->scale[1]));
}

static void mesh_free(struct mesh *m) {
    neighbours_free(&m->bins);
    if (m->scale[0] != 1) free(m->places.x), free(m->places.y);
    free(m->image);
}

/* Collects the points in the bins within `rings` of particle i's; returns the distance up to which they are
 * complete, m. */
static double gather(const struct mesh *m, size_t i, int rings, struct voronoi_candidates *out) {
    const struct neighbours *b = &m->bins;
    const double at[2] = {m->places.x[i], m->places.y[i]};
    int first[2] = {0, 0}, past[2] = {1, 1};
    double around = HUGE_VAL;
    for (int a = 0; a < m->c->dim; a++) {
        int bin = (int)((at[a] - b->lo[a]) / b->radius);
        double within = at[a] - b->lo[a] - bin * b->radius;
        first[a] = bin - rings > 0 ? bin - rings : 0;
        past[a] = bin + rings + 1 < b->cells[a] ? bin + rings + 1 : b->cells[a];
        if (first[a] > 0) around = fmin(around, within + rings * b->radius);
        if (past[a] < b->cells[a]) around = fmin(around, (rings + 1) * b->radius - within);
    }
    out->n = 0;
    for (int j = first[1]; j < past[1]; j++) {
        const uint32_t *row = b->start + (size_t)j * (size_t)b->cells[0];
        for (uint32_t k = row[first[0]]; k < row[past[0]]; k++) {
            uint32_t point = b->point[k];
            double d[2] = {m->places.x[point] - at[0], m->places.y[point] - at[1]};
            if (point != i && point < m->points) voronoi_cell_offer(out, d, point);
        }
    }
    return around;
}

static int bad_cell(const struct mesh *m, size_t i, const struct voronoi_candidates *c, struct failure *why) {
    double x = m->c->x[i], y = m->c->y[i];
    for (size_t k = 0; k < c->n; k++)
        if (!(c->at[k].r2 > 0))
            return refuse(why, STATUS_NUMERICAL,
                          "particle %zu at (%.6g, %.6g) m: another particle is at the same place, without a face "
                          "between them; use less --jitter",
                          i, x, y);
    return refuse(
        why, STATUS_NUMERICAL,
        "particle %zu at (%.6g, %.6g) m: its Voronoi cell does not end within %.3g m, the distance to which "
        "ghosts extend beyond the walls; use a layout with fewer holes",
        i, x, y, m->c->reach);
}

/* A cell that no farther point can cut, and for a round body its part inside. */
static int make_cell(const struct mesh *m, size_t i, struct voronoi_candidates *c, struct voronoi_polygon *cell,
                     struct voronoi_round *inside, struct failure *why) {
    const double at[2] = {m->c->x[i], m->c->y[i]};
    double farthest;
    for (int rings = 1;; rings++) {
        double around = gather(m, i, rings, c);
        if (voronoi_cell_make(m->c->dim, c, 4 * rings * m->bins.radius, cell)) return bad_cell(m, i, c, why);
        if (m->p->shape) *inside = voronoi_round(cell, at, m->p->radius);
        farthest = m->p->shape ? inside->farthest : cell->farthest;
        if (4 * farthest <= around * around && isfinite(farthest)) break;
        if (around == HUGE_VAL) break; /* no more points */
    }
    for (size_t s = 0; s < 2 && m->p->shape; s++)
        if (inside->wall[s] > NOTHING * m->spacing && !m->image[2 * i + s]) return bad_cell(m, i, c, why);
    if (m->p->shape) return STATUS_OK; /* the square is then wider than the body */
    int closed = m->c->dim == 1 ? isfinite(farthest) : voronoi_cell_closes(cell);
    return closed && farthest <= m->reach * m->reach ? STATUS_OK : bad_cell(m, i, c, why);
}

static void add_faces(const struct mesh *m, size_t i, const struct voronoi_polygon *cell,
                      const struct voronoi_round *inside, struct blocks_list *out) {
    for (int k = 0; k < cell->n; k++) {
        int next = k + 1 < cell->n ? k + 1 : 0;
        double x = cell->x[next] - cell->x[k], y = cell->y[next] - cell->y[k];
        double face = m->p->shape ? inside->face[k] : sqrt(x * x + y * y);
        if (cell->edge[k] != VORONOI_NONE) blocks_list_add(out, cell->edge[k], face);
    }
    for (int s = 0; s < 2 && m->p->shape; s++)
        if (inside->wall[s] > NOTHING * m->spacing)
            blocks_list_add(out, m->image[2 * i + (size_t)s], inside->wall[s]);
}

static double part_beyond(const struct mesh *m, size_t i, const struct voronoi_polygon *cell) {
    double x = m->interface - m->places.x[i], whole = voronoi_cell_area(cell);
    struct voronoi_polygon rest = *cell;
    voronoi_cell_cut(&rest, 1, 0, x, 0, VORONOI_NONE);
    double part = 1 - (rest.n > 2 ? voronoi_cell_area(&rest) / whole : 0);
    return part < 1e-9 ? 0 : part > 1 - 1e-9 ? 1 : part;
}

struct work { /* cells, or averages of the initial data over them */
    const struct mesh *m;
    struct voronoi *v;
    struct blocks_list part[BLOCKS];
    double *T; /* K */
};

static int make_cells(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct work *w = context;
    struct voronoi *v = w->v;
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell;
    struct voronoi_round inside;
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        size_t before = w->part[b].n;
        status = make_cell(w->m, i, &c, &cell, &inside, why);
        if (status) break;
        add_faces(w->m, i, &cell, &inside, &w->part[b]);
        v->begin[i + 1] = w->part[b].n - before;
        v->volume[i] = w->m->p->shape ? inside.area : voronoi_cell_area(&cell);
        if (v->beyond) v->beyond[i] = part_beyond(w->m, i, &cell);
    }
    free(c.at);
    return status;
}

/* The face of cell j that corresponds to face k of cell i, towards particle j or its image; NULL if cell j has
 * none. */
static double *other_side(const struct voronoi *v, const struct cloud *c, double spacing, size_t i, size_t k) {
    size_t p = v->point[k], j = c->source[p];
    for (size_t l = v->begin[j]; l < v->begin[j + 1]; l++) {
        size_t q = v->point[l];
        if (p < v->n ? q == i
                     : q >= v->n && c->source[q] == i && /* for images, the one at the opposite position */
                           fabs(c->x[q] - c->x[j] + c->x[p] - c->x[i]) < 1e-9 * spacing &&
                           fabs(c->y[q] - c->y[j] + c->y[p] - c->y[i]) < 1e-9 * spacing)
            return &v->face[l];
    }
    return NULL;
}

/* Assigns one face to both particles of a pair, also across a periodic side; a face towards the image of another
 * particle beyond a wall becomes 0. */
static void agree(struct voronoi *v, const struct cloud *c, double spacing, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
    for (size_t i = 0; i < v->n; i++)
        for (size_t k = v->begin[i]; k < v->begin[i + 1]; k++) {
            size_t j = c->source[v->point[k]];
            if (j == i) { /* the particle's own image: part of a wall */
                if (v->face[k] < NOTHING * spacing) v->face[k] = 0;
                continue;
            }
            double *other = other_side(v, c, spacing, i, k);
            if (other && i > j) continue; /* done from j */
            double both = other ? (v->face[k] + *other) / 2 : 0;
            if (both < NOTHING * spacing) both = 0;
            v->face[k] = both;
            if (other) *other = both;
        }
}

/* ---- Averages of the initial data ---- */

/* Adds the integrals of rho_c T0 and of rho_c over a part of a cell without jumps: a fan of triangles, with the
 * three-point rule that is exact for quadratics (Strang & Fix 1973). */
static void add_integrals(const struct problem *p, const struct mesh *m, size_t i, const struct voronoi_polygon *q,
                          double sum[2]) {
    static const double far = 2.0 / 3, near = 1.0 / 6;
    for (int k = 1; k + 1 < q->n; k++) {
        const double x[3] = {q->x[0], q->x[k], q->x[k + 1]}, y[3] = {q->y[0], q->y[k], q->y[k + 1]};
        double third = ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 6;
        for (int a = 0; a < 3; a++) {
            double at[2] = {far * x[a] + near * (x[(a + 1) % 3] + x[(a + 2) % 3]),
                            far * y[a] + near * (y[(a + 1) % 3] + y[(a + 2) % 3])};
            at[0] = (m->places.x[i] + at[0]) / m->scale[0];
            at[1] = p->dim == 2 ? (m->places.y[i] + at[1]) / m->scale[1] : 0;
            const int of = layout_material(p, at[0]);
            if (p->resistance > 0 && of != layout_material(p, m->c->x[i])) continue; /* T jumps */
            double heat = third * p->material[of].rho_c;
            sum[0] += heat * p->initial(p, at), sum[1] += heat;
        }
    }
}

/* The same over a whole cell, split at the planes of jumps axis by axis; the interface is one of them. */
static void integrate_parts(const struct problem *p, const struct mesh *m, size_t i, const struct voronoi_polygon *q,
                            int axis, int plane, double sum[2]) {
    if (axis == 2 || q->n < 3) {
        if (q->n > 2) add_integrals(p, m, i, q, sum);
        return;
    }
    int own = axis == 0 && p->materials == 2, planes = p->jumps[axis] + own;
    if (plane == planes) {
        integrate_parts(p, m, i, q, axis + 1, 0, sum);
        return;
    }
    double at = own && plane == 0 ? p->interface : p->jump[axis][plane - own];
    double c = at * m->scale[axis] - (axis ? m->places.y[i] : m->places.x[i]);
    struct voronoi_polygon part[2] = {*q, *q};
    for (int s = 0; s < 2; s++) {
        double sign = s ? -1 : 1;
        voronoi_cell_cut(&part[s], axis ? 0 : sign, axis ? sign : 0, sign * c, 0, VORONOI_NONE);
        integrate_parts(p, m, i, &part[s], axis, plane + 1, sum);
    }
}

static int average_cells(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct work *w = context;
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell;
    struct voronoi_round inside;
    int status = STATUS_OK;
    (void)b;
    for (size_t i = begin; i < end && !status; i++) {
        double sum[2] = {0, 0};
        status = make_cell(w->m, i, &c, &cell, &inside, why);
        if (!status) integrate_parts(w->m->p, w->m, i, &cell, 0, 0, sum), w->T[i] = sum[0] / sum[1];
    }
    free(c.at);
    return status;
}

int voronoi_average(const struct problem *p, const struct cloud *c, int threads, double *T, struct failure *why) {
    struct mesh m;
    mesh_create(&m, p, c);
    int status = blocks_run(c->n, threads, average_cells, &(struct work){.m = &m, .T = T}, why);
    mesh_free(&m);
    return status;
}

int voronoi_create(struct voronoi *v, const struct problem *p, const struct cloud *c, int threads,
                   struct failure *why) {
    struct mesh m;
    *v = (struct voronoi){.n = c->n};
    v->begin = xcalloc(c->n + 1, sizeof *v->begin);
    v->volume = xcalloc(c->n, sizeof *v->volume);
    v->beyond = p->materials == 2 ? xcalloc(c->n, sizeof *v->beyond) : NULL;
    mesh_create(&m, p, c);
    struct work all = {.m = &m, .v = v};
    int status = blocks_run(c->n, threads, make_cells, &all, why);
    mesh_free(&m);
    if (!status) {
        size_t faces = blocks_list_join(all.part, v->n, v->begin, &v->point, &v->face);
        v->bytes = faces * (sizeof *v->point + sizeof *v->face) + (v->n + 1) * sizeof *v->begin +
                   v->n * sizeof(double) * (v->beyond ? 2 : 1);
        agree(v, c, m.spacing, threads > 1 ? threads : 1);
    } else {
        voronoi_free(v);
    }
    blocks_list_free(all.part);
    return status;
}

void voronoi_free(struct voronoi *v) {
    free(v->begin), free(v->point), free(v->face);
    free(v->volume), free(v->beyond);
    *v = (struct voronoi){0};
}
