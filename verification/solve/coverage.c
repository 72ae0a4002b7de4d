/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points of an answer cover the domain, each once.
 *
 * Gaps.  The domain is divided into equal boxes, and each must have a point.  The side s of a box admits the usual
 * point sets of spacing dx, with N = extent / dx points along an axis, but no field with a quarter missing:
 *
 *   nodes, cell centres, quadrature    The widest gap is dx, from the wall to the first inner node: s >= dx.
 *   jitter of up to dx/2 each way      The widest gap is below 2 dx: s >= 2 dx.
 *   independent, uniform               A box of volume g^d dx^d is empty with probability exp(-g^d).  The mean
 *                                      number of empty boxes among N^d positions is N^d exp(-g^d): 1 in 400 at
 *                                      g^d = d ln N + 6, so that s = dx (d ln N + 6)^(1/d).
 *   a quarter of an axis missing       It must be detected: s <= extent / 4.
 *
 * s = max(2 dx, min(dx (d ln N + 6)^(1/d), extent / 4)).  With `extent / s` rounded down to a whole number of boxes,
 * a gap as wide as two boxes always contains one: at N = 64 that is 5/16 of a rod or 1/8 of a square's side.
 *
 * Missing points.  A missing point barely changes a mean.  If the other points form a lattice, its position is known:
 *
 *   rows and columns    There are nx distinct x and ny distinct y (and nz distinct z), and at least 95 of 100
 *                       positions of the nx x ny (x nz) lattice have a point.  Fewer do not form a lattice:
 *                       eight-node elements fill three quarters.  Places on two walls, a corner of a rectangle or
 *                       an edge of a box, may be missing, as in many codes.
 *   equal spacing h     Of five points or more along an axis: one gap of 2 h, 3 h, ... is next to two of h; or the
 *                       gap from a wall to the first of three points exceeds 5/4 h while the case has more cells
 *                       than there are points.  Graded spacings have several wide gaps in a row.
 *   the case's spacing  Of fewer points along an axis of up to five cells, all dx apart or multiples of it: each
 *                       place of that lattice between the walls has one.
 *
 * Two layers may have no point on their interface. */
#include "verification/solve/coverage.h"

#include "references/mapping.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/samples.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
 * of the N - 1 nodes between the walls, without a node on an interface.  Cell centres are N, nodes with the walls N +
 * 1, quadrature points more. */
static size_t fewest_points(const struct image *image, const double *d) {
    const struct problem *p = &image->problem;
    double n = 1;
    if (p->shape) { /* a lattice has one point per dx^dim, except for some along the walls */
        double R = p->radius[1], walls = p->dim == 3 ? 4 * M_PI * R * R : 2 * M_PI * (p->radius[0] + R);
        return (size_t)fmin(fmax(1, shape_volume(p) / pow(d[0], p->dim) - walls / pow(d[0], p->dim - 1)), 1e18);
    }
    for (int a = 0; a < p->dim; a++)
        n *= fmax(1, cells(p, a, d) - 1 - (p->materials == 2 && a == image->interface_axis));
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

/* Whether all points are inside with axes a and b exchanged. */
static int inside_exchanged(const struct samples *s, const struct problem *p, int a, int b) {
    const int of[] = {a, b};
    for (int k = 0; k < 2; k++) {
        double lo = p->lo[of[1 - k]], hi = p->hi[of[1 - k]], away = SLACK * extent(p, of[1 - k]);
        if (first_beyond(s->value[of[k]], s->n, lo - away, hi + away) < s->n) return 0;
    }
    return 1;
}

static int refuse_outside(const struct samples *s, const struct problem *p, int a, size_t first,
                          struct failure *why) {
    enum { PAIRS = 3 };
    static const int axes[PAIRS][2] = {{0, 1}, {1, 2}, {0, 2}};
    const double lo = p->lo[a], hi = p->hi[a];
    char place[SAMPLES_PLACE], end[60] = "";
    int exchanged = 0;
    for (int pair = 0; pair < PAIRS; pair++)
        if ((a == axes[pair][0] || a == axes[pair][1]) && axes[pair][1] < p->dim &&
            inside_exchanged(s, p, axes[pair][0], axes[pair][1]))
            exchanged = 1 + pair;
    if (exchanged)
        snprintf(end, sizeof end, "; with %c and %c exchanged all points are inside", "xyz"[axes[exchanged - 1][0]],
                 "xyz"[axes[exchanged - 1][1]]);
    samples_place(s, first, place);
    refuse(why, STATUS_INPUT, "%.150s, line %ld: %s m: %c is outside %g to %g m%s", s->path, samples_line(s, first),
           place, "xyz"[a], lo, hi, end);
    why->exchanged = exchanged;
    return why->status;
}

static int check_inside(const struct samples *s, const struct problem *p, struct failure *why) {
    for (int a = 0; a < p->dim; a++) {
        double away = SLACK * extent(p, a);
        size_t first = first_beyond(s->value[a], s->n, p->lo[a] - away, p->hi[a] + away);
        if (first < s->n) return refuse_outside(s, p, a, first, why);
    }
    return STATUS_OK;
}

static int check_inside_shape(const struct samples *s, const struct problem *p, struct failure *why) {
    size_t first = s->n;
    char place[SAMPLES_PLACE];
#pragma omp parallel for reduction(min : first) if (s->n >= MANY)
    for (size_t i = 0; i < s->n; i++)
        if (!(shape_depth(p, samples_point(s, i, (double[DIM_MAX]){0})) >= -SLACK * p->radius[1]))
            first = i < first ? i : first;
    if (first == s->n) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: %s m: outside the %s", s->path, samples_line(s, first),
                  samples_place(s, first, place), p->shape->name);
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
    char place[SAMPLES_PLACE];
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
    return refuse(why, STATUS_INPUT, "%.150s, line %ld: the same point as in line %ld (%s m%s)", s->path,
                  samples_line(s, second), samples_line(s, first), samples_place(s, first, place),
                  p->dim == 1 ? "; a rod has one row of points" : "");
}

/* ---- Missing points ---- */

enum { MOST = 200000 };             /* points; sorting more takes too long */
static const double FULL = 0.95;    /* fraction of the positions of a lattice */
static const double REGULAR = 1e-3; /* relative to h: printed with few digits */

/* Sorts the distinct coordinates along an axis into x[s->n] and returns their number. */
static size_t distinct(const struct samples *s, const struct problem *p, int a, double *x) {
    double away = SLACK * (p->hi[a] - p->lo[a]);
    size_t n = 0;
    memcpy(x, s->value[a], s->n * sizeof *x);
    gsl_sort(x, 1, s->n);
    for (size_t i = 0; i < s->n; i++)
        if (n == 0 || x[i] > x[n - 1] + away) x[n++] = x[i];
    return n;
}

static int is_regular(const double *x, double h) {
    return fabs(x[1] - x[0] - h) <= REGULAR * h;
}

static int refuse_missing(const struct samples *s, int a, double at, struct failure *why) {
    static const char *const what[] = {"", "a point is", "a line of points is", "a layer of points is"};
    return refuse(why, STATUS_INPUT, "%.150s: %s missing at %c = %.6g m, between others at equal distances", s->path,
                  what[s->dim], "xyz"[a], at);
}

/* 1 if an interface across the axis is between two coordinates, within a part of their distance at them. */
static int has_interface(const struct image *image, int a, double lo, double hi) {
    const struct problem *p = &image->problem;
    double near = REGULAR * (hi - lo);
    return p->materials == 2 && a == image->interface_axis && lo + near < p->interface && p->interface < hi - near;
}

static int on_wall(const struct problem *p, int a, double x) {
    double away = SLACK * extent(p, a);
    return fabs(x - p->lo[a]) <= away || fabs(x - p->hi[a]) <= away;
}

/* Refuses a place without a point among the n < 5 coordinates of an axis of up to five cells of the spacing d. */
static int check_short_axis(const struct samples *s, const struct image *image, int a, const double *x, size_t n,
                            double d, struct failure *why) {
    enum { SHORT = 5 };
    const struct problem *p = &image->problem;
    if (p->shape || nearbyint(extent(p, a) / d) > SHORT) return STATUS_OK;
    for (size_t i = 1; i < n; i++) {
        double steps = (x[i] - x[0]) / d;
        if (fabs(steps - nearbyint(steps)) > REGULAR) return STATUS_OK;
    }
    double first = x[0] - d * floor((x[0] - p->lo[a]) / d + REGULAR);
    for (double at = first; at <= p->hi[a] + REGULAR * d; at += d) {
        int found = on_wall(p, a, at) || has_interface(image, a, at - d, at + d);
        for (size_t i = 0; i < n; i++) found |= fabs(x[i] - at) <= REGULAR * d;
        if (!found) return refuse_missing(s, a, at, why);
    }
    return STATUS_OK;
}

/* Refuses a gap among n coordinates along an axis that are otherwise equidistant; d is the spacing of the case. */
static int check_axis(const struct samples *s, const struct image *image, int a, const double *x, size_t n, double d,
                      struct failure *why) {
    static const double FROM_WALL = 1.25;
    const struct problem *p = &image->problem;
    if (n < 5) return check_short_axis(s, image, a, x, n, d, why);
    double first = x[1] - x[0], last = x[n - 1] - x[n - 2];
    int few = (double)n < nearbyint(extent(p, a) / d);
    if (few && is_regular(x + 1, first) && x[0] - p->lo[a] > FROM_WALL * first)
        return refuse_missing(s, a, x[0] - first, why);
    if (few && is_regular(x + n - 3, last) && p->hi[a] - x[n - 1] > FROM_WALL * last)
        return refuse_missing(s, a, x[n - 1] + last, why);
    for (size_t i = 0; i + 1 < n; i++) {
        size_t before = i > 0 ? i - 1 : i + 2,
               after = i + 2 < n ? i + 1 : i - 2; /* at an end both are on the same side */
        double h = x[before + 1] - x[before], gap = x[i + 1] - x[i], times = nearbyint(gap / h);
        if (times >= 2 && fabs(gap - times * h) <= REGULAR * h && is_regular(x + after, h) &&
            !has_interface(image, a, x[i], x[i + 1]))
            return refuse_missing(s, a, x[i] + h, why);
    }
    return STATUS_OK;
}

/* The coordinates of a position of the lattice; returns the number of walls that it is on. */
static int position(const struct problem *p, double *const x[DIM_MAX], const size_t n[DIM_MAX], size_t c,
                    double at[DIM_MAX]) {
    int walls = 0;
    for (int a = 0; a < p->dim; c /= n[a++]) {
        at[a] = x[a][c % n[a]];
        walls += on_wall(p, a, at[a]);
    }
    return walls;
}

/* Refuses a position of the lattice without a point; one on a wall only if no other lacks its point. */
static int check_places(const struct samples *s, const struct problem *p, double *const x[DIM_MAX],
                        const size_t n[DIM_MAX], struct failure *why) {
    size_t all = n[0] * n[1] * n[2], missing = 0, first = 0;
    int walls, least = 2;
    unsigned char *has = xcalloc(all, 1);
    double at[DIM_MAX];
    char layers[30] = "", where[100] = "", wall[100] = "";
    for (size_t i = 0; i < s->n; i++) {
        size_t c = 0;
        for (int a = p->dim; a-- > 0;) c = c * n[a] + gsl_interp_bsearch(x[a], s->value[a][i], 0, n[a]);
        has[c] = 1;
    }
    for (size_t c = all; c-- > 0;) {
        if (has[c] || (walls = position(p, x, n, c, at)) >= 2) continue;
        missing++;
        if (walls <= least) least = walls, first = c;
    }
    free(has);
    if (!missing) return STATUS_OK;
    position(p, x, n, first, at);
    if (p->dim == 3) snprintf(layers, sizeof layers, " by %zu layers", n[2]);
    for (int a = 0; a < p->dim; a++) {
        words_add(where, sizeof where, "%s%c = %.6g", a ? ", " : "", "xyz"[a], at[a]);
        if (on_wall(p, a, at[a]))
            words_add(wall, sizeof wall, ": the wall %c = %.6g m has points along all of it, or none", "xyz"[a],
                      at[a]);
    }
    return refuse(why, STATUS_INPUT, "%.150s: %zu point%s missing from %zu columns by %zu rows%s, at %s m%s%s",
                  s->path, missing, missing == 1 ? " is" : "s are", n[0], n[1], layers, where,
                  missing == 1 ? "" : " and elsewhere", wall);
}

int coverage_check_missing(const struct samples *s, const struct image *image, const double *d, struct failure *why) {
    const struct problem *p = &image->problem;
    double *x[DIM_MAX] = {NULL};
    size_t n[DIM_MAX] = {1, 1, 1};
    int status = STATUS_OK;
    if (s->n > MOST) return STATUS_OK;
    for (int a = 0; a < p->dim; a++) {
        x[a] = xcalloc(s->n, sizeof *x[a]);
        n[a] = distinct(s, p, a, x[a]);
    }
    if ((double)s->n >= FULL * (double)n[0] * (double)n[1] * (double)n[2]) {
        if (p->dim > 1) status = check_places(s, p, x, n, why);
        for (int a = 0; a < p->dim && !status; a++) status = check_axis(s, image, a, x[a], n[a], d[a], why);
    }
    for (int a = 0; a < p->dim; a++) free(x[a]);
    return status;
}

int coverage_check(const struct samples *s, const struct image *image, const double *d, struct failure *why) {
    const struct problem *p = &image->problem;
    size_t fewest = fewest_points(image, d);
    if (check_inside(s, p, why) || (p->shape && check_inside_shape(s, p, why))) return STATUS_INPUT;
    if (s->n < fewest)
        return refuse(why, STATUS_INPUT, "%.150s: %zu point%s where dx = %g m asks for %zu at least", s->path, s->n,
                      s->n == 1 ? "" : "s", d[0], fewest);
    if (check_gaps(s, p, d, why) || coverage_check_once(s, p, why)) return STATUS_INPUT;
    return coverage_check_missing(s, image, d, why);
}
