/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The Voronoi cells of a cloud, each by clipping (voronoi_cell.c).
 *
 * Candidates for neighbours come from square bins, ring by ring; the distance to the edge of the searched rings
 * bounds the complete region.  Plane walls need no cut: the mirror image of a particle cuts its cell there, and all
 * points closer to the image of another particle are beyond the wall.  A round wall is a circle that cuts cells
 * (voronoi_round.c), and the image of a particle, at the same distance behind the wall, represents the exterior.
 *
 * Both particles of a pair find their common face and store the mean of the two, with the same bits.  Faces below
 * NOTHING spacings are omitted. */
#include "solver/space/voronoi.h"

#include "solver/space/assembly.h"
#include "solver/space/voronoi_cell.h"
#include "solver/space/voronoi_round.h"

#include <math.h>
#include <stdlib.h>

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

static void find_images(struct mesh *m) {
    const struct cloud *c = m->c;
    m->points = c->n;
    m->image = xcalloc(2 * c->n, sizeof *m->image);
    for (size_t g = c->n; g < c->total; g++)
        m->image[2 * c->source[g] + (hypot(c->x[g], c->y[g]) > m->p->radius[1])] = (uint32_t)g;
}

static void mesh_create(struct mesh *m, const struct problem *p, const struct cloud *c) {
    *m = (struct mesh){.p = p, .c = c, .places = *c, .points = c->total};
    m->spacing = c->dim == 2 ? sqrt(c->volume) : c->volume;
    if (p->shape) find_images(m);
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
static int find_cell(const struct mesh *m, size_t i, struct voronoi_candidates *c, struct voronoi_polygon *cell,
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
                      const struct voronoi_round *inside, struct assembly_list *out) {
    for (int k = 0; k < cell->n; k++) {
        int next = k + 1 < cell->n ? k + 1 : 0;
        double x = cell->x[next] - cell->x[k], y = cell->y[next] - cell->y[k];
        double face = m->p->shape ? inside->face[k] : sqrt(x * x + y * y);
        if (cell->edge[k] != VORONOI_NONE) assembly_list_add(out, cell->edge[k], face);
    }
    for (int s = 0; s < 2 && m->p->shape; s++)
        if (inside->wall[s] > NOTHING * m->spacing)
            assembly_list_add(out, m->image[2 * i + (size_t)s], inside->wall[s]);
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
    struct assembly_list part[ASSEMBLY_BLOCKS];
    double *T; /* K */
};

static int take_cells(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct work *w = context;
    struct voronoi *v = w->v;
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell;
    struct voronoi_round inside;
    int status = STATUS_OK;
    for (size_t i = begin; i < end && !status; i++) {
        size_t before = w->part[b].n;
        status = find_cell(w->m, i, &c, &cell, &inside, why);
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
            double heat = third * p->material[layout_material(p, at[0])].rho_c;
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

static int take_means(void *context, int b, size_t begin, size_t end, struct failure *why) {
    struct work *w = context;
    struct voronoi_candidates c = {0};
    struct voronoi_polygon cell;
    struct voronoi_round inside;
    int status = STATUS_OK;
    (void)b;
    for (size_t i = begin; i < end && !status; i++) {
        double sum[2] = {0, 0};
        status = find_cell(w->m, i, &c, &cell, &inside, why);
        if (!status) integrate_parts(w->m->p, w->m, i, &cell, 0, 0, sum), w->T[i] = sum[0] / sum[1];
    }
    free(c.at);
    return status;
}

int voronoi_average(const struct problem *p, const struct cloud *c, int threads, double *T, struct failure *why) {
    struct mesh m;
    mesh_create(&m, p, c);
    int status = assembly_in_blocks(c->n, threads, take_means, &(struct work){.m = &m, .T = T}, why);
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
    int status = assembly_in_blocks(c->n, threads, take_cells, &all, why);
    mesh_free(&m);
    if (!status) {
        size_t faces = assembly_list_join(all.part, v->n, v->begin, &v->point, &v->face);
        v->bytes = faces * (sizeof *v->point + sizeof *v->face) + (v->n + 1) * sizeof *v->begin +
                   v->n * sizeof(double) * (v->beyond ? 2 : 1);
        agree(v, c, m.spacing, threads > 1 ? threads : 1);
    } else {
        voronoi_free(v);
    }
    assembly_list_free(all.part);
    return status;
}

void voronoi_free(struct voronoi *v) {
    free(v->begin), free(v->point), free(v->face);
    free(v->volume), free(v->beyond);
    *v = (struct voronoi){0};
}
