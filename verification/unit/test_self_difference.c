/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The difference of two fields with the same points in any order. */
#include "verification/judge/self_difference.h"

#include "solver/field.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/judge/norms.h"

#include "verification/unit/near.h"

/* 2 m by half a metre: a point is the same within 2 nm along x and half a nanometre along y. */
static const struct problem body = {.dim = 2, .lo = {1, -3}, .hi = {3, -2.5}};

enum { NX = 3, NY = 4, N = NX * NY };

/* Points of a lattice, the k-th of them at place order[k]. */
static struct field lattice(const int order[N]) {
    struct field f;
    field_alloc(&f, 2, N);
    f.weight = xcalloc(N, sizeof *f.weight);
    for (int k = 0; k < N; k++) {
        int i = order[k] % NX, j = order[k] / NX;
        f.x[0][k] = 1.2 + 0.7 * i, f.x[1][k] = -2.9 + 0.1 * j;
        f.T[k] = 3 + i - 2 * j, f.weight[k] = 1 + 0.5 * i + 0.25 * j;
    }
    return f;
}

static const int rows[N] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, mixed[N] = {7, 2, 11, 0, 9, 4, 1, 10, 3, 8, 5, 6};

static void points_in_any_order_are_compared(void **state) {
    (void)state;
    struct field a = lattice(rows), b = lattice(mixed);
    double apart[NORM_QUANTITY];
    double d1 = 0, d2 = 0, t1 = 0, t2 = 0, linf = 0;
    for (int k = 0; k < N; k++) {
        int i = k % NX, j = k / NX;
        double d = 0.1 * (i + 1) * (j - 1), T = 3 + i - 2 * j, w = 1 + 0.5 * i + 0.25 * j;
        a.T[k] += d;
        d1 += w * fabs(d), d2 += w * d * d, t1 += w * fabs(T), t2 += w * T * T;
        linf = fmax(linf, fabs(d));
    }
    for (int k = 0; k < N; k++) a.weight[k] = 17; /* those of the finer run count */
    assert_int_equal(self_difference_fields(&body, &a, &b, apart), 1);
    assert_near(apart[NORM_L1], d1 / t1, 1e-14);
    assert_near(apart[NORM_L2], sqrt(d2 / t2), 1e-14);
    assert_near(apart[NORM_LINF], linf, 1e-14);
    a.T[5] = NAN; /* a larger difference after it does not take it away */
    assert_int_equal(self_difference_fields(&body, &a, &b, apart), 1);
    assert_nan(apart[NORM_LINF]);
    field_free(&a);
    field_free(&b);
}

static void self_difference_of_a_rod_is_unweighted(void **state) {
    (void)state;
    const struct problem rod = {.dim = 1, .lo = {1}, .hi = {3}};
    struct field f[2];
    double apart[NORM_QUANTITY];
    for (int k = 0; k < 2; k++) {
        field_alloc(&f[k], 1, 3);
        for (int i = 0; i < 3; i++) f[k].x[0][i] = 1.5 + 0.4 * i, f[k].T[i] = 2 - i + (k ? 0 : 0.3 * i);
    }
    assert_int_equal(self_difference_fields(&rod, &f[0], &f[1], apart), 1);
    assert_near(apart[NORM_L1], 0.9 / 3, 1e-14);
    assert_near(apart[NORM_L2], sqrt(0.45 / 5), 1e-14);
    f[1].n = 2; /* one point fewer */
    assert_int_equal(self_difference_fields(&rod, &f[0], &f[1], apart), 0);
    for (int k = 0; k < 2; k++) field_free(&f[k]);
}

/* One point moved by so many nanometres. */
static int same(double along_x, double along_y) {
    struct field a = lattice(rows), b = lattice(mixed);
    double ignored[NORM_QUANTITY];
    a.x[0][N - 1] += 1e-9 * along_x, a.x[1][N - 1] += 1e-9 * along_y;
    int found = self_difference_fields(&body, &a, &b, ignored);
    field_free(&a);
    field_free(&b);
    return found;
}

static void distant_points_are_not_compared(void **state) {
    (void)state;
    assert_int_equal(same(1.9, 0), 1);
    assert_int_equal(same(2.1, 0), 0);
    assert_int_equal(same(0, 0.45), 1);
    assert_int_equal(same(0, 0.55), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_in_any_order_are_compared),
        cmocka_unit_test(self_difference_of_a_rod_is_unweighted),
        cmocka_unit_test(distant_points_are_not_compared),
    };
    return cmocka_run_group_tests_name("self_difference", tests, NULL, NULL);
}
