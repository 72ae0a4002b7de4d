/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exp(dt A) by polynomials: on one eigenvalue at a time, and through the march of one equation. */
#include "solver/time/stepper.h"

#include "verification/unit/near.h"

#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

/* T of dT/dt = heat - rate T after a step from T0. */
static double step(double dt, double bound, double rate, double heat, double T0) {
    int degree = stepper_of(STEPPER_CHEBYSHEV)->count(dt, bound);
    struct update *u = calloc((size_t)degree, sizeof *u);
    double before = NAN, T = T0;
    assert_non_null(u);
    stepper_of(STEPPER_CHEBYSHEV)->updates(dt, bound, degree, u);
    assert_near(u[0].start, 0, 0);
    assert_near(u[0].old + u[1].old, 0, 0);
    for (int k = 0; k < degree; k++) {
        assert_near(u[k].self + u[k].old + u[k].start, 1, 4e-16 * (1 - u[k].old)); /* what is constant stays so */
        double old = k < 2 ? 0 : u[k].old * before;
        double next = u[k].rate * (heat - rate * T) + u[k].self * T + old + u[k].start * T0;
        before = T, T = next;
    }
    free(u);
    return T;
}

/* Rounding grows as h^(5/4), h = dt bound/2: all errors of one sign would be h^(3/2) / 6. */
static void an_eigenvalue_gets_its_exponential(void **state) {
    (void)state;
    const double bound = 7.3;
    for (double z = 1e-7; z < 262144; z *= 2.7) {
        double dt = z / bound, h = z / 2, rounding = 4e-16 * (1 + pow(h, 1.5) / 6);
        for (double part = 0; part <= 1; part += 0.0625) {
            double rate = part * part * bound;
            assert_near(step(dt, bound, rate, 0, 1.3), 1.3 * exp(-rate * dt), 3 * rounding);
        }
        /* walls and sources come in: to 2.1 from 1.3 */
        double rate = 0.31 * bound;
        assert_near(step(dt, bound, rate, 2.1 * rate, 1.3), 2.1 - 0.8 * exp(-rate * dt), 3 * rounding);
        assert_near(step(dt, bound, 0, 0, 1.3), 1.3, 3 * rounding);
    }
}

/* What is left out is less than half a rounding error, 2^-53; with an eighth fewer terms it is more. */
static void the_degree_is_enough_and_not_much_more(void **state) {
    (void)state;
    for (double h = 2.5; h < 131072; h *= 3.1) {
        int degree = stepper_of(STEPPER_CHEBYSHEV)->count(2 * h / 7.3, 7.3);
        double rest = 0, more = 0;
        for (int k = degree + 1; k < 5 * degree / 4; k++) rest += 2 * gsl_sf_bessel_In_scaled(k, h);
        for (int k = 7 * degree / 8; k < 5 * degree / 4; k++) more += 2 * gsl_sf_bessel_In_scaled(k, h);
        assert_order(rest, <, ldexp(1, -53));
        assert_order(more, >, ldexp(1, -53));
    }
    assert_near(stepper_of(STEPPER_CHEBYSHEV)->length(0, 1e9, 7.3) * 7.3, 262144, 1e-9);
}

static int march(double rate, double time, long long steps, double *T) {
    size_t row[2] = {0, 0}, bytes = 0;
    double diagonal[1] = {-rate};
    struct heat_operator a = {.n = 1, .state = 1, .row = row, .diagonal = diagonal};
    struct march m = {.stepper = STEPPER_CHEBYSHEV, .time = time, .steps = steps, .hi = 2, .bound = 1.7};
    struct failure why;
    m.stages = stepper_of(STEPPER_CHEBYSHEV)->count(time / (double)steps, m.bound);
    return stepper_march(&a, &m, T, &bytes, &why);
}

static void a_march_is_exact_in_any_number_of_steps(void **state) {
    (void)state;
    for (int steps = 1; steps < 50; steps = 3 * steps + 1)
        for (double time = 0.1; time < 300; time *= 7) {
            double T = 1.3;
            assert_int_equal(march(0.9, time, steps, &T), STATUS_OK);
            assert_near(T, 1.3 * exp(-0.9 * time), 1e-13);
        }
    double T = 1.3;
    assert_int_equal(march(1.9, 90, 1, &T), STATUS_UNSTABLE); /* beyond the bound */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_eigenvalue_gets_its_exponential),
        cmocka_unit_test(the_degree_is_enough_and_not_much_more),
        cmocka_unit_test(a_march_is_exact_in_any_number_of_steps),
    };
    return cmocka_run_group_tests_name("chebyshev", tests, NULL, NULL);
}
