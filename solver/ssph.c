/* Symmetric SPH: derivative weights from a symmetric moment matrix, for any Taylor order p (Song eqs. 9-13).
 *
 * With the scaled monomials P_k = (x/h)^a (y/h)^b / (a! b!), 1 <= a + b <= p, and W_k = P_k W:
 *   M u = b,   M_kl = sum_j P_k P_l W,   b_k = sum_j P_k W (f_j - f_i),   u_k = h^(a+b) D^(a,b) f.
 * For the derivative sum_k t_k u_k the weights are w_j = W_j (z . P_j) with M z = t, since M is symmetric.  Particle
 * volumes are all alike and cancel, and so does the norm of the kernel.  No kernel derivative is needed.
 * In units of h every entry of M is O(1), whatever the spacing. */
#include "solver/ssph.h"
#include "solver/kernel.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

static int terms_of(int dim, int order) {
    return dim == 1 ? order : (order + 1) * (order + 2) / 2 - 1;
}

static void monomials(int dim, int order, const double s[2], double *P) {
    double x[SSPH_ORDER_MAX + 1] = {1}, y[SSPH_ORDER_MAX + 1] = {1}; /* s^a / a! */
    for (int a = 1; a <= order; a++) x[a] = x[a - 1] * s[0] / a, y[a] = y[a - 1] * s[1] / a;
    for (int degree = 1; degree <= order; degree++)
        for (int b = 0; b <= (dim == 2 ? degree : 0); b++) *P++ = x[degree - b] * y[b];
}

/* M (terms x terms) and W_j */
static void assemble(const struct neighbourhood *nb, enum kernel_name kernel, int order, double *matrix, double *W) {
    int terms = terms_of(nb->dim, order);
    double P[SSPH_TERMS_MAX];
    for (size_t j = 0; j < nb->n; j++) {
        double s[2] = {nb->d[j][0] / nb->h, nb->d[j][1] / nb->h};
        W[j] = kernel_value(kernel, nb->dim, sqrt(s[0] * s[0] + s[1] * s[1]));
        monomials(nb->dim, order, s, P);
        for (int k = 0; k < terms; k++)
            for (int l = 0; l <= k; l++) matrix[k * terms + l] += P[k] * P[l] * W[j];
    }
    for (int k = 0; k < terms; k++)
        for (int l = 0; l < k; l++) matrix[l * terms + k] = matrix[k * terms + l];
}

double ssph_condition(const struct neighbourhood *nb, enum kernel_name kernel, int order) {
    size_t terms = (size_t)terms_of(nb->dim, order);
    double matrix[SSPH_TERMS_MAX * SSPH_TERMS_MAX] = {0}, W[NEIGHBOURS_MAX], work[3 * SSPH_TERMS_MAX];
    gsl_matrix_view M = gsl_matrix_view_array(matrix, terms, terms);
    gsl_vector_view scratch = gsl_vector_view_array(work, 3 * terms);
    double reciprocal = 0;
    assemble(nb, kernel, order, matrix, W);
    if (gsl_linalg_cholesky_decomp1(&M.matrix)) return INFINITY;
    gsl_linalg_cholesky_rcond(&M.matrix, &reciprocal, &scratch.vector);
    return 1 / reciprocal;
}

/* Cholesky factor of M in place, or an error that says why there is none. */
static int factor(const struct neighbourhood *nb, gsl_matrix *M, gsl_vector *work, struct failure *why) {
    double reciprocal = 0;
    int bad = gsl_linalg_cholesky_decomp1(M);
    if (!bad) bad = gsl_linalg_cholesky_rcond(M, &reciprocal, work);
    if (!bad && reciprocal >= 1 / SSPH_CONDITION_MAX) return STATUS_OK;
    char condition[40] = "infinite";
    if (!bad && reciprocal > 1e-17) snprintf(condition, sizeof condition, "%.1e", 1 / reciprocal);
    return fail(
        why, STATUS_NUMERICAL,
        "singular moment matrix: particle %zu at (%.6g, %.6g) m has %zu neighbours for %zu unknowns, condition "
        "number %s (at most %.0e); take a larger --h or less --jitter",
        nb->i, nb->x[0], nb->x[1], nb->n, M->size1, condition, SSPH_CONDITION_MAX);
}

int ssph_weights(const struct neighbourhood *nb, enum kernel_name kernel, int order, int targets,
                 double target[][SSPH_TERMS_MAX], double *w[], struct failure *why) {
    int terms = terms_of(nb->dim, order);
    double matrix[SSPH_TERMS_MAX * SSPH_TERMS_MAX] = {0}, work[3 * SSPH_TERMS_MAX], P[SSPH_TERMS_MAX];
    assemble(nb, kernel, order, matrix, w[0]);

    gsl_matrix_view M = gsl_matrix_view_array(matrix, (size_t)terms, (size_t)terms);
    gsl_vector_view scratch = gsl_vector_view_array(work, 3 * (size_t)terms);
    if (factor(nb, &M.matrix, &scratch.vector, why)) return why->status;

    double z[2][SSPH_TERMS_MAX];
    for (int t = 0; t < targets; t++) {
        int k = 0;
        for (int degree = 1; degree <= order; degree++)
            for (int b = 0; b <= (nb->dim == 2 ? degree : 0); b++, k++) z[t][k] = target[t][k] / pow(nb->h, degree);
        gsl_vector_view v = gsl_vector_view_array(z[t], (size_t)terms);
        gsl_linalg_cholesky_svx(&M.matrix, &v.vector);
    }
    for (size_t j = 0; j < nb->n; j++) {
        double s[2] = {nb->d[j][0] / nb->h, nb->d[j][1] / nb->h}, W = w[0][j];
        monomials(nb->dim, order, s, P);
        for (int t = 0; t < targets; t++) {
            double sum = 0;
            for (int k = 0; k < terms; k++) sum += z[t][k] * P[k];
            w[t][j] = W * sum;
        }
    }
    return STATUS_OK;
}
