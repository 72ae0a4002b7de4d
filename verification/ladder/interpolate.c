/* Local least squares, in coordinates scaled by the distance of the farthest of the nearest points. */
#include "verification/ladder/interpolate.h"

#include "solver/status.h"
#include "verification/foreign/samples.h"

#include <gsl/gsl_multifit.h>
#include <math.h>
#include <stdlib.h>

enum { DEGREE = 5, ROD = DEGREE + 1, RECTANGLE = 36, MOST = 108, TERMS = 21 };

struct near {
    double d2; /* m^2 */
    size_t i;
};

/* The `most` nearest points, nearest first: insertion into a short list. */
static void find(const struct samples *s, const double x[2], struct near *list, size_t most) {
    size_t n = 0;
    for (size_t i = 0; i < s->n; i++) {
        double dx = s->value[COLUMN_X][i] - x[0], dy = s->dim == 2 ? s->value[COLUMN_Y][i] - x[1] : 0;
        double d2 = dx * dx + dy * dy;
        if (n == most && !(d2 < list[n - 1].d2)) continue;
        size_t at = n < most ? n++ : n - 1;
        for (; at > 0 && d2 < list[at - 1].d2; at--) list[at] = list[at - 1];
        list[at] = (struct near){d2, i};
    }
}

static int fit(const struct samples *s, const double x[2], const struct near *list, size_t n, double *T) {
    size_t terms = s->dim == 2 ? TERMS : ROD;
    double scale = sqrt(list[n - 1].d2), chi2;
    size_t rank;
    gsl_matrix *A = gsl_matrix_alloc(n, terms), *cov = gsl_matrix_alloc(terms, terms);
    gsl_vector *b = gsl_vector_alloc(n), *c = gsl_vector_alloc(terms);
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(n, terms);
    for (size_t k = 0; k < n; k++) {
        size_t i = list[k].i, column = 0;
        double u = (s->value[COLUMN_X][i] - x[0]) / scale;
        double v = s->dim == 2 ? (s->value[COLUMN_Y][i] - x[1]) / scale : 0;
        for (int p = 0; p <= DEGREE; p++)
            for (int q = 0; q <= (s->dim == 2 ? p : 0); q++)
                gsl_matrix_set(A, k, column++, s->dim == 2 ? pow(u, p - q) * pow(v, q) : pow(u, p));
        gsl_vector_set(b, k, s->value[COLUMN_T][i]);
    }
    int bad = gsl_multifit_linear_tsvd(A, b, 1e-9, c, cov, &chi2, &rank, w) || rank < terms;
    *T = gsl_vector_get(c, 0);
    gsl_multifit_linear_free(w);
    gsl_vector_free(c);
    gsl_vector_free(b);
    gsl_matrix_free(cov);
    gsl_matrix_free(A);
    return bad;
}

/* Beside a wall the nearest points have few rows along it; with more of them there are enough. */
int interpolate_at(const struct samples *s, const double x[2], double *T, struct failure *why) {
    struct near list[MOST];
    size_t least = s->dim == 2 ? RECTANGLE : ROD, most = s->dim == 2 ? MOST : ROD;
    if (s->n < least)
        return refuse(why, STATUS_INPUT, "%.200s: %zu points; to interpolate between them %zu are needed", s->path,
                      s->n, least);
    if (most > s->n) most = s->n;
    find(s, x, list, most);
    if (list[0].d2 <= 1e-18 * list[most - 1].d2) {
        *T = s->value[COLUMN_T][list[0].i];
        return STATUS_OK;
    }
    for (size_t n = least; n <= most; n += least)
        if (!fit(s, x, list, n, T)) return STATUS_OK;
    return refuse(why, STATUS_INPUT,
                  "%.200s: the points near %g, %g lie on too few lines to interpolate between them", s->path, x[0],
                  x[1]);
}
