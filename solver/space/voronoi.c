/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Voronoi cells by clipping (Rycroft 2009, Chaos 19:041111): a square about the particle is cut by the bisectors of
 * its neighbours until none is left that is nearer than twice the farthest vertex, beyond which no bisector reaches.
 *
 * Neighbours are taken from square bins, ring after ring; the distance to the edge of the rings searched says what is
 * complete.  A plane wall needs no cut of its own: a particle's mirror image cuts its cell there, and whatever is
 * nearer to an image of another particle is beyond the wall.
 *
 * A bisector that passes a vertex by less than TOUCH d cuts nothing: four particles on a circle (a lattice, any pair
 * and its images) leave no face of rounding.  Both particles of a pair find their face, and keep the mean of the two:
 * the same bits.  A face below NOTHING spacings is none. */
#include "solver/space/voronoi.h"
#include "solver/space/assembly.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 64 }; /* of a cell: some 6 on the average, 20 are rare */

static const double TOUCH = 1e-13, NOTHING = 1e-10;
static const uint32_t NONE = UINT32_MAX;

struct polygon { /* convex, counterclockwise about the particle; edge k leads from corner k to the next */
    int n;
    double x[CORNERS], y[CORNERS];
    uint32_t edge[CORNERS]; /* whose bisector */
    double farthest;        /* m^2, of a corner */
};

static void start_square(struct polygon *p, double half) {
    static const double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    p->n = 4, p->farthest = 2 * half * half;
    for (int k = 0; k < 4; k++) p->x[k] = half * x[k], p->y[k] = half * y[k], p->edge[k] = NONE;
}

/* Cuts off what lies beyond a x + b y = c; `touch` as s below.  Returns 0, or -1 past CORNERS. */
static int cut(struct polygon *p, double a, double b, double c, double touch, uint32_t edge) {
    double s[CORNERS + 1], most = -HUGE_VAL;
    struct polygon q;
    for (int k = 0; k < p->n; k++) {
        s[k] = a * p->x[k] + b * p->y[k] - c;
        most = s[k] > most ? s[k] : most;
    }
    if (most <= touch) return 0;
    s[p->n] = s[0];
    q.n = 0, q.farthest = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        if (q.n + 2 > CORNERS) return -1;
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

static double area(const struct polygon *p) {
    double twice = 0;
    for (int k = 0; k < p->n; k++) {
        int next = k + 1 < p->n ? k + 1 : 0;
        twice += p->x[k] * p->y[next] - p->x[next] * p->y[k];
    }
    return twice / 2;
}

static int is_closed(const struct polygon *p) {
    for (int k = 0; k < p->n; k++)
        if (p->edge[k] == NONE) return 0;
    return p->n > 2;
}

/* ---- One cell ---- */

struct candidate {
    double d[2], r2; /* m, m^2 */
    uint32_t point;
};

struct candidates {
    size_t n, room;
    struct candidate *at;
};

static void add_candidate(struct candidates *c, const double d[2], uint32_t point) {
    if (c->n == c->room) {
        c->room = c->room ? 2 * c->room : 256;
        c->at = xcheck(realloc(c->at, c->room * sizeof *c->at), c->room, sizeof *c->at);
    }
    c->at[c->n++] = (struct candidate){{d[0], d[1]}, d[0] * d[0] + d[1] * d[1], point};
}

/* The nearest first, as far as `near` of them. */
static void sort_nearest(struct candidates *c, size_t near) {
    for (size_t k = 0; k < near && k < c->n; k++) {
        size_t least = k;
        for (size_t j = k + 1; j < c->n; j++)
            if (c->at[j].r2 < c->at[least].r2) least = j;
        struct candidate held = c->at[k];
        c->at[k] = c->at[least], c->at[least] = held;
    }
}

enum { SORTED = 6 };

/* Of a square of half width `half`, what is left within all bisectors; the first ones cut most. */
static int cut_all(struct candidates *c, double half, struct polygon *cell) {
    sort_nearest(c, SORTED);
    start_square(cell, half);
    for (size_t k = 0; k < c->n; k++) {
        const struct candidate *j = &c->at[k];
        if (!(j->r2 > 0)) return -1;
        if (j->r2 >= 4 * cell->farthest) continue;
        if (cut(cell, j->d[0], j->d[1], j->r2 / 2, TOUCH * j->r2, j->point)) return -1;
    }
    return 0;
}

/* On a rod: the nearest on either side, as a polygon of height 1. */
static int cut_rod(const struct candidates *c, struct polygon *cell) {
    double side[2] = {-HUGE_VAL, HUGE_VAL};
    uint32_t point[2] = {NONE, NONE};
    for (size_t k = 0; k < c->n; k++) {
        double x = c->at[k].d[0];
        int s = x > 0;
        if (!(c->at[k].r2 > 0)) return -1;
        if (fabs(x) < fabs(side[s])) side[s] = x, point[s] = c->at[k].point;
    }
    double lo = side[0] / 2, hi = side[1] / 2;
    *cell = (struct polygon){4, {lo, hi, hi, lo}, {-0.5, -0.5, 0.5, 0.5}, {NONE, point[1], NONE, point[0]}, 0};
    cell->farthest = fmax(lo * lo, hi * hi);
    return 0;
}

static int make_cell(int dim, struct candidates *c, double half, struct polygon *cell) {
    return dim == 1 ? cut_rod(c, cell) : cut_all(c, half, cell);
}

int voronoi_cell(int dim, size_t n, double (*d)[2], double *face, double *volume) {
    struct candidates c = {0};
    struct polygon cell;
    double farthest = 0; /* m^2 */
    for (size_t j = 0; j < n; j++) {
        add_candidate(&c, d[j], (uint32_t)j);
        farthest = fmax(farthest, c.at[j].r2);
        face[j] = 0;
    }
    int status = n ? make_cell(dim, &c, sqrt(farthest), &cell) : -1;
    for (int k = 0; k < cell.n && !status; k++) {
        int next = k + 1 < cell.n ? k + 1 : 0;
        if (cell.edge[k] == NONE)
            status = dim == 2 ? -1 : 0;
        else
            face[cell.edge[k]] = hypot(cell.x[next] - cell.x[k], cell.y[next] - cell.y[k]);
    }
    if (dim == 1 && !status) status = isfinite(cell.farthest) ? 0 : -1;
    *volume = status ? 0 : area(&cell);
    free(c.at);
    return status;
}

/* ---- All cells ---- */

struct mesh { /* what the cells are made from */
    const struct cloud *c;
    struct cloud places; /* in the metric; arrays of *c where that is the usual one */
    struct neighbours bins;
    double scale[2], interface; /* m, in the metric; NAN with one material */
    double spacing;             /* m */
    double reach;               /* m, of ghosts beyond the walls */
};

void voronoi_metric(const struct material *m, int dim, double scale[2]) {
    scale[0] = dim == 2 && m->k[0] != m->k[1] ? pow(m->k[1] / m->k[0], 0.25) : 1;
    scale[1] = 1 / scale[0];
}

static void mesh_create(struct mesh *m, const struct problem *p, const struct cloud *c) {
    *m = (struct mesh){.c = c, .places = *c, .spacing = c->dim == 2 ? sqrt(c->volume) : c->volume};
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
}

/* The points of the bins within `rings` of particle i's; returns how far around it these reach, m. */
static double gather(const struct mesh *m, size_t i, int rings, struct candidates *out) {
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
            if (point != i) add_candidate(out, d, point);
        }
    }
    return around;
}

static int bad_cell(const struct mesh *m, size_t i, const struct candidates *c, struct failure *why) {
    double x = m->c->x[i], y = m->c->y[i];
    for (size_t k = 0; k < c->n; k++)
        if (!(c->at[k].r2 > 0))
            return refuse(why, STATUS_NUMERICAL,
                          "particle %zu at (%.6g, %.6g) m: another particle is at the same place, and no face "
                          "between them; take less --jitter",
                          i, x, y);
    return refuse(why, STATUS_NUMERICAL,
                  "particle %zu at (%.6g, %.6g) m: its Voronoi cell does not end within %.3g m of it, as far as "
                  "ghosts reach beyond the walls; take a layout with fewer holes",
                  i, x, y, m->c->reach);
}

/* A cell that no point farther away would cut. */
static int find_cell(const struct mesh *m, size_t i, struct candidates *c, struct polygon *cell,
                     struct failure *why) {
    for (int rings = 1;; rings++) {
        double around = gather(m, i, rings, c);
        if (make_cell(m->c->dim, c, 4 * rings * m->bins.radius, cell)) return bad_cell(m, i, c, why);
        if (4 * cell->farthest <= around * around && isfinite(cell->farthest)) break;
        if (around == HUGE_VAL) break; /* these were all */
    }
    int closed = m->c->dim == 1 ? isfinite(cell->farthest) : is_closed(cell);
    return closed && cell->farthest <= m->reach * m->reach ? STATUS_OK : bad_cell(m, i, c, why);
}

static double part_beyond(const struct mesh *m, size_t i, const struct polygon *cell) {
    double x = m->interface - m->places.x[i], whole = area(cell);
    struct polygon rest = *cell;
    cut(&rest, 1, 0, x, 0, NONE);
    double part = 1 - (rest.n > 2 ? area(&rest) / whole : 0);
    return part < 1e-9 ? 0 : part > 1 - 1e-9 ? 1 : part;
}

static int take_block(const struct mesh *m, size_t begin, size_t end, struct voronoi *v, struct assembly_list *out,
                      struct failure *why) {
    struct candidates c = {0};
    struct polygon cell;
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        status = find_cell(m, i, &c, &cell, why);
        if (status) break;
        for (int k = 0; k < cell.n; k++) {
            int next = k + 1 < cell.n ? k + 1 : 0;
            double x = cell.x[next] - cell.x[k], y = cell.y[next] - cell.y[k];
            if (cell.edge[k] != NONE) assembly_list_add(out, cell.edge[k], sqrt(x * x + y * y));
        }
        v->begin[i + 1] = out->n;
        v->volume[i] = area(&cell);
        if (v->beyond) v->beyond[i] = part_beyond(m, i, &cell);
    }
    free(c.at);
    return status;
}

/* The other side of face k of cell i, towards particle j or an image of it: NULL where cell j has none. */
static double *other_side(const struct voronoi *v, const struct cloud *c, double spacing, size_t i, size_t k) {
    size_t p = v->point[k], j = c->source[p];
    for (size_t l = v->begin[j]; l < v->begin[j + 1]; l++) {
        size_t q = v->point[l];
        if (p < v->n ? q == i
                     : q >= v->n && c->source[q] == i && /* of images that at the opposite place */
                           fabs(c->x[q] - c->x[j] + c->x[p] - c->x[i]) < 1e-9 * spacing &&
                           fabs(c->y[q] - c->y[j] + c->y[p] - c->y[i]) < 1e-9 * spacing)
            return &v->face[l];
    }
    return NULL;
}

/* One face for both particles of a pair, across a periodic side too; none towards the image of another particle
 * beyond a wall. */
static void agree(struct voronoi *v, const struct cloud *c, double spacing, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
    for (size_t i = 0; i < v->n; i++)
        for (size_t k = v->begin[i]; k < v->begin[i + 1]; k++) {
            size_t j = c->source[v->point[k]];
            if (j == i) { /* its own image: part of a wall */
                if (v->face[k] < NOTHING * spacing) v->face[k] = 0;
                continue;
            }
            double *other = other_side(v, c, spacing, i, k);
            if (other && i > j) continue; /* that is done from j */
            double both = other ? (v->face[k] + *other) / 2 : 0;
            if (both < NOTHING * spacing) both = 0;
            v->face[k] = both;
            if (other) *other = both;
        }
}

/* ---- Means of the initial data ---- */

/* Adds the integrals of rho_c T0 and of rho_c over the part of a cell that no jump cuts: triangles from its first
 * corner, with the rule of three points that is exact for quadratics (Strang & Fix 1973). */
static void add_integrals(const struct problem *p, const struct mesh *m, size_t i, const struct polygon *q,
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
            double heat = third * p->material[layout_material(p, at[0])].rho_c;
            sum[0] += heat * p->initial(p, at), sum[1] += heat;
        }
    }
}

/* The same over a cell, in the parts that planes of jumps leave of it, axis by axis; the interface is one. */
static void integrate_parts(const struct problem *p, const struct mesh *m, size_t i, const struct polygon *q,
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
    struct polygon part[2] = {*q, *q};
    for (int s = 0; s < 2; s++) {
        double sign = s ? -1 : 1;
        cut(&part[s], axis ? 0 : sign, axis ? sign : 0, sign * c, 0, NONE);
        integrate_parts(p, m, i, &part[s], axis, plane + 1, sum);
    }
}

static int average_block(const struct problem *p, const struct mesh *m, size_t begin, size_t end, double *T,
                         struct failure *why) {
    struct candidates c = {0};
    struct polygon cell;
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        double sum[2] = {0, 0};
        status = find_cell(m, i, &c, &cell, why);
        if (!status) integrate_parts(p, m, i, &cell, 0, 0, sum), T[i] = sum[0] / sum[1];
    }
    free(c.at);
    return status;
}

int voronoi_average(const struct problem *p, const struct cloud *c, int threads, double *T, struct failure *why) {
    struct mesh m;
    int first_bad = ASSEMBLY_BLOCKS;
    mesh_create(&m, p, c);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int b = 0; b < ASSEMBLY_BLOCKS; b++) {
        struct failure local;
        size_t begin = c->n * (size_t)b / ASSEMBLY_BLOCKS, end = c->n * (size_t)(b + 1) / ASSEMBLY_BLOCKS;
        if (average_block(p, &m, begin, end, T, &local)) {
#pragma omp critical(average_failure)
            if (b < first_bad) first_bad = b, *why = local;
        }
    }
    mesh_free(&m);
    return first_bad < ASSEMBLY_BLOCKS ? why->status : STATUS_OK;
}

int voronoi_create(struct voronoi *v, const struct problem *p, const struct cloud *c, int threads,
                   struct failure *why) {
    struct mesh m;
    struct assembly_list part[ASSEMBLY_BLOCKS] = {{0, 0, NULL, NULL}};
    size_t begin[ASSEMBLY_BLOCKS + 1];
    int first_bad = ASSEMBLY_BLOCKS;
    *v = (struct voronoi){.n = c->n};
    v->begin = xcalloc(c->n + 1, sizeof *v->begin);
    v->volume = xcalloc(c->n, sizeof *v->volume);
    v->beyond = p->materials == 2 ? xcalloc(c->n, sizeof *v->beyond) : NULL;
    mesh_create(&m, p, c);
    for (size_t b = 0; b <= ASSEMBLY_BLOCKS; b++) begin[b] = c->n * b / ASSEMBLY_BLOCKS;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int b = 0; b < ASSEMBLY_BLOCKS; b++) {
        struct failure local;
        if (take_block(&m, begin[b], begin[b + 1], v, &part[b], &local)) {
#pragma omp critical(voronoi_failure)
            if (b < first_bad) first_bad = b, *why = local;
        }
    }
    mesh_free(&m);
    if (first_bad == ASSEMBLY_BLOCKS) {
        for (size_t b = 0, at = 0; b < ASSEMBLY_BLOCKS; at += part[b++].n)
            for (size_t i = begin[b]; i < begin[b + 1]; i++) v->begin[i + 1] += at;
        size_t faces = assembly_list_join(part, &v->point, &v->face);
        v->bytes = faces * (sizeof *v->point + sizeof *v->face) + (v->n + 1) * sizeof *v->begin +
                   v->n * sizeof(double) * (v->beyond ? 2 : 1);
        agree(v, c, m.spacing, threads);
    }
    assembly_list_free(part);
    if (first_bad == ASSEMBLY_BLOCKS) return STATUS_OK;
    voronoi_free(v);
    return why->status;
}

void voronoi_free(struct voronoi *v) {
    free(v->begin), free(v->point), free(v->face);
    free(v->volume), free(v->beyond);
    *v = (struct voronoi){0};
}
