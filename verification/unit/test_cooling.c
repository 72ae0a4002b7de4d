/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cooled ends: no root is missed and each is accurate to the last bit; half lines and modes satisfy their equations;
 * the scenes have the limits of an insulated and of a Dirichlet end. */
#include "references/cooling.h"

#include "references/cooled_plate.h"
#include "references/roots.h"
#include "verification/unit/odd_scenes.h"

#include <float.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <stdlib.h>

/* z cot z = -biot and z tan z = biot by bisection in 40 digits. */
static void robin_roots_equal_known_values(void **state) {
    (void)state;
    static const struct {
        int n, insulated;
        double biot, z;
    } known[] = {
        {1, 0, 0.37, 1.776172342176420698232},      {1, 1, 0.37, 0.5732025235114154397751},
        {3, 0, 14.423, 8.873246010034986667007},    {3, 1, 14.423, 7.380977853508463440951},
        {1, 1, 1e-12, 9.999999999998333232767e-7},  {1, 0, 1e-12, 1.570796326795533239004},
        {2, 1, 3.1e-09, 3.141592654576553885322},   {7, 0, 2500000.0, 21.99113977867264142706},
        {7, 1, 2500000.0, 20.42034408019602415325}, {400, 0, 0.001, 1255.066265905893077068},
        {400, 1, 911.0, 1254.12369639422967525},    {1, 1, 1e+18, 1.570796326794896617661},
        {2, 0, 1e+18, 6.283185307179586470642},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double z = roots_cooled(known[i].n, known[i].insulated, known[i].biot);
        assert_near(z, known[i].z, 2 * DBL_EPSILON * known[i].z);
    }
}

/* One root between neighbouring multiples of pi/2, for any biot: each obeys its equation to rounding. */
static void robin_roots_are_complete(void **state) {
    (void)state;
    for (double biot = 1e-20; biot < 1e21; biot *= 7.3)
        for (int insulated = 0; insulated < 2; insulated++)
            for (int n = 1; n <= 60; n++) {
                double z = roots_cooled(n, insulated, biot), hi = (n - insulated * 0.5) * M_PI, size = hypot(z, biot);
                assert_order(z, >=, (hi - M_PI / 2) * (1 - 2 * DBL_EPSILON));
                assert_order(z, <=, hi * (1 + DBL_EPSILON));
                double residual = insulated ? z * sin(z) - biot * cos(z) : z * cos(z) + biot * sin(z);
                assert_near(residual / size, 0, 4 * DBL_EPSILON * (z + z / size));
            }
    for (int n = 1; n < 9; n++) {
        assert_near(roots_cooled(n, 0, 0), (n - 0.5) * M_PI, DBL_EPSILON * n);
        assert_near(roots_cooled(n, 0, INFINITY), n * M_PI, 0);
        assert_near(roots_cooled(n, 1, 0), (n - 1) * M_PI, 0);
        assert_near(roots_cooled(n, 1, INFINITY), (n - 0.5) * M_PI, DBL_EPSILON * n);
    }
}

/* The derivative that each wall law states, against differences of its flux; each kind has its words. */
static void laws_state_their_derivatives(void **state) {
    (void)state;
    for (int kind = DIRICHLET; kind <= PERIODIC; kind++) {
        const struct wall_law *law = &problem_laws[kind];
        struct problem p = {.robin = {0.37, 1.3}};
        double slope, ignored, h = 1e-4;
        assert_non_null(law->name);
        assert_non_null(law->word);
        if (!law->exchange) continue;
        law->exchange(&p, X_HI, 0.7, 290, 310, &slope);
        double above = law->exchange(&p, X_HI, 0.7, 290, 310 + h, &ignored);
        double below = law->exchange(&p, X_HI, 0.7, 290, 310 - h, &ignored);
        assert_near((above - below) / (2 * h) / slope, 1, 1e-8);                 /* rounding: 1e-16 * 30 K/h */
        assert_near(law->exchange(&p, X_HI, 0.7, 310, 310, &ignored), 0, 1e-12); /* no flux at equal temperatures */
    }
}

/* At the end the flux is that to the air; both slopes agree with differences; far from the end the temperature is
 * unchanged; as h tends to infinity the end becomes a Dirichlet end. */
static void cooled_half_line_meets_its_conditions(void **state) {
    (void)state;
    for (double h = 0.01; h < 1e4; h *= 13)
        for (double s = 0.003; s < 30; s *= 4.7) {
            struct cooling_half end = cooling_half(0, h, s);
            assert_near(end.slope, h * end.T, 4 * DBL_EPSILON * h);
            assert_near(cooling_half(6.3 * s, h, s).T, 1, 1e-15);
            for (double d = 0.1 * s; d < 4 * s; d += 0.7 * s) {
                double e = 1e-3 * s;
                double by_d = (8 * (cooling_half(d + e, h, s).T - cooling_half(d - e, h, s).T) -
                               (cooling_half(d + 2 * e, h, s).T - cooling_half(d - 2 * e, h, s).T)) /
                              (12 * e);
                double by_s = (8 * (cooling_half(d, h, s + e).T - cooling_half(d, h, s - e).T) -
                               (cooling_half(d, h, s + 2 * e).T - cooling_half(d, h, s - 2 * e).T)) /
                              (12 * e);
                assert_near(cooling_half(d, h, s).slope, by_d, 2e-11 / s);
                assert_near(cooling_half(d, h, s).change, by_s, 2e-11 / s);
            }
        }
    assert_near(cooling_half(0.2, 1e17, 0.3).T, erf(0.2 / 0.3), 1e-15);
    for (double y = 4.9; y < 25; y += 0.07) /* exp(y^2) erfc(y) by either way; exp rounds y^2 */
        assert_near(cooling_half(0, 2 * y, 1).end, exp(y * y) * erfc(y), 4e-16 * y * y * exp(y * y) * erfc(y));
    assert_near(cooling_half(0.2, 0, 0.3).T, 1, 0);
}

static struct surface surface_at(const struct cooled_plate *c, const double x[2]) {
    struct surface T;
    cooled_plate_at(c, 1, &x[0], &x[1], &T);
    return T;
}

/* Early the double series would take modes without number: it says that it has no bound, and at once.  As long as it
 * has one, it holds. */
static void series_without_a_bound_reports_infinity(void **state) {
    (void)state;
    int bounded = 0, unbounded = 0;
    for (double s = 0.3; s > 1e-9; s /= 2.3) {
        struct cooled_plate *c = cooled_plate(0.6, 1, 14.4, 100, 37, s);
        const double x[2] = {0.41, 0.0087};
        struct surface T = surface_at(c, x);
        struct approx U = cooled_plate_series(0.6, 1, 14.4, 100, 37, s, x);
        free(c);
        if (isfinite(U.error)) assert_near(U.value, T.at.value, U.error + T.at.error);
        bounded += U.error < 1e-8, unbounded += isinf(U.error);
    }
    assert_order(bounded, >=, 5);
    assert_order(unbounded, >=, 5);
}

/* On the hot side the gradient is the limit of that beside it; in the corner it grows without bound, and says so. */
static void gradient_on_the_hot_side_is_its_limit(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    const struct scene *s = scene_find("plate-cooling");
    scene_defaults(s, &p);
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    for (double u = 1e-3; u < 0.6; u *= 2.1) {
        struct exact on = scene_exact(s, &p, (double[2]){0.6 - u, 0}, 3000);
        struct exact off = scene_exact(s, &p, (double[2]){0.6 - u, 1e-7 * u}, 3000);
        assert_near(on.temperature, 100, on.error_bound);
        assert_near(on.gradient[1], off.gradient[1], 1e-5 * fabs(off.gradient[1]));
        assert_near(on.gradient[0], 0, on.gradient_bound[0]);
    }
    struct exact corner = scene_exact(s, &p, (double[2]){0.6, 0}, 3000);
    assert_near(corner.temperature, 100, corner.error_bound);
    assert_true(isinf(corner.gradient[1]));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(robin_roots_equal_known_values),
        cmocka_unit_test(robin_roots_are_complete),
        cmocka_unit_test(laws_state_their_derivatives),
        cmocka_unit_test(cooled_half_line_meets_its_conditions),
        cmocka_unit_test(series_without_a_bound_reports_infinity),
        cmocka_unit_test(gradient_on_the_hot_side_is_its_limit),
    };
    gsl_set_error_handler_off();
    return cmocka_run_group_tests_name("cooling", tests, NULL, NULL);
}
