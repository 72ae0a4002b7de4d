/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields as sums of products: Gaussian elimination with complete pivoting, stopped at round-off.
 *
 * Each step uses the row and the column of the largest residual, X_r = R(., j*), Y_r = R(i*, .) / R(i*, j*).  The
 * residual R = F - sum_r X_r Y_r is recomputed row by row, so F is neither changed nor copied.  Every value of F is
 * checked.  A row equal to the previous one, which is common in wall values and steps, has the same residuals and is
 * skipped. */
#include "solver/time/products.h"

#include "solver/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { APART = 8 }; /* independent maxima, which hide the latency */

/* Residual R(., j) in `row`. */
static void residual_row(const struct products *p, const double *F, int j, double *restrict row) {
    size_t nx = (size_t)p->n[0];
    for (size_t i = 0; i < nx; i++) row[i] = F[(size_t)j * nx + i];
    for (int r = 0; r < p->rank; r++) {
        const double *restrict X = p->factor[0] + (size_t)r * nx;
        double y = p->factor[1][r * p->n[1] + j];
        if (y == 0) continue;
        for (size_t i = 0; i < nx; i++) row[i] -= y * X[i];
    }
}

/* max |row|; NaN if a value is not finite. */
static double largest_in_row(const double *restrict row, size_t n) {
    double most[APART] = {0}, zero[APART] = {0}, all = 0, none = 0;
    size_t i = 0;
    for (; i + APART <= n; i += APART)
        for (size_t k = 0; k < APART; k++) {
            double size = fabs(row[i + k]);
            most[k] = size > most[k] ? size : most[k];
            zero[k] += 0 * size;
        }
    for (; i < n; i++) all = fmax(all, fabs(row[i])), none += 0 * row[i];
    for (size_t k = 0; k < APART; k++) all = fmax(all, most[k]), none += zero[k];
    return all + none;
}

/* repeats[j]: 1 if row j equals the previous row, bit for bit. */
static char *mark_repeats(const double *F, const int n[2]) {
    char *repeats = xcalloc((size_t)n[1], 1);
    size_t nx = (size_t)n[0];
    for (int j = 1; j < n[1]; j++)
        repeats[j] = memcmp(F + (size_t)j * nx, F + (size_t)(j - 1) * nx, nx * sizeof *F) == 0;
    return repeats;
}

/* Largest |R| and its row *at; NaN if a value is not finite. */
static double largest_residual(const struct products *p, const double *F, const char *repeats, double *row, int *at) {
    double most = -1;
    for (int j = 0; j < p->n[1]; j++) {
        if (repeats[j]) continue;
        residual_row(p, F, j, row);
        double size = largest_in_row(row, (size_t)p->n[0]);
        if (isnan(size)) return size;
        if (size > most) most = size, *at = j;
    }
    return most;
}

static void add_product(struct products *p, const double *F, int j) {
    size_t nx = (size_t)p->n[0], ny = (size_t)p->n[1], r = (size_t)p->rank, i = 0;
    double *X = p->factor[0] + r * nx, *Y = p->factor[1] + r * ny;
    residual_row(p, F, j, X);
    for (size_t k = 0; k < nx; k++)
        if (fabs(X[k]) > fabs(X[i])) i = k;
    for (size_t k = 0; k < ny; k++) {
        double R = F[k * nx + i];
        for (size_t s = 0; s < r; s++) R -= p->factor[0][s * nx + i] * p->factor[1][s * ny + k];
        Y[k] = R / X[i];
    }
    p->rank++;
}

int products_split(const double *F, const int n[2], double tolerance, int most, struct products *p) {
    double *row = xcalloc((size_t)n[0], sizeof *row), size, all = 0;
    char *repeats = mark_repeats(F, n);
    int at = 0;
    *p = (struct products){.n = {n[0], n[1]}};
    for (int a = 0; a < 2; a++) p->factor[a] = xcalloc((size_t)most * (size_t)n[a], sizeof *p->factor[a]);
    for (;;) {
        size = largest_residual(p, F, repeats, row, &at);
        if (p->rank == 0) all = size;
        if (!(size > tolerance * all) || p->rank == most) break;
        add_product(p, F, at);
    }
    free(row);
    free(repeats);
    if (size <= tolerance * all) return 1;
    products_free(p);
    return 0;
}

void products_join(const struct products *p, double *F) {
    size_t nx = (size_t)p->n[0], ny = (size_t)p->n[1];
    for (size_t j = 0; j < ny; j++) {
        double *restrict row = F + j * nx;
        for (size_t i = 0; i < nx; i++) row[i] = 0;
        for (size_t r = 0; r < (size_t)p->rank; r++) {
            const double *restrict X = p->factor[0] + r * nx;
            double y = p->factor[1][r * ny + j];
            for (size_t i = 0; i < nx; i++) row[i] += y * X[i];
        }
    }
}

void products_free(struct products *p) {
    for (int a = 0; a < 2; a++) free(p->factor[a]);
    *p = (struct products){0};
}
