/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Kernels: kernel_integrates_to_one in one, two and three dimensions, dw/ds the derivative of w, zero past their
 * support. */
#include "solver/space/kernel.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

struct shell {
    enum kernel_name kernel;
    int dim;
};

static double shell_value(double s, void *context) {
    const struct shell *c = context;
    double area = c->dim == 1 ? 2 : c->dim == 2 ? 2 * M_PI * s : 4 * M_PI * s * s;
    return area * kernel_value(c->kernel, c->dim, s);
}

static void kernel_integrates_to_one(void **state) {
    (void)state;
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(16);
    for (int k = 0; kernel_words[k]; k++)
        for (int dim = 1; dim <= 3; dim++) {
            struct shell c = {(enum kernel_name)k, dim};
            gsl_function f = {shell_value, &c};
            /* polynomials on either side of s = 1, of degree 9 at most: the rule is exact */
            double sum = gsl_integration_glfixed(&f, 0, 1, rule) + gsl_integration_glfixed(&f, 1, 2, rule);
            assert_near(sum, 1, 1e-14);
        }
    gsl_integration_glfixed_table_free(rule);
}

static void slope_is_the_derivative(void **state) {
    (void)state;
    const double e = 1e-3;
    for (int k = 0; kernel_words[k]; k++)
        for (int dim = 1; dim <= 3; dim++)
            for (double s = 0.137; s < 1.99; s += 0.211) {
                enum kernel_name kernel = (enum kernel_name)k;
                double d1 = (kernel_value(kernel, dim, s + e) - kernel_value(kernel, dim, s - e)) / (2 * e);
                double d2 = (kernel_value(kernel, dim, s + 2 * e) - kernel_value(kernel, dim, s - 2 * e)) / (4 * e);
                /* fourth order; a knot at s = 1 is farther away than 2 e from every sample */
                assert_near(kernel_slope(kernel, dim, s), (4 * d1 - d2) / 3, 1e-10);
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

static void kernel_is_zero_past_its_support(void **state) {
    (void)state;
    for (int k = 0; kernel_words[k]; k++) {
        assert_near(kernel_value((enum kernel_name)k, 2, 2.0), 0, 0);
        assert_near(kernel_slope((enum kernel_name)k, 2, 2.385), 0, 0);
        assert_near(kernel_value((enum kernel_name)k, 2, 2 - 1e-9), 0, 1e-9);
    }
}

static void quartic_is_negative_near_its_edge(void **state) {
    (void)state;
    assert_order(kernel_value(KERNEL_QUARTIC, 2, 1.9), <, 0);
    assert_order(kernel_slope(KERNEL_QUARTIC, 2, 1.9), >, 0);
    for (double s = 0.05; s < 2; s += 0.05) assert_order(kernel_value(KERNEL_CUBIC, 2, s), >, 0);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kernel_integrates_to_one),          cmocka_unit_test(slope_is_the_derivative),
        cmocka_unit_test(second_derivatives_of_kernels),     cmocka_unit_test(kernel_is_zero_past_its_support),
        cmocka_unit_test(quartic_is_negative_near_its_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
