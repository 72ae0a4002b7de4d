/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Local least squares, in coordinates scaled by the distance of the farthest of the nearest points. */
#include "verification/run/interpolate.h"

#include "solver/status.h"

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

enum { DEGREE = 5, ROD = DEGREE + 1, RECTANGLE = 36, MOST = 108, TERMS = 21 };

struct near {
    double d2; /* m^2 */
    size_t i;
};

static size_t box_along(const struct interpolate *f, int a, double x) {
    double at = (x - f->lo[a]) / f->side[a];
    return at <= 0 ? 0 : at >= (double)f->count[a] ? f->count[a] - 1 : (size_t)at;
}

static size_t box_of(const struct interpolate *f, size_t i) {
    return box_along(f, 0, f->x[i]) + (f->dim == 2 ? f->count[0] * box_along(f, 1, f->y[i]) : 0);
}

struct interpolate interpolate_begin(const char *name, int dim, size_t n, const double *x, const double *y,
                                     const double *T) {
    struct interpolate f = {
        .name = name, .dim = dim, .n = n, .x = x, .y = y, .T = T, .from = -INFINITY, .to = INFINITY};
    double each = fmax(1, floor(pow((double)n / 2, 1.0 / dim)));
    f.count[0] = f.count[1] = 1;
    for (int a = 0; a < dim; a++) {
        const double *at = a ? y : x;
        double lo, hi;
        gsl_stats_minmax(&lo, &hi, at, 1, n);
        f.lo[a] = lo;
        f.side[a] = hi > lo ? (hi - lo) / each : 1;
        f.count[a] = (size_t)each;
    }
    size_t boxes = f.count[0] * f.count[1];
    f.first = xcalloc(boxes + 2, sizeof *f.first);
    f.point = xcalloc(n, sizeof *f.point);
    for (size_t i = 0; i < n; i++) f.first[box_of(&f, i) + 2]++;
    for (size_t b = 2; b <= boxes; b++) f.first[b + 1] += f.first[b];
    for (size_t i = 0; i < n; i++) f.point[f.first[box_of(&f, i) + 1]++] = i;
    return f;
}

void interpolate_end(struct interpolate *f) {
    free(f->first);
    free(f->point);
    *f = (struct interpolate){0};
}

/* Merges the points of a box into the list of the nearest `most`, in ascending order; returns its new length. */
static size_t take_box(const struct interpolate *f, const double x[2], size_t box, struct near *list, size_t n,
                       size_t most) {
    for (size_t k = f->first[box]; k < f->first[box + 1]; k++) {
        size_t i = f->point[k];
        double dx = f->x[i] - x[0], dy = f->dim == 2 ? f->y[i] - x[1] : 0, d2 = dx * dx + dy * dy;
        if (f->x[i] < f->from || f->x[i] > f->to || (n == most && !(d2 < list[n - 1].d2))) continue;
        size_t at = n < most ? n++ : n - 1;
        for (; at > 0 && d2 < list[at - 1].d2; at--) list[at] = list[at - 1];
        list[at] = (struct near){d2, i};
    }
    return n;
}

/* Searches rings of boxes around that of x until everything beyond is farther than the end of the list. */
static size_t find(const struct interpolate *f, const double x[2], struct near *list, size_t most) {
    size_t n = 0, last = f->count[0] > f->count[1] ? f->count[0] : f->count[1];
    long c[2] = {(long)box_along(f, 0, x[0]), f->dim == 2 ? (long)box_along(f, 1, x[1]) : 0};
    double least = f->dim == 2 ? fmin(f->side[0], f->side[1]) : f->side[0];
    for (long ring = 0; ring <= (long)last; ring++) {
        for (long j = -ring; j <= ring; j++)
            for (long i = -ring; i <= ring; i += labs(j) == ring || ring == 0 ? 1 : 2 * ring) {
                long at[2] = {c[0] + i, c[1] + j};
                if (at[0] < 0 || at[1] < 0 || at[0] >= (long)f->count[0] || at[1] >= (long)f->count[1]) continue;
                n = take_box(f, x, (size_t)at[0] + f->count[0] * (size_t)at[1], list, n, most);
            }
        double clear = least * (double)ring;
        if (n == most && list[n - 1].d2 <= clear * clear) break;
    }
    return n;
}

/* A row of the monomials of (u, v).  Columns 1 and 2 give the derivatives at the origin. */
static void monomials(int dim, double u, double v, gsl_matrix *A, size_t row) {
    size_t column = 0;
    for (int p = 0; p <= DEGREE; p++)
        for (int q = 0; q <= (dim == 2 ? p : 0); q++) gsl_matrix_set(A, row, column++, pow(u, p - q) * pow(v, q));
}

static int fit(const struct interpolate *f, const double x[2], const struct near *list, size_t n, double *T,
               double gradient[2]) {
    size_t terms = f->dim == 2 ? TERMS : ROD, rank;
    double scale = sqrt(list[n - 1].d2), chi2, value[MOST], coefficient[TERMS];
    gsl_matrix *A = gsl_matrix_alloc(n, terms), *cov = gsl_matrix_alloc(terms, terms);
    gsl_vector_view b = gsl_vector_view_array(value, n), c = gsl_vector_view_array(coefficient, terms);
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(n, terms);
    for (size_t k = 0; k < n; k++) {
        size_t i = list[k].i;
        monomials(f->dim, (f->x[i] - x[0]) / scale, f->dim == 2 ? (f->y[i] - x[1]) / scale : 0, A, k);
        value[k] = f->T[i];
    }
    int bad = gsl_multifit_linear_tsvd(A, &b.vector, 1e-9, &c.vector, cov, &chi2, &rank, w) || rank < terms;
    *T = coefficient[0];
    for (int a = 0; gradient && a < f->dim; a++) gradient[a] = coefficient[1 + a] / scale;
    gsl_multifit_linear_free(w);
    gsl_matrix_free(cov);
    gsl_matrix_free(A);
    return bad;
}

/* Next to a wall the nearest points are on few rows along it; more points then suffice. */
int interpolate_at(const struct interpolate *f, const double x[2], double *T, double gradient[2],
                   struct failure *why) {
    struct near list[MOST];
    size_t least = f->dim == 2 ? RECTANGLE : ROD, found = find(f, x, list, f->dim == 2 ? MOST : ROD);
    if (found < least)
        return refuse(why, STATUS_INPUT, "%.200s: %zu points; to interpolate between them %zu are needed", f->name,
                      found, least);
    if (!gradient && list[0].d2 <= 1e-18 * list[found - 1].d2) {
        *T = f->T[list[0].i];
        return STATUS_OK;
    }
    for (size_t n = least;; n = n + least < found ? n + least : found) {
        if (!fit(f, x, list, n, T, gradient)) return STATUS_OK;
        if (n == found) break;
    }
    return refuse(why, STATUS_INPUT, "%.200s: the points near %g, %g are on too few lines for an interpolation",
                  f->name, x[0], x[1]);
}
