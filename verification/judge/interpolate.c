/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Local least squares, in coordinates scaled by the distance of the farthest of the nearest points; on rows and
 * columns products of Lagrange's polynomials. */
#include "verification/judge/interpolate.h"

#include "solver/status.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct fitting {
    int degree;
    size_t terms, least, most; /* its monomials; the fewest points of a fit, and the most */
};

/* By dimension. */
static const struct fitting plain[] = {{0}, {5, 6, 6, 6}, {5, 21, 36, 108}, {3, 20, 64, 192}},
                            sure[] = {{0}, {5, 6, 6, 6}, {5, 21, 36, 108}, {4, 35, 80, 192}};
enum { MOST = 192, TERMS = 35 };

struct near {
    double d2; /* m^2 */
    size_t i;
};

static size_t box_along(const struct interpolate *f, int a, double x) {
    double at = (x - f->lo[a]) / f->side[a];
    return at <= 0 ? 0 : at >= (double)f->count[a] ? f->count[a] - 1 : (size_t)at;
}

static size_t box_of(const struct interpolate *f, size_t i) {
    size_t box = 0;
    double x[DIM_MAX];
    field_place(f->field, i, x);
    for (int a = f->field->dim; a-- > 0;) box = box * f->count[a] + box_along(f, a, x[a]);
    return box;
}

struct interpolate interpolate_begin(const char *name, const struct field *field) {
    struct interpolate f = {.name = name, .field = field, .from = -INFINITY, .to = INFINITY};
    const int dim = field->dim;
    const size_t n = field->n;
    double each = fmax(1, floor(pow((double)n / 2, 1.0 / dim)));
    f.count[0] = f.count[1] = f.count[2] = 1;
    for (int a = 0; a < dim; a++) {
        double lo, hi;
        gsl_stats_minmax(&lo, &hi, field->x[a], 1, field->shape[0] ? (size_t)field->shape[a] : n);
        f.lo[a] = lo;
        f.side[a] = hi > lo ? (hi - lo) / each : 1;
        f.count[a] = (size_t)each;
    }
    size_t boxes = f.count[0] * f.count[1] * f.count[2];
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
    for (int a = 0; a < DIM_MAX; a++) free(f->line[a]);
    free(f->value);
    *f = (struct interpolate){0};
}

/* Merges the points of a box into the list of the nearest `most`, in ascending order; returns its new length. */
static size_t take_box(const struct interpolate *f, const double *x, size_t box, struct near *list, size_t n,
                       size_t most) {
    for (size_t k = f->first[box]; k < f->first[box + 1]; k++) {
        size_t i = f->point[k];
        double d2 = 0, there[DIM_MAX];
        field_place(f->field, i, there);
        for (int a = 0; a < f->field->dim; a++) d2 += (there[a] - x[a]) * (there[a] - x[a]);
        if (there[0] < f->from || there[0] > f->to || (n == most && !(d2 < list[n - 1].d2))) continue;
        size_t at = n < most ? n++ : n - 1;
        for (; at > 0 && d2 < list[at - 1].d2; at--) list[at] = list[at - 1];
        list[at] = (struct near){d2, i};
    }
    return n;
}

/* Searches rings of boxes around that of x until everything beyond is farther than the end of the list. */
static size_t find(const struct interpolate *f, const double *x, struct near *list, size_t most) {
    size_t n = 0, last = 0;
    long c[DIM_MAX] = {0}, wide[DIM_MAX] = {0};
    double least = INFINITY;
    for (int a = 0; a < f->field->dim; a++) {
        c[a] = (long)box_along(f, a, x[a]);
        last = f->count[a] > last ? f->count[a] : last;
        least = fmin(least, f->side[a]);
    }
    for (long ring = 0; ring <= (long)last; ring++) {
        for (int a = 0; a < f->field->dim; a++) wide[a] = ring;
        for (long k = -wide[2]; k <= wide[2]; k++)
            for (long j = -wide[1]; j <= wide[1]; j++)
                for (long i = -ring; i <= ring; i += labs(j) == ring || labs(k) == ring || ring == 0 ? 1 : 2 * ring) {
                    long at[DIM_MAX] = {c[0] + i, c[1] + j, c[2] + k}, inside = 1;
                    for (int a = 0; a < f->field->dim; a++) inside &= at[a] >= 0 && at[a] < (long)f->count[a];
                    if (!inside) continue;
                    size_t box = (size_t)(at[0] + (long)f->count[0] * (at[1] + (long)f->count[1] * at[2]));
                    n = take_box(f, x, box, list, n, most);
                }
        double clear = least * (double)ring;
        if (n == most && list[n - 1].d2 <= clear * clear) break;
    }
    return n;
}

/* A row of the monomials of u.  Column 1 + a gives the derivative along axis a at the origin. */
static void fill_row(int dim, int degree, const double u[DIM_MAX], gsl_matrix *A, size_t row) {
    size_t column = 0;
    for (int p = 0; p <= degree; p++)
        for (int q = 0; q <= (dim > 1 ? p : 0); q++)
            for (int r = 0; r <= (dim > 2 ? q : 0); r++)
                gsl_matrix_set(A, row, column++, pow(u[0], p - q) * pow(u[1], q - r) * pow(u[2], r));
}

/* The first monomials are those of a lower degree. */
static int fit(const struct interpolate *f, const double *x, const struct near *list, size_t n, int degree,
               size_t terms, double *T, double *gradient) {
    const int dim = f->field->dim;
    size_t rank;
    double scale = sqrt(list[n - 1].d2), chi2, value[MOST], coefficient[TERMS];
    gsl_matrix *A = gsl_matrix_alloc(n, terms), *cov = gsl_matrix_alloc(terms, terms);
    gsl_vector_view b = gsl_vector_view_array(value, n), c = gsl_vector_view_array(coefficient, terms);
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(n, terms);
    for (size_t k = 0; k < n; k++) {
        size_t i = list[k].i;
        double u[DIM_MAX];
        field_place(f->field, i, u);
        for (int a = 0; a < dim; a++) u[a] = (u[a] - x[a]) / scale;
        fill_row(dim, degree, u, A, k);
        value[k] = f->field->T[i];
    }
    int bad = gsl_multifit_linear_tsvd(A, &b.vector, 1e-9, &c.vector, cov, &chi2, &rank, w) || rank < terms;
    *T = coefficient[0];
    for (int a = 0; gradient && a < dim; a++) gradient[a] = coefficient[1 + a] / scale;
    gsl_multifit_linear_free(w);
    gsl_matrix_free(cov);
    gsl_matrix_free(A);
    return bad;
}

/* Next to a wall the nearest points are on few rows along it; more points then suffice.  below: NULL, or the value by
 * one degree less through the same points. */
static int value_at(const struct interpolate *f, const struct fitting *by, const double *x, double *T,
                    double *gradient, double *below, struct failure *why) {
    struct near list[MOST];
    char third[24] = "";
    const int dim = f->field->dim, degree = by->degree;
    if (dim == 3) snprintf(third, sizeof third, ", %g", x[2]);
    size_t least = by->least, found = find(f, x, list, by->most),
           lower = by->terms * (size_t)degree / (size_t)(degree + dim);
    if (found < least)
        return refuse(why, STATUS_INPUT, "%.200s: %zu points; to interpolate between them %zu are needed", f->name,
                      found, least);
    if (!gradient && list[0].d2 <= 1e-18 * list[found - 1].d2) {
        *T = f->field->T[list[0].i];
        if (below) *below = *T;
        return STATUS_OK;
    }
    for (size_t n = least;; n = n + least < found ? n + least : found) {
        if (!fit(f, x, list, n, degree, by->terms, T, gradient) &&
            !(below && fit(f, x, list, n, degree - 1, lower, below, NULL)))
            return STATUS_OK;
        if (n == found) break;
    }
    return refuse(why, STATUS_INPUT, "%.200s: the points near %g, %g%s are on too few lines for an interpolation",
                  f->name, x[0], x[1], third);
}

int interpolate_at(const struct interpolate *f, const double *x, double *T, double *gradient, struct failure *why) {
    return value_at(f, &plain[f->field->dim], x, T, gradient, NULL, why);
}

/* ---- Rows and columns ---- */

enum { LINES = 8, FEWER = 2, LINES_LEAST = 4 };

/* Sorts the distinct coordinates of n points into line[n] and returns their number. */
static size_t distinct(const double *x, size_t n, double *line) {
    static const double SLACK = 1e-9; /* relative to the extent */
    size_t count = 0;
    memcpy(line, x, n * sizeof *line);
    gsl_sort(line, 1, n);
    double away = SLACK * (line[n - 1] - line[0]);
    for (size_t i = 0; i < n; i++)
        if (count == 0 || line[i] > line[count - 1] + away) line[count++] = line[i];
    return count;
}

static size_t line_nearest(const double *line, size_t n, double x) {
    size_t i = gsl_interp_bsearch(line, x, 0, n - 1);
    return i + (x - line[i] > line[i + 1] - x);
}

/* Puts T of each point to its crossing; 0 if two points have one. */
static int fill_crossings(struct interpolate *f) {
    double x[DIM_MAX];
    size_t n = f->field->n;
    f->value = xcalloc(n, sizeof *f->value);
    for (size_t i = 0; i < n; i++) f->value[i] = NAN;
    for (size_t i = 0; i < n; i++) {
        size_t at = 0;
        field_place(f->field, i, x);
        for (int a = f->field->dim; a-- > 0;) at = at * f->along[a] + line_nearest(f->line[a], f->along[a], x[a]);
        if (!isnan(f->value[at])) return 0;
        f->value[at] = f->field->T[i];
    }
    return 1;
}

void interpolate_find_rows(struct interpolate *f) {
    double crossings = 1;
    for (int a = 0; a < f->field->dim; a++) {
        f->line[a] = xcalloc(f->field->n, sizeof *f->line[a]);
        f->along[a] = distinct(f->field->x[a], f->field->n, f->line[a]);
        crossings *= f->along[a] < LINES_LEAST ? 0 : (double)f->along[a];
    }
    if (crossings != (double)f->field->n || !fill_crossings(f)) f->along[0] = 0;
}

/* Weights at x of Lagrange's polynomial through the m lines around it, of n; returns the first of them. */
static size_t lagrange(const double *line, size_t n, double x, size_t m, double *w) {
    size_t i = gsl_interp_bsearch(line, x, 0, n - 1), before = (m - 1) / 2, first = i < before ? 0 : i - before;
    if (first > n - m) first = n - m;
    line += first;
    for (size_t k = 0; k < m; k++) {
        w[k] = 1;
        for (size_t l = 0; l < m; l++)
            if (l != k) w[k] *= (x - line[l]) / (line[k] - line[l]);
    }
    return first;
}

/* Through LINES lines along each axis, or all, less `fewer`. */
static double product(const struct interpolate *f, const double *x, size_t fewer) {
    double w[DIM_MAX][LINES] = {{1}, {1}, {1}}, sum = 0;
    size_t m[DIM_MAX] = {1, 1, 1}, first[DIM_MAX] = {0};
    for (int a = 0; a < f->field->dim; a++) {
        m[a] = (f->along[a] < LINES ? f->along[a] : LINES) - fewer;
        first[a] = lagrange(f->line[a], f->along[a], x[a], m[a], w[a]);
    }
    for (size_t k = 0; k < m[2]; k++)
        for (size_t j = 0; j < m[1]; j++) {
            size_t row = f->along[0] * (first[1] + j + f->along[1] * (first[2] + k));
            for (size_t i = 0; i < m[0]; i++) sum += w[0][i] * w[1][j] * w[2][k] * f->value[row + first[0] + i];
        }
    return sum;
}

int interpolate_sure(const struct interpolate *f, const double *x, double *T, double *off, struct failure *why) {
    double below;
    if (f->along[0]) {
        *T = product(f, x, 0);
        below = product(f, x, FEWER);
    } else if (value_at(f, &sure[f->field->dim], x, T, NULL, &below, why))
        return why->status;
    *off = fabs(*T - below);
    return STATUS_OK;
}
