/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact stepper at fine spacings: rates are right to some roundings of themselves, and not of the weights, which
 * are kappa/dx^2. */

#include "solver/time/stepper.h"
#include "solver/space/operator.h"
#include "solver/time/transform.h"
#include "verification/command/command_run.h"

#include "verification/unit/near.h"
#include "verification/unit/odd_problems.h"

#include <float.h>
#include <stdlib.h>

extern const struct method method_so_ssph;

/* sum_ij w_ij (cos i a cos j b - 1) over all four quadrants, in long double */
static long double rate(const struct heat_operator *a, long double x, long double y) {
    long double sum = 0;
    for (int j = 0; j <= a->reach[1]; j++)
        for (int i = 0; i <= a->reach[0]; i++)
            sum += a->weight[j * (a->reach[0] + 1) + i] * (i ? 2 : 1) * (j ? 2 : 1) * (cosl(i * x) * cosl(j * y) - 1);
    return sum;
}

/* A mode of a rectangle of 300 x 240, taken until it is 1/e of itself.  Rates to 16 eps, |z| = 1, exp to one: 6 eps;
 * transforms to 3.4 eps a level of the 2-norm, half of the mode's largest value, of which there are two along each
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
        assert_int_equal(layout_lattice(&p, &o, 1, &l, &why), STATUS_OK);
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

/* Second order to the end: E1 falls by 40^2.  The next term is (0.02 m / 2 m)^2 of it, with sigma0 = 2 m; rounding is
 * what the run says. */
static void the_order_lasts(void **state) {
    (void)state;
    struct command_run coarse, fine;
    assert_int_equal(command_run_line(&coarse, "run rod-gauss so_ssph --dx 0.02"), STATUS_OK);
    assert_int_equal(command_run_line(&fine, "run rod-gauss so_ssph --dx 0.0005"), STATUS_OK);
    const struct result *f = &fine.result;
    assert_order(f->rounding, <, 1e-3 * f->error.l1);
    assert_near(1600 * f->error.l1 / coarse.result.error.l1, 1, 1e-4 + f->rounding / f->error.l1);
    command_run_free(&coarse);
    command_run_free(&fine);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slow_modes_keep_their_rates),
        cmocka_unit_test(the_order_lasts),
    };
    return cmocka_run_group_tests_name("exact", tests, NULL, NULL);
}
