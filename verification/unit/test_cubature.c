/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cubature: exact for polynomials; knots resolve narrow features; its bounds hold. */
#include "references/cubature.h"

#include "verification/unit/near.h"

#include <float.h>

struct feature {
    int shape; /* which of the integrands */
    double width;
};

/* The rule is exact for degree 11; the largest value here is 2. */
static struct approx polynomial(const void *data, const double x[2]) {
    (void)data;
    return (struct approx){pow(x[0], 11) + pow(x[1], 10), 0};
}

static void polynomials_are_exact(void **state) {
    (void)state;
    const double lo[2] = {0, -1}, hi[2] = {1, 1};
    struct approx mean = cubature_mean(polynomial, NULL, 2, lo, hi, &(struct cubature_knots){.count = {0, 0}});
    assert_near(mean.value, 1.0 / 12 + 1.0 / 11, 8 * DBL_EPSILON * 2);
    assert_order(mean.error, <=, (2 + 8) * DBL_EPSILON * 2);
}

static struct approx pulse(const void *data, const double x[2]) {
    const struct feature *c = data;
    double z = (x[0] - 0.3) / c->width;
    return (struct approx){exp(-z * z), 0};
}

static void knot_resolves_a_narrow_pulse(void **state) {
    (void)state;
    struct feature c = {.width = 1e-7};
    const double lo[2] = {-1, 0}, hi[2] = {1, 0};
    struct cubature_knots none = {.count = {0, 0}}, one = {.count = {1, 0}};
    one.knot[0][0].at = 0.3, one.knot[0][0].graded = 1;
    struct approx found = cubature_mean(pulse, &c, 1, lo, hi, &one);
    assert_near(found.value, sqrt(3.14159265358979323846) * c.width / 2, 1e-14);
    assert_near(cubature_mean(pulse, &c, 1, lo, hi, &none).value, 0, 1e-300); /* without a knot the pulse is missed */
}

struct counted {
    int dim;
    int *values;
};

static struct approx growing(const void *data, const double *x) {
    const struct counted *c = data;
    double sum = 0;
    for (int a = 0; a < c->dim; a++) sum += x[a];
    ++*c->values;
    return (struct approx){exp(sum), 0};
}

/* exp(x + y + z), h/l = h: a cell of 0.1 takes 4^2 + 6^2 or 3^3 + 4^3 values, one of 1 is halved. */
static void small_cells_take_two_rules(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int large = 0; large < 2; large++) {
            const double h = large ? 1 : 0.1, lo[DIM_MAX] = {0.2, 0.2, 0.2},
                         hi[DIM_MAX] = {0.2 + h, 0.2 + h, 0.2 + h};
            const double exact = pow(exp(0.2) * expm1(h) / h, dim);
            int values = 0;
            const struct counted c = {dim, &values};
            struct approx mean = cubature_mean(growing, &c, dim, lo, hi, &(struct cubature_knots){.cell = 1});
            assert_near(mean.value, exact, 1e-13 * exact);
            assert_order(fabs(mean.value - exact), <=, mean.error);
            if (large)
                assert_order(values, >, dim == 3 ? 91 : 52);
            else
                assert_int_equal(values, dim == 3 ? 91 : 52);
        }
}

/* Shapes of diffusion, of any width. */
static struct approx shape(const void *data, const double x[2]) {
    const struct feature *c = data;
    double z = (x[0] - 0.3) / c->width;
    const double value[] = {exp(-z * z), erf(z), z * exp(-z * z), 1 / (1 + z * z), exp(-fabs(z))};
    return (struct approx){value[c->shape], 0};
}

/* Their integrals up to z. */
static double below(int which, double z) {
    const double root = sqrt(3.14159265358979323846), bell = exp(-z * z);
    const double value[] = {root / 2 * erf(z), z * erf(z) + bell / root, -bell / 2, atan(z),
                            z < 0 ? exp(z) : 2 - exp(-z)};
    return value[which];
}

static void cubature_bounds_hold_at_every_width(void **state) {
    (void)state;
    const double lo[2] = {-1, 0}, hi[2] = {1, 0};
    struct cubature_knots knots = {.count = {1, 0}};
    knots.knot[0][0].at = 0.3, knots.knot[0][0].graded = 1;
    for (struct feature c = {0}; c.shape < 5; c.shape++)
        for (c.width = 1; c.width > 1e-6; c.width /= 1.02) {
            struct approx mean = cubature_mean(shape, &c, 1, lo, hi, &knots);
            double want = c.width / 2 * (below(c.shape, 0.7 / c.width) - below(c.shape, -1.3 / c.width));
            assert_near(mean.value, want, mean.error);
            assert_near(mean.error, 0, 1e-14 + 8 * DBL_EPSILON);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_exact),
        cmocka_unit_test(knot_resolves_a_narrow_pulse),
        cmocka_unit_test(small_cells_take_two_rules),
        cmocka_unit_test(cubature_bounds_hold_at_every_width),
    };
    return cmocka_run_group_tests_name("cubature", tests, NULL, NULL);
}
