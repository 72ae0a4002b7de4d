/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The domain is divided into equal boxes, and each must have a point.  The side s of a box admits the usual point
 * sets of spacing dx, with N = extent / dx points along an axis, but no field with a quarter missing:
 *
 *   nodes, cell centres, quadrature    The widest gap is dx, from the wall to the first inner node: s >= dx.
 *   jitter of up to dx/2 each way      The widest gap is below 2 dx: s >= 2 dx.
 *   independent, uniform               A box of volume g^d dx^d is empty with probability exp(-g^d).  The mean
 *                                      number of empty boxes among N^d positions is N^d exp(-g^d): 1 in 400 at
 *                                      g^d = d ln N + 6, so that s = dx (d ln N + 6)^(1/d).
 *   a quarter of an axis missing       It must be detected: s <= extent / 4.
 *
 * s = max(2 dx, min(dx (d ln N + 6)^(1/d), extent / 4)).  With `extent / s` rounded down to a whole number of boxes,
 * a gap as wide as two boxes always contains one: at N = 64 that is 5/16 of a rod or 1/8 of a square's side. */
#include "verification/solve/coverage.h"

#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/samples.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double SLACK = 1e-9; /* relative to the extent: a coordinate may be a rounded decimal */
enum { MANY = 20000 };            /* points; for fewer, starting threads takes longer than the loop */

struct boxes {
    const struct samples *s;
    const struct problem *p;
    size_t count[DIM_MAX];
};

static double extent(const struct problem *p, int a) {
    return p->hi[a] - p->lo[a];
}

static double cells(const struct problem *p, int a, const double *d) {
    return fmax(1, nearbyint(extent(p, a) / d[a]));
}

/* The fewest points that a spacing dx requires: with N = extent / dx cells along an axis, the product over the axes
 * of the N - 1 nodes between the walls.  Cell centres are N, nodes with the walls N + 1, quadrature points more. */
static size_t fewest_points(const struct problem *p, const double *d) {
    double n = 1;
    if (p->shape) { /* a lattice has one point per dx^dim, except for some along the walls */
        double R = p->radius[1], walls = p->dim == 3 ? 4 * M_PI * R * R : 2 * M_PI * (p->radius[0] + R);
        return (size_t)fmin(fmax(1, shape_volume(p) / pow(d[0], p->dim) - walls / pow(d[0], p->dim - 1)), 1e18);
    }
    for (int a = 0; a < p->dim; a++) n *= fmax(1, cells(p, a, d) - 1);
    return (size_t)fmin(n, 1e18);
}

/* Index of the first point outside lo to hi along an axis, or n. */
static size_t first_beyond(const double *x, size_t n, double lo, double hi) {
    size_t first = n;
#pragma omp parallel for reduction(min : first) if (n >= MANY)
    for (size_t i = 0; i < n; i++)
        if (!(x[i] >= lo && x[i] <= hi)) first = i < first ? i : first;
    return first;
}

static int check_inside(const struct samples *s, const struct problem *p, struct failure *why) {
    for (int a = 0; a < p->dim; a++) {
        double away = SLACK * extent(p, a), lo = p->lo[a], hi = p->hi[a];
        const double *x = s->value[a];
        size_t first = first_beyond(x, s->n, lo - away, hi + away);
        if (first < s->n)
            return refuse(why, STATUS_INPUT, "%.150s, line %ld: %c = %.9g m is outside %g to %g m", s->path,
                          samples_line(s, first), "xyz"[a], x[first], lo, hi);
    }
    return STATUS_OK;
}

static int check_inside_shape(const struct samples *s, const struct problem *p, struct failure *why) {
    size_t first = s->n;
    double x[DIM_MAX];
    char third[24] = "";
#pragma omp parallel for reduction(min : first) if (s->n >= MANY)
    for (size_t i = 0; i < s->n; i++)
        if (!(shape_depth(p, samples_point(s, i, (double[DIM_MAX]){0})) >= -SLACK * p->radius[1]))
            first = i < first ? i : first;
    if (first == s->n) return STATUS_OK;
    samples_point(s, first, x);
    if (p->dim == 3) snprintf(third, sizeof third, ", %.9g", x[2]);
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: (%.9g, %.9g%s) m is outside the %s", s->path,
                  samples_line(s, first), x[0], x[1], third, p->shape->name);
}

static size_t box_along(const struct boxes *b, int a, double x) {
    double at = (x - b->p->lo[a]) / extent(b->p, a) * (double)b->count[a];
    return at <= 0 ? 0 : at >= (double)b->count[a] ? b->count[a] - 1 : (size_t)at;
}

static size_t box_of(const struct boxes *b, size_t i) {
    size_t box = 0;
    for (int a = b->p->dim; a-- > 0;) box = box * b->count[a] + box_along(b, a, b->s->value[a][i]);
    return box;
}

static size_t all(const struct boxes *b) {
    return b->count[0] * b->count[1] * b->count[2];
}

static void bounds_of(const struct boxes *b, size_t box, double lo[DIM_MAX], double hi[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) {
        double side = extent(b->p, a) / (double)b->count[a];
        lo[a] = b->p->lo[a] + side * (double)(box % b->count[a]);
        hi[a] = lo[a] + side;
        box /= b->count[a];
    }
}

/* Whether a round body contains the entire box. */
static int is_whole(const struct boxes *b, size_t box) {
    double lo[DIM_MAX], hi[DIM_MAX];
    bounds_of(b, box, lo, hi);
    double volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (b->p->dim == 3 ? hi[2] - lo[2] : 1);
    return shape_clipped(b->p, lo, hi) >= (1 - SLACK) * volume;
}

static int refuse_gap(const struct boxes *b, size_t empty, struct failure *why) {
    char where[128] = "";
    double lo[DIM_MAX], hi[DIM_MAX];
    bounds_of(b, empty, lo, hi);
    for (int a = 0; a < b->p->dim; a++)
        words_add(where, sizeof where, "%s%.4g <= %c <= %.4g m", a ? ", " : "", lo[a], "xyz"[a], hi[a]);
    return refuse(why, STATUS_INPUT, "%.150s: no point in %s: the field must cover the whole domain", b->s->path,
                  where);
}

static int check_gaps(const struct samples *s, const struct problem *p, const double *d, struct failure *why) {
    struct boxes b = {s, p, {1, 1, 1}};
    for (int a = 0; a < p->dim; a++) {
        double g = pow(p->dim * log(cells(p, a, d)) + 6, 1.0 / p->dim);
        double side = fmax(2 * d[a], fmin(g * d[a], extent(p, a) / 4));
        b.count[a] = (size_t)fmax(1, floor(extent(p, a) / side * (1 + SLACK)));
    }
    char *seen = xcalloc(all(&b), 1);
    for (size_t box = 0; box < all(&b) && p->shape; box++) seen[box] = !is_whole(&b, box);
#pragma omp parallel for if (s->n >= MANY)
    for (size_t i = 0; i < s->n; i++) {
        char *box = &seen[box_of(&b, i)];
#pragma omp atomic write
        *box = 1;
    }
    size_t empty = 0;
    while (empty < all(&b) && seen[empty]) empty++;
    free(seen);
    return empty < all(&b) ? refuse_gap(&b, empty, why) : STATUS_OK;
}

/* ---- Duplicate points ---- */

struct place {
    double x[DIM_MAX];
    size_t i; /* index of the sample */
};

static int by_x(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    return p->x[0] != q->x[0] ? (p->x[0] > q->x[0]) - (p->x[0] < q->x[0]) : (p->i > q->i) - (p->i < q->i);
}

static int by_y(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    return p->x[1] != q->x[1] ? (p->x[1] > q->x[1]) - (p->x[1] < q->x[1]) : by_x(a, b);
}

/* Finds a pair of equal points among n of a column and puts their indices into *first < *second; 0 if there is
 * none. */
static int find_pair(struct place *at, size_t n, const double *away, size_t *first, size_t *second) {
    qsort(at, n, sizeof *at, by_y);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n && at[j].x[1] - at[i].x[1] <= away[1]; j++) {
            if (!(fabs(at[j].x[0] - at[i].x[0]) <= away[0] && fabs(at[j].x[2] - at[i].x[2]) <= away[2])) continue;
            *first = at[i].i < at[j].i ? at[i].i : at[j].i;
            *second = at[i].i < at[j].i ? at[j].i : at[i].i;
            return 1;
        }
    return 0;
}

/* After sorting along x, the points fall into columns separated by gaps wider than the tolerance. */
int coverage_check_once(const struct samples *s, const struct problem *p, struct failure *why) {
    const double away[DIM_MAX] = {SLACK * extent(p, 0), SLACK * extent(p, 1), SLACK * extent(p, 2)};
    struct place *at = xcalloc(s->n, sizeof *at);
    size_t first, second, end;
    int found = 0;
    for (size_t i = 0; i < s->n; i++) samples_point(s, i, at[i].x), at[i].i = i;
    qsort(at, s->n, sizeof *at, by_x);
    for (size_t start = 0; start < s->n && !found; start = end) {
        for (end = start + 1; end < s->n && at[end].x[0] - at[end - 1].x[0] <= away[0]; end++) continue;
        found = find_pair(at + start, end - start, away, &first, &second);
    }
    free(at);
    if (!found) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: the same point as in line %ld (x = %.9g m%s)", s->path,
                  samples_line(s, second), samples_line(s, first), s->value[COLUMN_X][first],
                  p->dim == 1 ? "; a rod has one row of points" : "");
}

int coverage_check(const struct samples *s, const struct problem *p, const double *d, struct failure *why) {
    size_t fewest = fewest_points(p, d);
    if (check_inside(s, p, why) || (p->shape && check_inside_shape(s, p, why))) return STATUS_INPUT;
    if (s->n < fewest)
        return refuse(why, STATUS_INPUT, "%.150s: %zu point%s where dx = %g m asks for %zu at least", s->path, s->n,
                      s->n == 1 ? "" : "s", d[0], fewest);
    if (check_gaps(s, p, d, why)) return STATUS_INPUT;
    return coverage_check_once(s, p, why);
}
