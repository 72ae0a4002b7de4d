/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linear programme of positive stencils: its cost against every stencil of five neighbours, and many programmes
 * on clouds that it was not made for. */
#include "solver/space/kernel.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"
#include "verification/unit/odd_neighbourhood.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>

static double cost_of(const double *d) {
    double r = hypot(d[0], d[1]) / H, W = kernel_value(KERNEL_CUBIC, 2, r);
    return W > 0 ? r * r / W : INFINITY;
}

/* The cost of the weights of these five that meet the conditions; infinite where one of them is negative. */
static double cost_of_five(double (*d)[2], const int five[5], const double kappa[2]) {
    double A[25], b[5] = {0, 0, 2 * kappa[0] / (H * H), 2 * kappa[1] / (H * H), 0}, w[5], sum = 0;
    int sign;
    size_t order[5];
    gsl_permutation p = {5, order};
    for (int k = 0; k < 5; k++) {
        double x = d[five[k]][0] / H, y = d[five[k]][1] / H, all[5] = {x, y, x * x, y * y, x * y};
        for (int l = 0; l < 5; l++) A[5 * l + k] = all[l];
    }
    gsl_matrix_view M = gsl_matrix_view_array(A, 5, 5);
    gsl_vector_view right = gsl_vector_view_array(b, 5), out = gsl_vector_view_array(w, 5);
    gsl_linalg_LU_decomp(&M.matrix, &p, &sign);
    if (!(fabs(gsl_linalg_LU_det(&M.matrix, sign)) > 1e-9)) return INFINITY;
    gsl_linalg_LU_solve(&M.matrix, &p, &right.vector, &out.vector);
    for (int k = 0; k < 5; k++) {
        if (w[k] < 0) return INFINITY;
        sum += w[k] * cost_of(d[five[k]]);
    }
    return sum;
}

/* The least over all fives of n. */
static double least_cost(double (*d)[2], int n, const double kappa[2]) {
    double least = INFINITY;
    int f[5];
    for (f[0] = 0; f[0] < n; f[0]++)
        for (f[1] = f[0] + 1; f[1] < n; f[1]++)
            for (f[2] = f[1] + 1; f[2] < n; f[2]++)
                for (f[3] = f[2] + 1; f[3] < n; f[3]++)
                    for (f[4] = f[3] + 1; f[4] < n; f[4]++) least = fmin(least, cost_of_five(d, f, kappa));
    return least;
}

static void check_programme(double (*d)[2], int n, const double kappa[2]) {
    struct problem p = odd_rectangle();
    struct options o = {.kernel = KERNEL_CUBIC};
    struct neighbourhood nb = around(2, kappa);
    struct failure why;
    double w[2][MANY], *out[2] = {w[0], w[1]}, sum = 0, moment[5] = {0}, least = least_cost(d, n, kappa);
    nb.n = (size_t)n, nb.d = d;
    int status = operator_weights(named("positive")->scheme, &p, &o, &nb, out, &why);
    assert_int_equal(status, isfinite(least) ? STATUS_OK : STATUS_NUMERICAL);
    if (status) return;
    for (int j = 0; j < n; j++) {
        double x = d[j][0], y = d[j][1], all[5] = {x / H, y / H, x * x, y * y, x * y};
        assert_order(w[0][j], >=, 0);
        if (w[0][j] > 0) sum += w[0][j] * cost_of(d[j]);
        for (int k = 0; k < 5; k++) moment[k] += w[0][j] * all[k] * (k < 2 ? H * H : 1);
    }
    assert_near(sum / least, 1, 1e-8);
    for (int k = 0; k < 5; k++) assert_near(moment[k], k == 2 ? 2 * kappa[0] : k == 3 ? 2 * kappa[1] : 0, 1e-10);
}

static void no_five_cost_less(void **state) {
    (void)state;
    check_programme(place, MANY, (const double[2]){0.71, 0.43});
    check_programme(place, MANY, (const double[2]){0.71, 0.71});
}

static void draws_of_neighbours(void **state) {
    (void)state;
    enum { DRAWS = 60, DRAWN = 11 };
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 11);
    for (int k = 0; k < DRAWS; k++) {
        double d[DRAWN][2];
        for (int j = 0; j < DRAWN; j++)
            for (int a = 0; a < 2; a++) d[j][a] = 3.2 * H * (gsl_rng_uniform(random) - 0.5);
        check_programme(d, DRAWN, (const double[2]){0.71, k % 2 ? 0.71 : 0.23});
    }
    gsl_rng_free(random);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_five_cost_less),
        cmocka_unit_test(draws_of_neighbours),
    };
    return cmocka_run_group_tests_name("positive", tests, NULL, NULL);
}
