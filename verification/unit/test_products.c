/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields as sums of products, and exp(tA) by way of them: what is split is put together again, what is no such sum is
 * not taken for one, and few modes evolve as all modes do. */
#include "solver/time/stepper.h"
#include "solver/time/products.h"

#include "verification/unit/near.h"
#include "verification/unit/odd_problems.h"

#include <float.h>
#include <stdlib.h>

extern const struct method method_so_ssph;

static const double PI = 3.14159265358979323846;
enum { NX = 37, NY = 23 };

static double product(int i, int j) {
    return cos(0.31 * i + 0.2) * exp(-0.11 * j);
}

static double three_products(int i, int j) {
    return product(i, j) + 2.3e-5 * sin(0.7 * i) * (j * j - 3.1) - 0.83 * (i > 11) * (j < 17);
}

static double no_product(int i, int j) {
    return sin(12.9898 * i + 78.233 * sin(1.7 * j + 0.3 * i));
}

static double *field_of(const int n[2], double (*f)(int, int)) {
    double *F = xcalloc((size_t)n[0] * (size_t)n[1], sizeof *F);
    for (int j = 0; j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) F[j * n[0] + i] = f(i, j);
    return F;
}

static void a_sum_of_products_is_found_and_put_together(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = field_of(n, three_products), *again = xcalloc(NX * NY, sizeof *again);
    struct products p;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 5, &p), 1);
    assert_int_equal(p.rank, 3);
    products_join(&p, again);
    /* |F| < 3: what is left by elimination, 4 eps, and three products rounded and added */
    for (int i = 0; i < NX * NY; i++) assert_near(again[i], F[i], 10 * 3 * DBL_EPSILON);
    products_free(&p);
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 2, &p), 0);
    free(F);
    free(again);
}

static void the_size_of_a_field_is_none_of_its_shape(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    for (double unit = 1e-9; unit < 1e10; unit *= 1e18) {
        double *F = field_of(n, three_products);
        struct products p;
        for (int i = 0; i < NX * NY; i++) F[i] *= unit;
        assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 5, &p), 1);
        assert_int_equal(p.rank, 3);
        products_free(&p);
        free(F);
    }
}

static void what_is_no_such_sum_is_not_taken_for_one(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    static const double odd[] = {NAN, INFINITY, -INFINITY, 1e-9};
    struct products p;
    double *F = field_of(n, no_product);
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 8, &p), 0);
    free(F);
    for (size_t k = 0; k < sizeof odd / sizeof *odd;
         k++) /* one value of a product is another: also in the last columns */
        for (int at = 5 * NX + 3; at < 6 * NX; at += 33) {
            F = field_of(n, product);
            F[at] += odd[k];
            assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 1, &p), 0);
            free(F);
        }
}

static double alike(int i, int j) {
    return cos(0.31 * i + 0.2) + 0 * j;
}

/* Rows that repeat each other are passed over, but for the one that differs in its last column. */
static void a_row_that_repeats_another_but_for_one_value_is_seen(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = field_of(n, alike), *again = xcalloc(NX * NY, sizeof *again);
    struct products p;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 1, &p), 1);
    products_free(&p);
    F[9 * NX + NX - 1] += 1e-9;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 1, &p), 0);
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 2, &p), 1);
    products_join(&p, again);
    for (int i = 0; i < NX * NY; i++) assert_near(again[i], F[i], 10 * DBL_EPSILON);
    products_free(&p);
    free(F);
    free(again);
}

static double a_faint_second(int i, int j) {
    return product(i, j) + 1e-10 * sin(0.7 * i + 0.4) * (j - 3.1);
}

/* A second product of 2e-9 at most is far above rounding: two are found, and no fewer will do. */
static void a_faint_product_counts(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = field_of(n, a_faint_second), *again = xcalloc(NX * NY, sizeof *again);
    struct products p;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 1, &p), 0);
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 2, &p), 1);
    assert_int_equal(p.rank, 2);
    products_join(&p, again);
    for (int i = 0; i < NX * NY; i++) assert_near(again[i], F[i], 10 * DBL_EPSILON); /* |F| < 1.1 */
    products_free(&p);
    free(F);
    free(again);
}

static void nothing_is_a_sum_of_no_products(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = xcalloc(NX * NY, sizeof *F);
    struct products p;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 3, &p), 1);
    assert_int_equal(p.rank, 0);
    F[7] = 2.385;
    products_join(&p, F);
    assert_near(F[7], 0, 0);
    products_free(&p);
    free(F);
}

/* exp(tA) is linear: of a product, by its few modes, it is that of a sum less that of the rest, by all of theirs. */
static void few_modes_evolve_as_all_do(void **state) {
    (void)state;
    static const double times[] = {0.27, 1, 13.1}; /* of the problem's: most modes survive, some, and few */
    for (int sides = 0; sides < 16; sides++)
        for (int node = 0; node < 2; node++) {
            struct problem p = odd_rectangle();
            struct options o = {.dx = 0.02, .h = 1.23, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
            struct lattice l;
            struct heat_operator a;
            struct failure why;
            for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
            assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
            assert_int_equal(operator_create_lattice(&a, &p, &o, method_so_ssph.scheme, &l, &why), STATUS_OK);
            free(a.g); /* the homogeneous problem */
            a.g = NULL;
            double *one = field_of(l.n, product), *both = field_of(l.n, product), *rest = field_of(l.n, no_product);
            for (size_t i = 0; i < a.n; i++) both[i] += rest[i];
            double t = p.t_end * times[sides % 3];
            stepper_of(STEPPER_EXACT)->evolve(&a, t, one);
            stepper_of(STEPPER_EXACT)->evolve(&a, t, both);
            stepper_of(STEPPER_EXACT)->evolve(&a, t, rest);
            /* |T| < 2 to begin with; transforms of 75 x 60 round to some ten eps */
            for (size_t i = 0; i < a.n; i++) assert_near(both[i] - rest[i], one[i], 2e-14);
            free(one);
            free(both);
            free(rest);
            operator_free(&a);
        }
}

enum { ACROSS = 75 }; /* of a lattice of 0.02 m over 1.5 m */

static double first_wave(int i, int j) {
    (void)j;
    return sin(PI * (i + 0.5) / ACROSS);
}

static double third_wave(int i, int j) {
    (void)j;
    return sin(3 * PI * (i + 0.5) / ACROSS);
}

/* A wave of 1e-9 beside one of 1 K is there all the same: what it adds is 1e-9 of what it is alone. */
static void a_faint_wave_evolves(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.02, .h = 1.23};
    struct lattice l;
    struct heat_operator a;
    struct failure why;
    assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
    assert_int_equal(l.n[0], ACROSS);
    assert_int_equal(operator_create_lattice(&a, &p, &o, method_so_ssph.scheme, &l, &why), STATUS_OK);
    free(a.g); /* the homogeneous problem */
    a.g = NULL;
    double *one = field_of(l.n, first_wave), *both = field_of(l.n, first_wave), *faint = field_of(l.n, third_wave);
    for (size_t i = 0; i < a.n; i++) both[i] += 1e-9 * faint[i];
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, one);
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, both);
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, faint);
    /* of 1 K to begin with; transforms of 75 x 60 round to some ten eps */
    for (size_t i = 0; i < a.n; i++) assert_near(both[i] - one[i], 1e-9 * faint[i], 2e-14);
    assert_order(fabs(faint[ACROSS / 2]), >, 0.5); /* exp(-0.37) */
    free(one);
    free(both);
    free(faint);
    operator_free(&a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sum_of_products_is_found_and_put_together),
        cmocka_unit_test(the_size_of_a_field_is_none_of_its_shape),
        cmocka_unit_test(what_is_no_such_sum_is_not_taken_for_one),
        cmocka_unit_test(a_row_that_repeats_another_but_for_one_value_is_seen),
        cmocka_unit_test(a_faint_product_counts),
        cmocka_unit_test(nothing_is_a_sum_of_no_products),
        cmocka_unit_test(few_modes_evolve_as_all_do),
        cmocka_unit_test(a_faint_wave_evolves),
    };
    return cmocka_run_group_tests_name("products", tests, NULL, NULL);
}
