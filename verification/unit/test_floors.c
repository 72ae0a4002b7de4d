/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lower bounds of a measured error: the rounding of a run and of its exact solution. */
#include "references/scene.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/near.h"

#include <float.h>
#include <gsl/gsl_errno.h>

/* A start at 1e6 K is rounded to 2 eps of itself at least, late too. */
static void plate_bound_covers_round_off_of_its_data(void **state) {
    (void)state;
    struct command r;
    struct failure why;
    if (command_read("run plate so_ssph --dx 0.01 --set T0=1e6 --set T1=1000001 --set T2=1000002 --set "
                     "T3=1000003 --set T4=1000004",
                     &r, &why))
        fail_msg("%s", why.text);
    for (double t = 0.1; t < 2000; t *= 10) {
        struct exact e = scene_exact(r.experiment.scene, &r.experiment.problem, (double[2]){0.03, 0.07}, t);
        assert_order(e.error_bound, >=, 2 * DBL_EPSILON * 1e6);
    }
    command_free(&r);
}

/* Modes of one Robin wall are sums of n values, each rounded: 6.8 eps n. */
static void robin_sums_round_in_proportion_to_length(void **state) {
    (void)state;
    struct command r;
    struct result result;
    struct field f;
    struct failure why;
    if (command_read("run rod-cooling so_ssph --dx 1/400", &r, &why)) fail_msg("%s", why.text);
    assert_int_equal(run_experiment(&r.experiment, &result, &f), STATUS_OK);
    assert_order(result.rounding, >, 6.8 * DBL_EPSILON * (double)f.n);
    field_free(&f);
    command_free(&r);
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plate_bound_covers_round_off_of_its_data),
        cmocka_unit_test(robin_sums_round_in_proportion_to_length),
    };
    return cmocka_run_group_tests_name("floors", tests, NULL, NULL);
}
