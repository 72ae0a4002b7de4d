/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The error of derivative weights depends on the available neighbours. */
#include "verification/stability/consistency.h"

#include "solver/space/operator.h"
#include "verification/case/command.h"

#include "verification/unit/stencil_moments.h"

#include <complex.h>
#include <float.h>

/* Leaves NaN in the stack memory that the next function uses for its arrays. */
static double __attribute__((noinline)) spoil(void) {
    volatile double at[16 * NEIGHBOURS_MAX];
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) at[i] = NAN;
    return at[7];
}

static void memory_past_the_last_neighbour_is_not_read(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-gauss so_ssph --dx 0.1", "run square-step fo_ssph --dx 0.1"};
    for (int k = 0; k < 2; k++) {
        struct command r;
        struct failure why;
        double error;
        if (command_read(lines[k], &r, &why)) fail_msg("%s", why.text);
        assert_nan(spoil());
        assert_int_equal(consistency_error(&r.experiment, &error, &why), STATUS_OK);
        assert_order(error, >, 0);
        assert_order(error, <, 0.1); /* second order: dx^2 b^4 over 12 and more, b = 1.1 m^-1 */
        command_free(&r);
    }
}

/* The function is the imaginary part of exp(z.x + i c), with z = a + i b along each axis; its derivatives are powers
 * of z.  A stencil multiplies it by S = sum w (exp(z.d) - 1), the exact operator by E = kappa_x z_x^2 + kappa_y
 * z_y^2. */
static void assert_symbol(const char *line, const char *method, const double kappa[2]) {
    const double complex z[2] = {0.3 + 1.1 * I, -0.2 + 0.7 * I};
    struct command r;
    struct failure why;
    double error, off = 0, size = 0, dx;
    double complex S = 0, E = 0;
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    assert_int_equal(consistency_error(&r.experiment, &error, &why), STATUS_OK);
    dx = r.experiment.options.dx;
    command_free(&r);
    struct stencil s = stencil_of(method, kappa);
    for (int a = 0; a < 2; a++) E += kappa[a] * z[a] * z[a];
    for (int j = -s.reach[1]; j <= s.reach[1]; j++)
        for (int i = -s.reach[0]; i <= s.reach[0]; i++)
            S += stencil_weight(&s, i, j) / (dx * dx) * (cexp(dx * (i * z[0] + j * z[1])) - 1);
    for (int k = 0; k < 16; k++) {
        double complex u = cexp((-1 + 0.137 * k) * z[0] + (0.9 - 0.119 * k) * z[1] + 0.4 * I);
        off += fabs(cimag((S - E) * u));
        size += fabs(cimag(E * u));
    }
    free(s.w);
    /* a sum of some 20 weights of size kappa/dx^2, rounded, beside kappa z^2 */
    assert_near(error, off / size, 100 * DBL_EPSILON / (dx * dx));
}

static void operator_error_equals_the_symbol_error(void **state) {
    (void)state;
    assert_symbol("run square-step so_ssph --h 1.1 --dx 0.1 --set kappa_x=0.013 --set kappa_y=0.0029", "so_ssph",
                  (double[]){0.013, 0.0029});
    assert_symbol("run square-step brookshaw --h 1.1 --dx 0.07 --set kappa_x=0.013 --set kappa_y=0.013", "brookshaw",
                  (double[]){0.013, 0.013});
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_past_the_last_neighbour_is_not_read),
        cmocka_unit_test(operator_error_equals_the_symbol_error),
    };
    return cmocka_run_group_tests_name("consistency", tests, NULL, NULL);
}
