/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact evolution of arbitrary smooth data by sine and cosine expansion.
 *
 *     f(x, y)    = sum_mn c_mn X_m(x) Y_n(y)
 *     T(x, y, t) = sum_mn c_mn X_m(x) Y_n(y) exp(-(kappa_x q_m^2 + kappa_y r_n^2) t)
 *
 * with the further factor Z_l(z) exp(-kappa_z p_l^2 t) in a box.
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
    int dim, n[DIM_MAX];
    enum side_kind kind[DIM_MAX];
    double lo[DIM_MAX], width[DIM_MAX]; /* m */
    double kappa[DIM_MAX];              /* m^2 s^-1 */
    double *c;                          /* K, n[0] x n[1] x n[2], x fastest */
};

static int order(const struct spectral *s, int d, int m) { /* wave number of mode m along axis d, in half waves */
    return s->kind[d] == DIRICHLET ? m + 1 : m;
}

static void transform(struct spectral *s) {
    fftw_r2r_kind kind[DIM_MAX]; /* slowest axis first */
    int n[DIM_MAX], rank = s->dim;
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

/* Samples f at the cell centres; without f, normalises the transform. */
static void fill(struct spectral *s, const struct problem *p, double (*f)(const struct problem *p, const double *x)) {
    for (int k = 0; k < s->n[0] * s->n[1] * s->n[2]; k++) {
        int at[DIM_MAX] = {k % s->n[0], k / s->n[0] % s->n[1], k / s->n[0] / s->n[1]};
        double x[DIM_MAX] = {s->lo[0], s->lo[1], s->lo[2]}, factor = 1;
        for (int d = 0; d < s->dim; d++) {
            x[d] += (at[d] + 0.5) / s->n[d] * s->width[d];
            factor *= share(s, d, at[d]);
        }
        s->c[k] = f ? f(p, x) : factor * s->c[k];
    }
}

struct spectral *spectral_alloc(const struct problem *p, const int *n,
                                double (*f)(const struct problem *p, const double *x)) {
    if (p->materials != 1) return NULL;
    for (int d = 0; d < p->dim; d++)
        if (p->side[2 * d] != p->side[2 * d + 1]) return NULL;
    struct spectral *s = xcalloc(1, sizeof *s);
    s->dim = p->dim;
    for (int d = 0; d < DIM_MAX; d++) {
        s->n[d] = d < p->dim ? n[d] : 1;
        s->kind[d] = d < p->dim ? p->side[2 * d] : NEUMANN; /* constant along axes past dim */
        s->lo[d] = p->lo[d];
        s->width[d] = d < p->dim ? p->hi[d] - p->lo[d] : 1;
        s->kappa[d] = p->material[0].k[d] / p->material[0].rho_c;
    }
    s->c = xcalloc((size_t)s->n[0] * (size_t)s->n[1] * (size_t)s->n[2], sizeof *s->c);
    fill(s, p, f);
    transform(s);
    fill(s, p, NULL);
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

struct exact spectral_at(const struct spectral *s, const double *x, double t) {
    double sum = 0, rounding = 0, tail = 0, largest = 0;
    double *X = xcalloc((size_t)s->n[0], sizeof *X), *dX = xcalloc((size_t)s->n[0], sizeof *dX);
    for (int i = 0; i < s->n[0]; i++) X[i] = mode(s, 0, i, x[0], t, &dX[i]);
    for (int k = 0; k < s->n[1] * s->n[2]; k++) {
        int at[DIM_MAX] = {0, k % s->n[1], k / s->n[1]}, high = 0;
        double Y = 1, dY = 0; /* product over the other axes */
        for (int d = 1; d < s->dim; d++) {
            double error, factor = mode(s, d, at[d], x[d], t, &error);
            dY = dY * fabs(factor) + fabs(Y) * error;
            Y *= factor;
            high |= 4 * at[d] >= 3 * s->n[d];
        }
        for (int i = 0; i < s->n[0]; i++) {
            double c = s->c[k * s->n[0] + i];
            sum += c * X[i] * Y;
            rounding += fabs(c) * (dX[i] * fabs(Y) + fabs(X[i]) * dY);
            largest = fmax(largest, fabs(c));
            if (4 * i >= 3 * s->n[0] || high) tail += fabs(c);
        }
    }
    free(X);
    free(dX);
    /* The transform rounds each coefficient by a few eps of the largest; the bound adds this for the remaining
     * modes. */
    return (struct exact){.temperature = sum, .error_bound = tail + rounding + 16 * DBL_EPSILON * largest};
}
