/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric SPH: derivative weights from a symmetric moment matrix, for any Taylor order p (Song eqs. 9-13).
 *
 * With the scaled monomials P_k = (x/h)^a (y/h)^b (z/h)^c / (a! b! c!), 1 <= a + b + c <= p, and W_k = P_k W:
 *   M u = b,   M_kl = sum_j P_k P_l W,   b_k = sum_j P_k W (f_j - f_i),   u_k = h^(a+b+c) D^(a,b,c) f.
 * The derivative sum_k t_k u_k has the weights w_j = W_j (z .  P_j) with M z = t, since M is symmetric.  Equal
 * particle volumes cancel, and so does the normalisation of the kernel.  No kernel derivative is needed.  In units
 * of h every entry of M is O(1) for any spacing. */
#include "solver/particles/ssph.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <stdio.h>

static int terms_of(int dim, int order) {
    int plane = (order + 1) * (order + 2) / 2;
    return dim == 1 ? order : dim == 2 ? plane - 1 : plane * (order + 3) / 3 - 1;
}

#define INLINE static inline __attribute__((always_inline))

INLINE void monomials(int dim, int order, const double *s, double *P) {
    double power[DIM_MAX][SSPH_ORDER_MAX + 1]; /* s^k / k! */
    for (int a = 0; a < dim; a++) {
        power[a][0] = 1;
        for (int k = 1; k <= order; k++) power[a][k] = power[a][k - 1] * s[a] / k;
    }
    for (int degree = 1; degree <= order; degree++)
        for (int c = 0; c <= (dim == 3 ? degree : 0); c++)
            for (int b = 0; b <= (dim > 1 ? degree - c : 0); b++) {
                double P_k = power[0][degree - b - c];
                if (dim > 1) P_k *= power[1][b];
                if (dim > 2) P_k *= power[2][c];
                *P++ = P_k;
            }
}

/* Position of neighbour j in units of h; returns its distance. */
INLINE double scaled(const struct neighbourhood *nb, int dim, size_t j, double *s) {
    double r2 = 0;
    for (int a = 0; a < dim; a++) s[a] = nb->d[j][a] / nb->h, r2 += s[a] * s[a];
    return sqrt(r2);
}

INLINE void assemble_terms(const struct neighbourhood *nb, enum kernel_name kernel, int dim, int order,
                           double *matrix, double *W) {
    int terms = terms_of(dim, order);
    double P[SSPH_TERMS_MAX], s[DIM_MAX];
    for (int k = 0; k < terms * terms; k++) matrix[k] = 0;
    for (size_t j = 0; j < nb->n; j++) {
        W[j] = kernel_value(kernel, dim, scaled(nb, dim, j, s));
        monomials(dim, order, s, P);
        for (int k = 0; k < terms; k++)
            for (int l = 0; l <= k; l++) matrix[k * terms + l] += P[k] * P[l] * W[j];
    }
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < k; l++) matrix[l * terms + k] = matrix[k * terms + l];
}

/* M (terms x terms) and W_j; the usual loop lengths are unrolled. */
static void assemble_moments(const struct neighbourhood *nb, enum kernel_name kernel, int order, double *matrix,
                             double *W) {
    if (nb->dim == 2 && order == 2)
        assemble_terms(nb, kernel, 2, 2, matrix, W);
    else if (nb->dim == 3 && order == 2)
        assemble_terms(nb, kernel, 3, 2, matrix, W);
    else
        assemble_terms(nb, kernel, nb->dim, order, matrix, W);
}

/* w_j = W_j (z . P_j) */
INLINE void combine_terms(const struct neighbourhood *nb, int dim, int order, const double *W, const double *z,
                          double *w) {
    int terms = terms_of(dim, order);
    double P[SSPH_TERMS_MAX], s[DIM_MAX];
    for (size_t j = 0; j < nb->n; j++) {
        double sum = 0;
        scaled(nb, dim, j, s);
        monomials(dim, order, s, P);
        for (int k = 0; k < terms; k++) sum += z[k] * P[k];
        w[j] = W[j] * sum;
    }
}

static void combine(const struct neighbourhood *nb, int order, const double *W, const double *z, double *w) {
    if (nb->dim == 2 && order == 2)
        combine_terms(nb, 2, 2, W, z, w);
    else if (nb->dim == 3 && order == 2)
        combine_terms(nb, 3, 2, W, z, w);
    else
        combine_terms(nb, nb->dim, order, W, z, w);
}

/* Solves M z = b in place from the factor L, with the diagonal stored as reciprocals. */
INLINE void solve_terms(int terms, const double *L, double *z) {
    for (int i = 0; i < terms; i++) {
        for (int k = 0; k < i; k++) z[i] -= L[i * terms + k] * z[k];
        z[i] *= L[i * terms + i];
    }
    for (int i = terms - 1; i >= 0; i--) {
        for (int k = i + 1; k < terms; k++) z[i] -= L[k * terms + i] * z[k];
        z[i] *= L[i * terms + i];
    }
}

/* M = L L^T in place, L in the lower triangle.  Returns the condition number of M in the 1-norm; infinite if M is
 * singular or indefinite.  GSL's factorisation and norm estimate are designed for large matrices and would dominate
 * the cost here. */
INLINE double factor_terms(int terms, double *M) {
    double size = 0, inverse = 0;
    for (int k = 0; k < terms; k++) {
        double sum = 0;
        for (int l = 0; l < terms; l++) sum += fabs(M[k * terms + l]);
        size = fmax(size, sum);
    }
    for (int j = 0; j < terms; j++)
        for (int i = j; i < terms; i++) {
            double sum = M[i * terms + j];
            for (int k = 0; k < j; k++) sum -= M[i * terms + k] * M[j * terms + k];
            if (i == j && !(sum > 0)) return INFINITY;
            M[i * terms + j] = i == j ? 1 / sqrt(sum) : sum * M[j * terms + j];
        }
    for (int k = 0; k < terms; k++) {
        double column[SSPH_TERMS_MAX], sum = 0;
        for (int l = 0; l < terms; l++) column[l] = l == k;
        solve_terms(terms, M, column);
        for (int l = 0; l < terms; l++) sum += fabs(column[l]);
        inverse = fmax(inverse, sum);
    }
    return size * inverse;
}

static double factor(int terms, double *M) {
    return terms == 5 ? factor_terms(5, M) : terms == 9 ? factor_terms(9, M) : factor_terms(terms, M);
}

static void solve(int terms, const double *L, double *z) {
    if (terms == 5)
        solve_terms(5, L, z);
    else if (terms == 9)
        solve_terms(9, L, z);
    else
        solve_terms(terms, L, z);
}

double ssph_condition(const struct neighbourhood *nb, enum kernel_name kernel, int order) {
    double matrix[SSPH_TERMS_MAX * SSPH_TERMS_MAX], W[NEIGHBOURS_MAX];
    assemble_moments(nb, kernel, order, matrix, W);
    return factor(terms_of(nb->dim, order), matrix);
}

/* W: at the neighbours.  With a negative kernel M is not a sum of squares. */
static int singular(const struct neighbourhood *nb, int terms, double condition, const double *W,
                    struct failure *why) {
    char number[40] = "infinite", place[PLACE_TEXT];
    size_t negative = 0;
    for (size_t k = 0; k < nb->n; k++) negative += W[k] < 0;
    problem_place(nb->dim, nb->x, place);
    if (negative > 0 && isinf(condition))
        return refuse(why, STATUS_NUMERICAL,
                      "indefinite moment matrix: particle %zu at %s has %zu neighbours for %d unknowns, and "
                      "the kernel is negative at %zu of them (the quartic beyond 1.8 h); use another --h or --kernel",
                      nb->i, place, nb->n, terms, negative);
    if (condition < 1e17) snprintf(number, sizeof number, "%.1e", condition);
    return refuse(why, STATUS_NUMERICAL,
                  "singular moment matrix: particle %zu at %s has %zu neighbours for %d unknowns, condition "
                  "number %s (at most %.0e); use a larger --h or less --jitter",
                  nb->i, place, nb->n, terms, number, SSPH_CONDITION_MAX);
}

int ssph_weights(const struct neighbourhood *nb, enum kernel_name kernel, int order, const double *target, double *w,
                 struct failure *why) {
    int terms = terms_of(nb->dim, order);
    double matrix[SSPH_TERMS_MAX * SSPH_TERMS_MAX], z[SSPH_TERMS_MAX];
    assemble_moments(nb, kernel, order, matrix, w);
    double condition = factor(terms, matrix);
    if (!(condition <= SSPH_CONDITION_MAX)) return singular(nb, terms, condition, w, why);
    for (int k = 0; k < terms; k++) z[k] = target[k] / (nb->h * nb->h);
    solve(terms, matrix, z);
    combine(nb, order, w, z, w); /* w contains W until here */
    return STATUS_OK;
}

int ssph_gradient(const struct neighbourhood *nb, enum kernel_name kernel, double *F, double C[DIM_MAX][DIM_MAX],
                  struct failure *why) {
    int dim = nb->dim;
    double unit = 1 / (nb->h * nb->h);
    double matrix[DIM_MAX * DIM_MAX] = {0}, z[DIM_MAX][DIM_MAX] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, s[DIM_MAX];
    for (size_t j = 0; j < nb->n; j++) {
        F[j] = kernel_value(kernel, dim, scaled(nb, dim, j, s));
        for (int k = 0; k < dim; k++)
            for (int l = 0; l < dim; l++) matrix[k * dim + l] += s[k] * s[l] * F[j];
    }
    double condition = factor(dim, matrix);
    if (!(condition <= SSPH_CONDITION_MAX)) return singular(nb, dim, condition, F, why);
    for (int a = 0; a < dim; a++) solve(dim, matrix, z[a]);
    for (int a = 0; a < dim; a++)
        for (int b = a; b < dim; b++) C[a][b] = C[b][a] = z[a][b] * unit;
    return STATUS_OK;
}

int ssph_fit(const struct neighbourhood *nb, enum kernel_name kernel, int terms, double P[][FIT_TERMS_MAX],
             const double *size, const double *target, double *w, struct failure *why) {
    double matrix[FIT_TERMS_MAX * FIT_TERMS_MAX] = {0}, scale[FIT_TERMS_MAX], z[FIT_TERMS_MAX];
    for (size_t j = 0; j < nb->n; j++) {
        w[j] = kernel_value(kernel, nb->dim, neighbourhood_distance(nb, j) / nb->h);
        if (size) w[j] /= size[j] * size[j];
        for (int k = 0; k < terms; k++)
            for (int l = 0; l < terms; l++) matrix[k * terms + l] += P[j][k] * P[j][l] * w[j];
    }
    for (int k = 0; k < terms; k++) scale[k] = 1 / sqrt(matrix[k * terms + k]);
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < terms; l++) matrix[k * terms + l] *= scale[k] * scale[l];
    double number = factor(terms, matrix);
    if (!(number <= SSPH_CONDITION_MAX)) return singular(nb, terms, number, w, why);
    for (int k = 0; k < terms; k++) z[k] = target[k] * scale[k];
    solve(terms, matrix, z);
    for (size_t j = 0; j < nb->n; j++) {
        double sum = 0;
        for (int k = 0; k < terms; k++) sum += z[k] * scale[k] * P[j][k];
        w[j] *= sum;
    }
    return STATUS_OK;
}
