/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Local least squares, in coordinates scaled by the distance of the farthest of the nearest points. */
#include "verification/judge/interpolate.h"

#include "solver/status.h"

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

/* By dimension: degree, its monomials, the fewest points of a fit, and the most. */
static const int degree[] = {0, 5, 5, 3};
static const size_t monomials[] = {0, 6, 21, 20}, least_points[] = {0, 6, 36, 64}, most_points[] = {0, 6, 108, 192};
enum { MOST = 192, TERMS = 21 };

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
static void fill_row(int dim, const double u[DIM_MAX], gsl_matrix *A, size_t row) {
    size_t column = 0;
    for (int p = 0; p <= degree[dim]; p++)
        for (int q = 0; q <= (dim > 1 ? p : 0); q++)
            for (int r = 0; r <= (dim > 2 ? q : 0); r++)
                gsl_matrix_set(A, row, column++, pow(u[0], p - q) * pow(u[1], q - r) * pow(u[2], r));
}

static int fit(const struct interpolate *f, const double *x, const struct near *list, size_t n, double *T,
               double *gradient) {
    const int dim = f->field->dim;
    size_t terms = monomials[dim], rank;
    double scale = sqrt(list[n - 1].d2), chi2, value[MOST], coefficient[TERMS];
    gsl_matrix *A = gsl_matrix_alloc(n, terms), *cov = gsl_matrix_alloc(terms, terms);
    gsl_vector_view b = gsl_vector_view_array(value, n), c = gsl_vector_view_array(coefficient, terms);
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(n, terms);
    for (size_t k = 0; k < n; k++) {
        size_t i = list[k].i;
        double u[DIM_MAX];
        field_place(f->field, i, u);
        for (int a = 0; a < dim; a++) u[a] = (u[a] - x[a]) / scale;
        fill_row(dim, u, A, k);
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

/* Next to a wall the nearest points are on few rows along it; more points then suffice. */
int interpolate_at(const struct interpolate *f, const double *x, double *T, double *gradient, struct failure *why) {
    struct near list[MOST];
    char third[24] = "";
    const int dim = f->field->dim;
    if (dim == 3) snprintf(third, sizeof third, ", %g", x[2]);
    size_t least = least_points[dim], found = find(f, x, list, most_points[dim]);
    if (found < least)
        return refuse(why, STATUS_INPUT, "%.200s: %zu points; to interpolate between them %zu are needed", f->name,
                      found, least);
    if (!gradient && list[0].d2 <= 1e-18 * list[found - 1].d2) {
        *T = f->field->T[list[0].i];
        return STATUS_OK;
    }
    for (size_t n = least;; n = n + least < found ? n + least : found) {
        if (!fit(f, x, list, n, T, gradient)) return STATUS_OK;
        if (n == found) break;
    }
    return refuse(why, STATUS_INPUT, "%.200s: the points near %g, %g%s are on too few lines for an interpolation",
                  f->name, x[0], x[1], third);
}
