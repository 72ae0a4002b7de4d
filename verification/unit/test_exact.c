/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact stepper: its transforms, fields as sums of products, rates to some roundings of themselves. */

#include "solver/time/transform.h"
#include "solver/time/stepper.h"
#include "solver/time/products.h"
#include "solver/space/operator.h"
#include "verification/judge/run.h"

#include "verification/unit/odd_problems.h"
#include "verification/unit/near.h"

#include <float.h>
#include <stdlib.h>

extern const struct method method_so_ssph;

/* ---- transforms ---- */

static const double PI = 3.14159265358979323846;

/* Between walls of each kind, on cells and on nodes. */
static struct lattice between(int sides, enum layout_name layout, double dx) {
    struct problem p = odd_rectangle();
    struct options o = {.dx = dx, .layout = layout};
    struct lattice l;
    struct failure why;
    for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    return l;
}

static double mode_along(const struct lattice *l, int axis, int k, int i) {
    int even = l->sign[2 * axis] > 0, node = l->shift[2 * axis] != 0;
    double from_wall = node ? i + !even : i + 0.5, phase = transform_angle(l, axis, k) * from_wall;
    return even ? cos(phase) : sin(phase);
}

static void one_mode(const struct lattice *l, const int mode[2], double *T) {
    size_t nx = (size_t)l->n[0], n = nx * (size_t)l->n[1], only = (size_t)mode[1] * nx + (size_t)mode[0];
    for (size_t i = 0; i < n; i++)
        T[i] = 1.7 * mode_along(l, 0, mode[0], (int)(i % nx)) * mode_along(l, 1, mode[1], (int)(i / nx));
    struct transform *t = transform_create(l);
    transform_forward(t, T);
    /* n products of size 1 add up, each rounded to 2e-16 of the sum, and FFTW does better */
    double tolerance = 1e-14 * transform_scale(l);
    assert_order(fabs(T[only]), >, 0.2 * transform_scale(l));
    for (size_t i = 0; i < n; i++)
        if (i != only) assert_near(T[i], 0, tolerance);
    transform_free(t);
}

static void a_mode_has_one_coefficient(void **state) {
    (void)state;
    for (int layout = 0; layout < 2; layout++)
        for (int sides = 0; sides < 16; sides++) {
            struct lattice l = between(sides, (enum layout_name)layout, 0.01); /* 150 along x, 120 along y */
            double *T = xcalloc((size_t)l.n[0] * (size_t)l.n[1], sizeof *T);
            one_mode(&l, (int[]){0, 0}, T);
            one_mode(&l, (int[]){l.n[0] - 1, 3}, T);
            one_mode(&l, (int[]){13, l.n[1] - 1}, T);
            free(T);
        }
}

static void back_again(const struct lattice *l) {
    size_t n = (size_t)l->n[0] * (size_t)l->n[1];
    double *T = xcalloc(n, sizeof *T), gain = transform_scale(l);
    for (size_t i = 0; i < n; i++) T[i] = sin(0.7 * (double)(i * i % 101));
    struct transform *t = transform_create(l);
    transform_forward(t, T);
    transform_backward(t, T);
    for (size_t i = 0; i < n; i++) assert_near(T[i] / gain, sin(0.7 * (double)(i * i % 101)), 1e-13);
    transform_free(t);
    free(T);
}

static void transform_pair_is_the_identity(void **state) {
    (void)state;
    for (int layout = 0; layout < 2; layout++)
        for (int sides = 0; sides < 16; sides++) {
            struct lattice l = between(sides, (enum layout_name)layout, 0.01), rod = l;
            back_again(&l);
            rod.dim = 1, rod.n[1] = 1;
            back_again(&rod);
            l = between(sides, (enum layout_name)layout, 0.1);
            back_again(&l);
        }
}

/* Insulated at one end, cooled by f = (1 - b)/(1 + b) at the other: mode k of n particles is cos(theta (i + 1/2)),
 * and the ghost asks for tan(n theta) tan(theta/2) = b.  The slowest one decays however little is cooled: its theta
 * is sqrt(2 b/n) and must be known to its own last digits, not to those of pi. */
static void robin_angles_solve_their_equation(void **state) {
    (void)state;
    enum { N = 11 };
    for (int power = 3; power <= 50; power += 47 / 3) {
        struct lattice l = {
            .dim = 1, .n = {N, 1, 1}, .sign = {1, LAYOUT_RECURRENCE}, .factor = {0, 1 - ldexp(1, -power)}};
        double b = ldexp(1, -power) / (2 - ldexp(1, -power));
        double slowest = transform_angle(&l, 0, 0);
        assert_near(tan(N * slowest) * tan(slowest / 2) / b, 1, 16 * DBL_EPSILON);
        for (int k = 1; k < N; k++) {
            double theta = transform_angle(&l, 0, k);
            assert_near(theta, (PI * k + atan(b / tan(theta / 2))) / N, 4 * DBL_EPSILON * theta);
        }
    }
}

/* ---- products ---- */

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

static void sum_of_products_is_recovered(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = field_of(n, three_products), *again = xcalloc(NX * NY, sizeof *again);
    struct products p;
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 5, &p), 1);
    assert_int_equal(p.rank, 3);
    products_join(&p, again);
    /* |F| < 3: round-off of the elimination, 4 eps, and of three products and their sum */
    for (int i = 0; i < NX * NY; i++) assert_near(again[i], F[i], 10 * 3 * DBL_EPSILON);
    products_free(&p);
    assert_int_equal(products_split(F, n, 4 * DBL_EPSILON, 2, &p), 0);
    free(F);
    free(again);
}

static void full_rank_field_is_not_split(void **state) {
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

static double same_rows(int i, int j) {
    return cos(0.31 * i + 0.2) + 0 * j;
}

/* Repeated rows are skipped, except for the one that differs in its last column. */
static void nearly_equal_rows_are_distinguished(void **state) {
    (void)state;
    const int n[2] = {NX, NY};
    double *F = field_of(n, same_rows), *again = xcalloc(NX * NY, sizeof *again);
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

/* exp(tA) is linear: of a product, by its few modes, it is that of a sum less that of the rest, by all of theirs. */
static void compare_modes(const struct problem *p, const struct options *o, double t) {
    struct lattice l;
    struct heat_operator a;
    struct failure why;
    assert_int_equal(layout_lattice(p, o, &l, &why), STATUS_OK);
    assert_int_equal(operator_create_lattice(&a, p, o, method_so_ssph.scheme, &l, &why), STATUS_OK);
    free(a.g); /* the homogeneous problem */
    a.g = NULL;
    const int n[2] = {p->dim < 3 ? l.n[0] : l.n[0] * l.n[1], p->dim < 3 ? l.n[1] : l.n[2]};
    double *one = field_of(n, product), *both = field_of(n, product), *rest = field_of(n, no_product);
    for (size_t i = 0; i < a.n; i++) both[i] += rest[i];
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

static const double fractions[] = {0.27, 1, 13.1}; /* t over t_end: most modes survive, some, few */

static void few_modes_and_all_modes_agree(void **state) {
    (void)state;
    for (int sides = 0; sides < 16; sides++)
        for (int node = 0; node < 2; node++) {
            struct problem p = odd_rectangle();
            struct options o = {.dx = 0.02, .h = 1.23, .layout = node ? LAYOUT_NODE : LAYOUT_LATTICE};
            for (int s = 0; s < 4; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
            compare_modes(&p, &o, p.t_end * fractions[sides % 3]);
        }
}

/* A layer of a box is a plane, and the product one of a plane and a line. */
static void few_modes_and_all_modes_of_a_box_agree(void **state) {
    (void)state;
    for (int sides = 0; sides < 64; sides += 7) {
        struct problem p = odd_box();
        struct options o = {.dx = 0.05, .h = 1.1};
        for (int s = 0; s < 6; s++) p.side[s] = sides >> s & 1 ? NEUMANN : DIRICHLET;
        compare_modes(&p, &o, p.t_end * fractions[sides % 3]);
    }
}

/* ---- rates ---- */

/* sum_ij w_ij (cos i a cos j b - 1) over all four quadrants, in long double */
static long double rate(const struct heat_operator *a, long double x, long double y) {
    long double sum = 0;
    for (int j = 0; j <= a->reach[1]; j++)
        for (int i = 0; i <= a->reach[0]; i++)
            sum += a->weight[j * (a->reach[0] + 1) + i] * (i ? 2 : 1) * (j ? 2 : 1) * (cosl(i * x) * cosl(j * y) - 1);
    return sum;
}

enum { ACROSS = 75 }; /* particles of a lattice of 0.02 m over 1.5 m */

static double first_wave(int i, int j) {
    (void)j;
    return sin(PI * (i + 0.5) / ACROSS);
}

static double third_wave(int i, int j) {
    (void)j;
    return sin(3 * PI * (i + 0.5) / ACROSS);
}

/* A wave of 1e-9 K beside one of 1 K adds 1e-9 of its own solution. */
static void faint_mode_is_kept(void **state) {
    (void)state;
    struct problem p = odd_rectangle();
    struct options o = {.dx = 0.02, .h = 1.23};
    struct lattice l;
    struct heat_operator a;
    struct failure why;
    assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
    assert_int_equal(l.n[0], ACROSS);
    assert_int_equal(operator_create_lattice(&a, &p, &o, method_so_ssph.scheme, &l, &why), STATUS_OK);
    free(a.g); /* the homogeneous problem */
    a.g = NULL;
    double *one = field_of(l.n, first_wave), *both = field_of(l.n, first_wave), *faint = field_of(l.n, third_wave);
    for (size_t i = 0; i < a.n; i++) both[i] += 1e-9 * faint[i];
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, one);
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, both);
    stepper_of(STEPPER_EXACT)->evolve(&a, p.t_end, faint);
    /* the start is 1 K; transforms of 75 x 60 have round-off of some ten eps */
    for (size_t i = 0; i < a.n; i++) assert_near(both[i] - one[i], 1e-9 * faint[i], 2e-14);
    assert_order(fabs(faint[ACROSS / 2]), >, 0.5); /* exp(-0.37) */
    free(one);
    free(both);
    free(faint);
    operator_free(&a);
}

/* A mode of a rectangle of 300 x 240, taken until it is 1/e of itself.  Rates to 16 eps, |z| = 1, exp to one: 6 eps;
 * transforms to 3.4 eps a level of the 2-norm, half of the mode's largest value; there are two along each
 * axis with 9 levels, and all of it at one place.  Rates rounded as the weights are would be off by eps sum |w|/rate,
 * some 1e4 eps. */
static void slow_modes_keep_their_rates(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct problem p = odd_rectangle();
        struct options o = {.dx = 0.005, .h = 1.23};
        struct lattice l;
        struct heat_operator a;
        struct failure why;
        for (int s = 0; s < 4; s++) p.side[s] = NEUMANN;
        assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
        assert_int_equal(operator_create_lattice(&a, &p, &o, method_so_ssph.scheme, &l, &why), STATUS_OK);
        free(a.g); /* the homogeneous problem */
        a.g = NULL;
        double angle[2] = {transform_angle(&l, 0, k + 1), transform_angle(&l, 1, 2 * k)};
        double *T = xcalloc(a.n, sizeof *T), worst = 0, e = exp(-1);
        for (size_t i = 0; i < a.n; i++)
            T[i] = cos(angle[0] * ((int)i % l.n[0] + 0.5)) * cos(angle[1] * ((int)i / l.n[0] + 0.5));
        stepper_of(STEPPER_EXACT)->evolve(&a, (double)(-1 / rate(&a, angle[0], angle[1])), T);
        for (size_t i = 0; i < a.n; i++) {
            double start = cos(angle[0] * ((int)i % l.n[0] + 0.5)) * cos(angle[1] * ((int)i / l.n[0] + 0.5));
            worst = fmax(worst, fabs(T[i] - e * start));
        }
        assert_near(worst, 0, (6 + 3.4 * 4 * 9 / 2) * DBL_EPSILON);
        free(T);
        operator_free(&a);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_has_one_coefficient),        cmocka_unit_test(transform_pair_is_the_identity),
        cmocka_unit_test(robin_angles_solve_their_equation), cmocka_unit_test(sum_of_products_is_recovered),
        cmocka_unit_test(full_rank_field_is_not_split),      cmocka_unit_test(nearly_equal_rows_are_distinguished),
        cmocka_unit_test(few_modes_and_all_modes_agree),     cmocka_unit_test(faint_mode_is_kept),
        cmocka_unit_test(slow_modes_keep_their_rates),       cmocka_unit_test(few_modes_and_all_modes_of_a_box_agree),
    };
    return cmocka_run_group_tests_name("exact", tests, NULL, NULL);
}
