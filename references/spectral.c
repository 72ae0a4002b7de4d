/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact evolution of arbitrary smooth data by sine and cosine expansion.
 *
 *     f(x, y)    = sum_mn c_mn X_m(x) Y_n(y)
 *     T(x, y, t) = sum_mn c_mn X_m(x) Y_n(y) exp(-(kappa_x q_m^2 + kappa_y r_n^2) t)
 *
 * X_m = sin(q_m (x - lo)), q_m = m pi/(hi - lo), m >= 1, between Dirichlet sides at zero; X_m = cos, m >= 0, between
 * insulated sides.  FFTW's RODFT10 or REDFT10 (DST-II, DCT-II; Frigo and Johnson 2005) computes the c_mn from
 * samples at the cell centres; its rows are exactly these sines and cosines.  Modes beyond the last one alias onto
 * lower ones, so the size of the highest coefficients bounds the error.
 *
 * Restrictions: one material; homogeneous sides of the same kind on each axis. */
#include "references/spectral.h"

#include "solver/status.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <fftw3.h>

struct spectral {
    int dim, n[2];
    enum side_kind kind[2];
    double lo[2], width[2]; /* m */
    double kappa[2];        /* m^2 s^-1 */
    double *c;              /* K, n[0] x n[1], x fastest */
};

static int order(const struct spectral *s, int d, int m) { /* wave number of mode m along axis d, in half waves */
    return s->kind[d] == DIRICHLET ? m + 1 : m;
}

static void transform(struct spectral *s) {
    fftw_r2r_kind kind[2]; /* slowest axis first */
    int n[2], rank = s->dim;
    for (int d = 0; d < rank; d++) {
        n[rank - 1 - d] = s->n[d];
        kind[rank - 1 - d] = s->kind[d] == DIRICHLET ? FFTW_RODFT10 : FFTW_REDFT10;
    }
    fftw_plan plan;
#pragma omp critical(fftw_planner)
    plan = fftw_plan_r2r(rank, n, s->c, s->c, kind, FFTW_ESTIMATE);
    fftw_execute(plan);
#pragma omp critical(fftw_planner)
    fftw_destroy_plan(plan);
}

/* FFTW's transforms are not normalised.  Along each axis they give n times the amplitude, and twice that for the
 * last mode of the DST, which alternates, and the first of the DCT, which is constant. */
static double share(const struct spectral *s, int d, int m) {
    int doubled = s->kind[d] == DIRICHLET ? m == s->n[d] - 1 : m == 0;
    return 1.0 / (doubled ? 2 * s->n[d] : s->n[d]);
}

struct spectral *spectral_alloc(const struct problem *p, const int n[2],
                                double (*f)(const struct problem *p, const double x[2])) {
    if (p->materials != 1 || p->side[X_LO] != p->side[X_HI]) return NULL;
    if (p->dim == 2 && p->side[Y_LO] != p->side[Y_HI]) return NULL;
    struct spectral *s = xcalloc(1, sizeof *s);
    s->dim = p->dim;
    for (int d = 0; d < 2; d++) {
        s->n[d] = d < p->dim ? n[d] : 1;
        s->kind[d] = d < p->dim ? p->side[2 * d] : NEUMANN; /* a rod is constant along y */
        s->lo[d] = p->lo[d];
        s->width[d] = d < p->dim ? p->hi[d] - p->lo[d] : 1;
        s->kappa[d] = p->material[0].k[d] / p->material[0].rho_c;
    }
    s->c = xcalloc((size_t)s->n[0] * (size_t)s->n[1], sizeof *s->c);
    for (int j = 0; j < s->n[1]; j++)
        for (int i = 0; i < s->n[0]; i++) {
            double x[2] = {s->lo[0] + (i + 0.5) / s->n[0] * s->width[0],
                           s->lo[1] + (j + 0.5) / s->n[1] * s->width[1]};
            s->c[j * s->n[0] + i] = f(p, x);
        }
    transform(s);
    for (int j = 0; j < s->n[1]; j++)
        for (int i = 0; i < s->n[0]; i++)
            s->c[j * s->n[0] + i] *= share(s, 0, i) * (s->dim == 2 ? share(s, 1, j) : 1);
    return s;
}

void spectral_free(struct spectral *s) {
    if (!s) return;
    free(s->c);
    free(s);
}

/* Value at x of mode m of axis d after the time t; *error is the rounding error of its phase. */
static double mode(const struct spectral *s, int d, int m, double x, double t, double *error) {
    double q = order(s, d, m) * M_PI / s->width[d], phase = q * (x - s->lo[d]);
    double decay = exp(-s->kappa[d] * q * q * t);
    *error = decay * (2 + fabs(phase)) * DBL_EPSILON;
    return decay * (s->kind[d] == DIRICHLET ? sin(phase) : cos(phase));
}

struct exact spectral_at(const struct spectral *s, const double x[2], double t) {
    double sum = 0, rounding = 0, tail = 0, largest = 0;
    double *X = xcalloc((size_t)s->n[0], sizeof *X), *dX = xcalloc((size_t)s->n[0], sizeof *dX);
    for (int i = 0; i < s->n[0]; i++) X[i] = mode(s, 0, i, x[0], t, &dX[i]);
    for (int j = 0; j < s->n[1]; j++) {
        double dY = 0, Y = s->dim == 2 ? mode(s, 1, j, x[1], t, &dY) : 1;
        for (int i = 0; i < s->n[0]; i++) {
            double c = s->c[j * s->n[0] + i];
            sum += c * X[i] * Y;
            rounding += fabs(c) * (dX[i] * fabs(Y) + fabs(X[i]) * dY);
            largest = fmax(largest, fabs(c));
            if (4 * i >= 3 * s->n[0] || (s->dim == 2 && 4 * j >= 3 * s->n[1])) tail += fabs(c);
        }
    }
    free(X);
    free(dX);
    /* The transform rounds each coefficient by a few eps of the largest; the bound adds this for the remaining
     * modes. */
    return (struct exact){.temperature = sum, .error_bound = tail + rounding + 16 * DBL_EPSILON * largest};
}
