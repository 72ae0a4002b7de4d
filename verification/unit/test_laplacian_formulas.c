/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The discrete Laplacians on a neighbourhood without any symmetry, each against its formula written out step by step,
 * in metres, for the cubic kernel in the plane and a field of odd numbers. */
#include "solver/particles/ssph.h"
#include "solver/space/kernel.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"
#include "verification/unit/odd_neighbourhood.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

static const double both[2] = {0.71, 0.43}, same[2] = {0.71, 0.71};

static double slope(double r) { /* dW/dr, m^-3 */
    double s = r / H, a = 15 / (7 * M_PI);
    return (s < 1 ? -a * (2 * s - 1.5 * s * s) : s < 2 ? -a / 2 * (2 - s) * (2 - s) : 0) / (H * H * H);
}

static double bend(double r) { /* d2W/dr2, m^-4 */
    double s = r / H, a = 15 / (7 * M_PI);
    return (s < 1 ? -a * (2 - 3 * s) : s < 2 ? a * (2 - s) : 0) / (H * H * H * H);
}

/* The corrected gradient of f, K/m, by Cramer's rule. */
static void gradient(const double *f, double g[2]) {
    double m[3] = {0, 0, 0}, b[2] = {0, 0};
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], c = -VOLUME * slope(hypot(x, y)) / hypot(x, y);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
        b[0] += c * x * f[j], b[1] += c * y * f[j];
    }
    double det = m[0] * m[2] - m[1] * m[1];
    g[0] = (m[2] * b[0] - m[1] * b[1]) / det, g[1] = (m[0] * b[1] - m[1] * b[0]) / det;
}

/* What f has beside its corrected gradient at neighbour j, K. */
static double beyond(const double *f, const double g[2], int j) {
    return f[j] - g[0] * place[j][0] - g[1] * place[j][1];
}

static double schwaiger(const double *f) {
    double g[2], sum = 0, m[3] = {0, 0, 0};
    gradient(f, g);
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], c = -VOLUME * slope(hypot(x, y)) / hypot(x, y);
        sum += 2 * c * beyond(f, g, j);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
    }
    return KX * (m[0] + m[2]) / (m[0] * m[2] - m[1] * m[1]) / 2 * sum;
}

typedef void components(const double *f, double S[3]);

static void fatehi_components(const double *f, double S[3]) {
    double g[2];
    gradient(f, g);
    S[0] = S[1] = S[2] = 0;
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y);
        double c = -VOLUME * slope(r) / r * beyond(f, g, j);
        S[0] += c * x * x / (r * r), S[1] += c * x * y / (r * r), S[2] += c * y * y / (r * r);
    }
}

/* g: the gradient that is taken off, or NULL */
static void cspm_sums(const double *f, const double g[2], double S[3]) {
    S[0] = S[1] = S[2] = 0;
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), w1 = slope(r), w2 = bend(r);
        double rest = VOLUME * (g ? beyond(f, g, j) : f[j]);
        S[0] += rest * (w2 * x * x / (r * r) + w1 * y * y / (r * r * r));
        S[1] += rest * (w2 - w1 / r) * x * y / (r * r);
        S[2] += rest * (w2 * y * y / (r * r) + w1 * x * x / (r * r * r));
    }
}

static void cspm_components(const double *f, double S[3]) {
    double g[2];
    gradient(f, g);
    cspm_sums(f, g, S);
}

static void cspm_matrix(const double *f, double S[3]) {
    cspm_sums(f, NULL, S);
}

static double determinant(double a[3][3]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/* KX T_xx + KY T_yy from S = K (T_xx, T_xy, T_yy), by Cramer's rule. */
static double solved(const double *f, components *right, components *left) {
    double K[3][3], S[3], column[3], got[3];
    right(f, S);
    for (int n = 0; n < 3; n++) {
        double q[MANY];
        for (int j = 0; j < MANY; j++) {
            double x = place[j][0], y = place[j][1];
            q[j] = n == 0 ? x * x / 2 : n == 1 ? x * y : y * y / 2;
        }
        left(q, column);
        for (int m = 0; m < 3; m++) K[m][n] = column[m];
    }
    for (int n = 0; n < 3; n++) {
        double swapped[3][3];
        memcpy(swapped, K, sizeof K);
        for (int m = 0; m < 3; m++) swapped[m][n] = S[m];
        got[n] = determinant(swapped) / determinant(K);
    }
    return KX * got[0] + KY * got[2];
}

static double applied(const char *name, const double kappa[2]) {
    struct neighbourhood nb = around(2, kappa);
    double w[2][MANY], sum = 0;
    weights_of(name, &nb, w);
    for (int j = 0; j < MANY; j++) sum += w[0][j] * field[j];
    return sum;
}

static void as_the_formulas_say(void **state) {
    (void)state;
    assert_near(applied("schwaiger", same) / schwaiger(field), 1, 1e-12);
    assert_near(applied("fatehi_manzari", both) / solved(field, fatehi_components, fatehi_components), 1, 1e-11);
    assert_near(applied("cspm", both) / solved(field, cspm_components, cspm_matrix), 1, 1e-11);
    double pairs = 0, corrected = 0, m[3] = {0, 0, 0};
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), c = -VOLUME * slope(r) / r;
        pairs += KX * VOLUME * field[j] * (bend(r) + slope(r) / r);
        m[0] += c * x * x, m[1] += c * x * y, m[2] += c * y * y;
    }
    assert_near(applied("kernel_second", same) / pairs, 1, 1e-12);
    for (int j = 0; j < MANY; j++) {
        double x = place[j][0], y = place[j][1], r = hypot(x, y), det = m[0] * m[2] - m[1] * m[1];
        double form = (m[2] * x * x - 2 * m[1] * x * y + m[0] * y * y) / det;
        corrected -= 2 * KX * VOLUME * slope(r) / (r * r * r) * form * field[j];
    }
    assert_near(applied("brookshaw_corrected", same) / corrected, 1, 1e-12);
}

static void fluxes_by_the_kernels_gradient(void **state) {
    (void)state;
    double w[2][MANY];
    struct neighbourhood nb = around(2, both);
    weights_of("flux_divergence", &nb, w);
    for (int j = 0; j < MANY; j++) {
        double r = hypot(place[j][0], place[j][1]);
        for (int a = 0; a < 2; a++) assert_near(w[a][j], -VOLUME * slope(r) * place[j][a] / r, 1e-12 / H);
    }
}

static void second_derivatives_of_kernels(void **state) {
    (void)state;
    for (int k = 0; kernel_words[k]; k++)
        for (int dim = 1; dim <= 2; dim++)
            for (double s = 0.037; s < 2; s += 0.113) {
                const double e = 1e-5;
                double low = kernel_slope((enum kernel_name)k, dim, s - e);
                double high = kernel_slope((enum kernel_name)k, dim, s + e);
                if ((s - 1 - e) * (s - 1 + e) < 0) continue; /* a corner of the cubic kernel's */
                assert_near(kernel_curvature((enum kernel_name)k, dim, s), (high - low) / (2 * e), 1e-8);
            }
}

/* |M|_1 |M^-1|_1 of the moments of x^a y^b/(a! b!), in units of h. */
static void conditions_are_those_of_the_whole_matrix(void **state) {
    (void)state;
    static const int factorial[] = {1, 1, 2, 6, 24};
    struct neighbourhood nb = around(2, same);
    for (int order = 1; order <= 3; order++) { /* at 4 the 15 neighbours hold 14 unknowns badly */
        size_t terms = (size_t)(order * (order + 3) / 2);
        gsl_matrix *M = gsl_matrix_calloc(terms, terms), *inverse = gsl_matrix_alloc(terms, terms);
        gsl_permutation *p = gsl_permutation_alloc(terms);
        double norm[2] = {0, 0};
        int sign;
        for (int j = 0; j < MANY; j++) {
            double P[SSPH_TERMS_MAX], x = place[j][0] / H, y = place[j][1] / H;
            size_t n = 0;
            for (int degree = 1; degree <= order; degree++)
                for (int b = 0; b <= degree; b++)
                    P[n++] = pow(x, degree - b) * pow(y, b) / factorial[degree - b] / factorial[b];
            for (size_t k = 0; k < terms; k++)
                for (size_t l = 0; l < terms; l++)
                    *gsl_matrix_ptr(M, k, l) += P[k] * P[l] * kernel_value(KERNEL_CUBIC, 2, hypot(x, y));
        }
        for (int i = 0; i < 2; i++) {
            for (size_t l = 0; l < terms; l++) {
                double sum = 0;
                for (size_t k = 0; k < terms; k++) sum += fabs(gsl_matrix_get(i ? inverse : M, k, l));
                norm[i] = fmax(norm[i], sum);
            }
            if (i == 0) gsl_linalg_LU_decomp(M, p, &sign), gsl_linalg_LU_invert(M, p, inverse);
        }
        double condition = norm[0] * norm[1], rounding = (double)(terms * terms) * 2.3e-16 * condition;
        assert_near(ssph_condition(&nb, KERNEL_CUBIC, order) / condition, 1, rounding);
        assert_order(rounding, <, 1e-6);
        gsl_permutation_free(p);
        gsl_matrix_free(inverse);
        gsl_matrix_free(M);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_the_formulas_say),
        cmocka_unit_test(fluxes_by_the_kernels_gradient),
        cmocka_unit_test(second_derivatives_of_kernels),
        cmocka_unit_test(conditions_are_those_of_the_whole_matrix),
    };
    return cmocka_run_group_tests_name("laplacian_formulas", tests, NULL, NULL);
}
