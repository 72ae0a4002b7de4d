/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ceiling holds only where the error is a number below it, whatever the gate itself has measured. */
#include "solver/method.h"

#include "verification/gates/gates.h"

#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <string.h>

static struct measured judge(const char *command, double ceiling) {
    const struct gate gate = {"odd", TIER_QUICK, "overshoot", command, 0, 1e-12, ceiling, "a test of ceilings"};
    struct measured m;
    gates_judge(&gate, NULL, &m);
    return m;
}

static void an_error_below_it_passes(void **state) {
    (void)state;
    assert_int_equal(judge("run rod-step so_ssph --dx 0.1", 0.007).verdict, VERDICT_PASS);
}

static void an_error_above_it_fails(void **state) {
    (void)state;
    struct measured m = judge("run rod-step so_ssph --dx 0.1", 0.003);
    assert_int_equal(m.verdict, VERDICT_FAIL);
    assert_has(m.reason, "above its ceiling");
}

/* A limit of stability has no error. */
static void an_error_that_is_not_a_number_fails(void **state) {
    (void)state;
    const char *command = "limit so_ssph --dim 1 --kernel cubic --h 1.05";
    const struct gate gate = {"odd", TIER_QUICK, "limit_published", command, 0.95, 1, 1, "a test of ceilings"};
    struct measured m;
    gates_judge(&gate, NULL, &m);
    assert_order(0.95, <=, m.value);
    assert_order(m.value, <=, 1);
    assert_nan(m.error);
    assert_int_equal(m.verdict, VERDICT_FAIL);
}

/* At order 4 the hot piece leaves nothing above 10 K, and some 1e-4 K below 0. */
static void what_is_below_the_data_counts_as_overshoot(void **state) {
    (void)state;
    struct measured m = judge("run rod-step so_ssph --dx 0.1 --order 4", 1);
    assert_order(m.value, >, 1e-5);
    assert_order(m.value, <, 1e-3);
    assert_int_equal(m.verdict, VERDICT_FAIL);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_below_it_passes),
        cmocka_unit_test(an_error_above_it_fails),
        cmocka_unit_test(an_error_that_is_not_a_number_fails),
        cmocka_unit_test(what_is_below_the_data_counts_as_overshoot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
