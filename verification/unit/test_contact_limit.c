/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps at a contact of two materials of one diffusivity, k and rho c of the second R times those of the first.
 *
 * Two half planes of columns, a wave cos(pi y/dx) along the contact, which is midway between columns 0 and 1.  As R
 * falls the first material no longer moves, so that beyond the contact the second has a wall: for brookshaw pairs
 * across weigh 2/(1 + R) times as much, for contact_ssph neighbours beyond move to the contact.  Rows of the two are
 * written here once more; the fastest mode of 40 columns is that of the half planes to 1e-9. */
#include "verification/stability/step_limit.h"

#include "solver/method.h"
#include "verification/unit/near.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <math.h>

enum { COLUMNS = 40, REACH = 2, SIDE = 2 * REACH + 1, TERMS = 5 };
static const double H = 1.1; /* in spacings, as all lengths here; the kernel is cubic */

struct row { /* weights of the neighbours at (i, j), w[REACH + i][REACH + j] */
    double w[SIDE][SIDE];
};

/* Twice the conductivity between two materials, over twice that of the first. */
static double harmonic(double here, double there) {
    return 2 * there / (here + there);
}

/* -W'(r) r/(r^2 + 0.01 h^2), scaled to sum w x^2 = 2. */
static struct row brookshaw(double X, double R, int second) {
    struct row row = {{{0}}};
    double moment = 0, k[2] = {second ? R : 1, second ? 1 : R};
    for (int i = -REACH; i <= REACH; i++)
        for (int j = -REACH; j <= REACH; j++) {
            double r = hypot(i, j), s = r / H, slope = s < 1 ? -2 * s + 1.5 * s * s : s < 2 ? -pow(2 - s, 2) / 2 : 0;
            double w = -slope * r / (r * r + 0.01 * H * H);
            moment += w * i * i / 2;
            row.w[REACH + i][REACH + j] = (second ? -i : i) > X ? w * harmonic(k[0], k[1]) : w;
        }
    for (int n = 0; n < SIDE * SIDE; n++) row.w[n / SIDE][n % SIDE] /= moment;
    return row;
}

/* x, y, x^2/2, x y, y^2/2 in units of h, x -> X + r (x - X) beyond the contact at X; and by how much they are larger
 * there than monomials. */
static double functions(double x, double y, double X, double r, double P[TERMS]) {
    double along = x, curved = x * x / 2;
    if (x > X) along = X + r * (x - X), curved = X * X / 2 + r * X * (x - X) + (x - X) * (x - X) / 2;
    const double all[TERMS] = {along, y, curved, along * y, y * y / 2};
    for (int k = 0; k < TERMS; k++) P[k] = all[k];
    return x > X ? fmax(1, fmax(along / x, 2 * curved / (x * x))) : 1;
}

static struct row contact_ssph(double X, double R, int second) {
    struct row row = {{{0}}};
    double P[SIDE * SIDE][TERMS], W[SIDE * SIDE] = {0};
    gsl_matrix *M = gsl_matrix_calloc(TERMS, TERMS);
    gsl_vector *z = gsl_vector_calloc(TERMS);
    gsl_vector_set(z, 2, 1 / (H * H));
    gsl_vector_set(z, 4, 1 / (H * H));
    for (int n = 0; n < SIDE * SIDE; n++) {
        int i = n / SIDE - REACH, j = n % SIDE - REACH;
        double s = hypot(i, j) / H, size = functions((second ? -i : i) / H, j / H, X / H, second ? R : 1 / R, P[n]);
        if (i || j) W[n] = (s < 1 ? 2.0 / 3 - s * s + s * s * s / 2 : s < 2 ? pow(2 - s, 3) / 6 : 0) / (size * size);
        for (int k = 0; k < TERMS * TERMS; k++)
            *gsl_matrix_ptr(M, (size_t)(k / TERMS), (size_t)(k % TERMS)) += W[n] * P[n][k / TERMS] * P[n][k % TERMS];
    }
    gsl_linalg_cholesky_decomp1(M);
    gsl_linalg_cholesky_svx(M, z);
    for (int n = 0; n < SIDE * SIDE; n++) {
        double sum = 0;
        for (int k = 0; k < TERMS; k++) sum += P[n][k] * gsl_vector_get(z, (size_t)k);
        row.w[n / SIDE][n % SIDE] = W[n] * sum;
        assert_order(W[n] * sum, >=, -1e-12); /* or others would be taken */
    }
    gsl_matrix_free(M);
    gsl_vector_free(z);
    return row;
}

/* 2 over the largest rate. */
static double step_of(struct row (*rows)(double X, double R, int second), double R) {
    double largest = 0;
    gsl_matrix *A = gsl_matrix_calloc(COLUMNS, COLUMNS);
    gsl_vector_complex *lambda = gsl_vector_complex_alloc(COLUMNS);
    gsl_eigen_nonsymm_workspace *room = gsl_eigen_nonsymm_alloc(COLUMNS);
    for (int m = 0; m < COLUMNS; m++) {
        int second = m >= COLUMNS / 2;
        struct row row = rows(second ? m - COLUMNS / 2 + 0.5 : COLUMNS / 2 - m - 0.5, R, second);
        for (int i = -REACH; i <= REACH; i++)
            for (int j = -REACH; j <= REACH; j++) {
                double w = i || j ? row.w[REACH + i][REACH + j] : 0;
                *gsl_matrix_ptr(A, (size_t)m, (size_t)m) -= w;
                if (m + i >= 0 && m + i < COLUMNS) *gsl_matrix_ptr(A, (size_t)m, (size_t)(m + i)) += j % 2 ? -w : w;
            }
    }
    gsl_eigen_nonsymm(A, lambda, room);
    for (size_t m = 0; m < COLUMNS; m++) largest = fmax(largest, gsl_complex_abs(gsl_vector_complex_get(lambda, m)));
    gsl_eigen_nonsymm_free(room);
    gsl_vector_complex_free(lambda);
    gsl_matrix_free(A);
    return 2 / largest;
}

static void steps_at_a_contact_are_those_of_half_planes(void **state) {
    (void)state;
    static const struct {
        const char *method;
        struct row (*rows)(double X, double R, int second);
        double contact, step; /* to three digits, as README has the last */
    } cases[] = {{"brookshaw", brookshaw, 0.1, 0.385},        {"brookshaw", brookshaw, 0.01, 0.375},
                 {"brookshaw", brookshaw, 1e-4, 0.374},       {"contact_ssph", contact_ssph, 0.1, 0.479},
                 {"contact_ssph", contact_ssph, 0.01, 0.473}, {"contact_ssph", contact_ssph, 1e-4, 0.472}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct options o = {.order = 2, .h = H};
        struct model_problem b;
        struct step_limit l;
        struct failure why;
        double step = step_of(cases[k].rows, cases[k].contact);
        if (step_limit_setup(method_find(cases[k].method), &o, 2, 0, cases[k].contact, 0, &b, &why))
            fail_msg("%s", why.text);
        assert_int_equal(step_limit_predict(&b, &l, &why), STATUS_OK);
        assert_near(l.von_neumann, step, 1e-6);
        assert_near(step, cases[k].step, 0.0005);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(steps_at_a_contact_are_those_of_half_planes)};
    return cmocka_run_group_tests_name("contact_limit", tests, NULL, NULL);
}
