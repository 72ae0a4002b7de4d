/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums over one neighbourhood, and the small linear systems of corrected operators.
 *
 * Matrices are at most 6 x 6.  Gauss-Jordan elimination with partial pivoting gives the inverse, and with it the
 * condition number in the 1-norm (Golub & Van Loan, section 3.4).  In units of h every entry is O(1). */
#include "solver/particles/correction.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double one_norm(int n, double A[CORRECTION_TERMS][CORRECTION_TERMS]) {
    double most = 0;
    for (int c = 0; c < n; c++) {
        double sum = 0;
        for (int r = 0; r < n; r++) sum += fabs(A[r][c]);
        most = fmax(most, sum);
    }
    return most;
}

static void swap_rows(double *a, double *b, int n) {
    for (int c = 0; c < n; c++) {
        double held = a[c];
        a[c] = b[c], b[c] = held;
    }
}

/* Computes A^-1 and returns the condition number of A; infinite if a pivot is zero or not finite. */
static double invert(int n, double given[CORRECTION_TERMS][CORRECTION_TERMS],
                     double inverse[CORRECTION_TERMS][CORRECTION_TERMS]) {
    double A[CORRECTION_TERMS][CORRECTION_TERMS];
    memcpy(A, given, sizeof A);
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) inverse[r][c] = r == c;
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int r = k + 1; r < n; r++)
            if (fabs(A[r][k]) > fabs(A[pivot][k])) pivot = r;
        if (!(fabs(A[pivot][k]) > 0)) return INFINITY;
        swap_rows(A[k], A[pivot], n);
        swap_rows(inverse[k], inverse[pivot], n);
        double scale = 1 / A[k][k];
        for (int c = 0; c < n; c++) A[k][c] *= scale, inverse[k][c] *= scale;
        for (int r = 0; r < n; r++) {
            if (r == k) continue;
            double factor = A[r][k];
            for (int c = 0; c < n; c++) A[r][c] -= factor * A[k][c], inverse[r][c] -= factor * inverse[k][c];
        }
    }
    return one_norm(n, given) * one_norm(n, inverse);
}

static int singular_matrix(const struct neighbourhood *nb, const char *what, double condition, struct failure *why) {
    char number[40] = "infinite", place[PLACE_TEXT];
    if (condition < 1e17) snprintf(number, sizeof number, "%.1e", condition);
    return refuse(why, STATUS_NUMERICAL,
                  "singular %s: particle %zu at %s has %zu neighbours, condition number %s (at most "
                  "%.0e); use a larger --h or less --jitter",
                  what, nb->i, problem_place(nb->dim, nb->x, place), nb->n, number, CORRECTION_CONDITION_MAX);
}

static inline __attribute__((always_inline)) void kernel_sums(const struct neighbourhood *nb, int dim,
                                                              enum kernel_name kernel, struct correction *c,
                                                              double G[][CORRECTION_TERMS]) {
    double unit = 1;
    for (int a = 0; a < dim; a++) unit *= nb->h;
    for (size_t j = 0; j < nb->n; j++) {
        double *s = c->s[j], r2 = 0;
        for (int a = 0; a < DIM_MAX; a++) s[a] = a < dim ? nb->d[j][a] / nb->h : 0;
        for (int a = 0; a < dim; a++) r2 += s[a] * s[a];
        double r = sqrt(r2);
        /* a particle at the same position contributes nothing to a derivative */
        c->F[j] = r > 0 ? -nb->volume / unit * kernel_slope(kernel, dim, r) / r : 0;
        for (int a = 0; a < dim; a++)
            for (int b = 0; b < dim; b++) G[a][b] += c->F[j] * s[a] * s[b];
    }
}

int correction_create(const struct neighbourhood *nb, enum kernel_name kernel, struct correction *c,
                      struct failure *why) {
    double G[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}}, inverse[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}};
    c->n = nb->n;
    if (nb->dim == 1) kernel_sums(nb, 1, kernel, c, G);
    if (nb->dim == 2) kernel_sums(nb, 2, kernel, c, G);
    if (nb->dim == 3) kernel_sums(nb, 3, kernel, c, G);
    double condition = invert(nb->dim, G, inverse);
    if (!(condition <= CORRECTION_CONDITION_MAX))
        return singular_matrix(nb, "matrix of the kernel's gradients", condition, why);
    for (int a = 0; a < DIM_MAX; a++)
        for (int b = 0; b < DIM_MAX; b++) c->inverse[a][b] = inverse[a][b];
    return STATUS_OK;
}

int correction_spans(const struct neighbourhood *nb, const double *F, struct failure *why) {
    double G[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}}, inverse[CORRECTION_TERMS][CORRECTION_TERMS] = {{0}};
    for (size_t j = 0; j < nb->n; j++)
        for (int a = 0; a < nb->dim; a++)
            for (int b = 0; b < nb->dim; b++) G[a][b] += F[j] * nb->d[j][a] * nb->d[j][b];
    double condition = invert(nb->dim, G, inverse);
    if (condition <= CORRECTION_CONDITION_MAX) return STATUS_OK;
    return singular_matrix(nb, "matrix of the kernel's gradients", condition, why);
}

int correction_target(const struct neighbourhood *nb, double target[CORRECTION_TERMS]) {
    int n = 0;
    for (int b = 0; b < nb->dim; b++)
        for (int a = 0; a <= b; a++) target[n++] = a == b ? nb->kappa[a] / (nb->h * nb->h) : 0;
    return n;
}

int correction_solve(const struct neighbourhood *nb, const char *what, int terms,
                     double K[CORRECTION_TERMS][CORRECTION_TERMS], const double *target, double *z,
                     struct failure *why) {
    double inverse[CORRECTION_TERMS][CORRECTION_TERMS];
    double condition = invert(terms, K, inverse);
    if (!(condition <= CORRECTION_CONDITION_MAX)) return singular_matrix(nb, what, condition, why);
    for (int m = 0; m < terms; m++) {
        z[m] = 0;
        for (int n = 0; n < terms; n++) z[m] += inverse[n][m] * target[n];
    }
    return STATUS_OK;
}

double correction_lattice_sum(enum kernel_name kernel, int dim, double h, double spacing, double factor,
                              double (*weight)(enum kernel_name kernel, int dim, double h, double r)) {
    int reach = (int)ceil(KERNEL_SUPPORT * h / spacing), y = dim > 1 ? reach : 0, z = dim > 2 ? reach : 0;
    double sum = 0;
    for (int k = -z; k <= z; k++)
        for (int j = -y; j <= y; j++)
            for (int i = -reach; i <= reach; i++)
                if (i) sum += weight(kernel, dim, h, hypot(hypot(i, j), k) * spacing) * factor * i * i;
    return sum;
}
