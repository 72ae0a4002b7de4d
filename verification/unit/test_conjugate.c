/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The conjugate pair on clouds between insulated walls: symmetric, never above 0, and what it conducts. */
#include "solver/space/csr.h"
#include "solver/space/gradient.h"

#include "verification/unit/near.h"
#include "verification/unit/odd_problems.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <stdlib.h>

extern const struct method method_conjugate;

static double no_flux(const struct problem *p, enum side s, const double x[2]) {
    (void)p, (void)s, (void)x;
    return 0;
}

/* -A on n (n x n) particles of dx = 1, kappa = 1, row by row; wave[] the slowest one along x, of size 1; *gamma the
 * mean of |Gamma e|^2 by the square of its slope. */
static double *matrix_of(int dim, int n, enum layout_name layout, double jitter, size_t *size, double *wave,
                         double *gamma) {
    struct problem p = {.dim = dim,
                        .hi = {n, dim == 2 ? n : 0},
                        .t_end = 1,
                        .materials = 1,
                        .wall = no_flux,
                        .material = {{{1, 1}, 1}},
                        .initial = odd_start};
    struct options o = {.dx = 1, .h = 1.1, .seed = 5, .layout = layout, .jitter = jitter, .sweeps = 2000};
    struct heat_operator a;
    struct lattice l;
    struct cloud c;
    struct failure why;
    struct row r;
    for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    assert_int_equal(layout_cloud(&p, &o, &l, 4 * o.h, &c, &why), STATUS_OK);
    if (operator_create_csr(&a, &p, &o, method_conjugate.scheme, &c, 1, &why)) fail_msg("%s", why.text);
    double *A = xcalloc(a.n * a.n, sizeof *A);
    csr_row_create(&r, a.n);
    for (size_t i = 0; i < a.n; i++) {
        operator_row_take(&a, i, &r);
        for (size_t k = 0; k < r.n; k++) A[i * a.n + r.column[k]] = -r.value[r.column[k]];
    }
    csr_row_free(&r);
    double length = 0, slope = 0;
    *size = a.n, *gamma = 0;
    for (size_t i = 0; i < a.n; i++) wave[i] = cos(M_PI * c.x[i] / n), length += wave[i] * wave[i];
    const struct gradient *g = a.gradient;
    for (size_t i = 0; i < a.n; i++) {
        double sum[2] = {0, 0};
        for (int turn = 0; turn < 2; turn++) {
            const uint32_t *begin = turn ? g->lent : g->kept;
            for (uint32_t k = begin[i]; k < begin[i + 1]; k++) {
                size_t j = turn ? g->keeper[k] : g->other[k];
                double F = g->F[turn ? g->pair[k] : k], x = c.x[j] - c.x[i];
                sum[0] += F * g->C[3 * i] * x * x, sum[1] += F * g->C[3 * i] * x * (c.y[j] - c.y[i]);
            }
        }
        double weight = 1 - wave[i] * wave[i];
        *gamma += weight * (sum[0] * sum[0] + sum[1] * sum[1]), slope += weight;
    }
    *gamma /= slope;
    for (size_t i = 0; i < a.n; i++) wave[i] /= sqrt(length);
    operator_free(&a);
    layout_cloud_free(&c);
    return A;
}

/* The wave's decay in the time t, v exp(-A t) v, as a conductivity; *rayleigh: v A v, likewise. */
static double conducted(double *A, size_t n, const double *v, double exact, double *rayleigh, double *least) {
    double *lambda = xcalloc(n, sizeof *lambda), *Q = xcalloc(n * n, sizeof *Q), left = 0, t = 1 / exact;
    gsl_matrix_view M = gsl_matrix_view_array(A, n, n), vectors = gsl_matrix_view_array(Q, n, n);
    gsl_vector_view values = gsl_vector_view_array(lambda, n);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
    gsl_eigen_symmv(&M.matrix, &values.vector, &vectors.matrix, work);
    gsl_eigen_symmv_free(work);
    *rayleigh = 0, *least = INFINITY;
    for (size_t k = 0; k < n; k++) {
        double part = 0;
        for (size_t i = 0; i < n; i++) part += v[i] * Q[i * n + k];
        left += part * part * exp(-lambda[k] * t);
        *rayleigh += part * part * lambda[k] / exact;
        *least = fmin(*least, lambda[k]);
    }
    free(lambda);
    free(Q);
    return -log(left);
}

/* Symmetric to rounding, no eigenvalue of -A below 0.  A wave decays no faster than it does at first (Jensen), which
 * is <|Gamma e|^2> times as fast as it should; on a lattice as fast but for O(dx^2). */
static void conducts_no_more_than_its_moments_say(void **state) {
    (void)state;
    static const struct {
        enum layout_name layout;
        double jitter, said; /* in the plane, as README */
    } clouds[] = {{LAYOUT_JITTER, 0, 0.98},
                  {LAYOUT_JITTER, 0.1, 0.92},
                  {LAYOUT_JITTER, 0.3, 0.76},
                  {LAYOUT_JITTER, 0.5, 0.64},
                  {LAYOUT_RELAXED, 0.5, 1.00}};
    for (int dim = 1; dim <= 2; dim++)
        for (int k = 0; k < 5; k++) {
            size_t n;
            int across = dim == 1 ? 120 : 14;
            double wave[200], gamma, worst = 0, exact = M_PI * M_PI / (across * across), rayleigh, least;
            double *A = matrix_of(dim, across, clouds[k].layout, clouds[k].jitter, &n, wave, &gamma);
            for (size_t i = 0; i < n; i++)
                for (size_t j = 0; j < i; j++) worst = fmax(worst, fabs(A[i * n + j] - A[j * n + i]));
            assert_near(worst, 0, 1e-13);
            double share = conducted(A, n, wave, exact, &rayleigh, &least);
            print_message("%dD cloud %d, jitter %g: conducts %.4f, at first %.4f, <|Gamma e|^2> %.4f\n", dim, k,
                          clouds[k].jitter, share, rayleigh, gamma);
            assert_order(least, >, -1e-13);
            assert_order(share, <=, rayleigh * (1 + 1e-9));
            assert_near(rayleigh / gamma, 1, 0.05);
            if (k == 0) assert_near(share, 1, 0.03);
            if (dim == 2) assert_near(share, clouds[k].said, 0.005);
            free(A);
        }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {cmocka_unit_test(conducts_no_more_than_its_moments_say)};
    return cmocka_run_group_tests_name("conjugate", tests, NULL, NULL);
}
