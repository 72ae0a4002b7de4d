/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calibration by coarse rungs: luck does not count, neither of the places nor of one rung alone. */
#include "verification/choose/extrapolation.h"

#include "verification/choose/choose.h"
#include "verification/command/arguments.h"

#include "verification/unit/near.h"

#include <string.h>

static const struct candidate *candidate(const char *label) {
    const struct candidate *k = candidates_table;
    while (k->label && strcmp(k->label, label) != 0) k++;
    assert_non_null(k->label);
    return k;
}

static struct extrapolation calibrated(const char *line, const char *label, double error) {
    struct request r;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    struct extrapolation c = {.candidate = candidate(label)};
    struct extrapolation_goal goal = {&r.experiment, error, choose_work_max, candidate_unit(&r.experiment.problem)};
    extrapolation_calibrate(&c, &goal);
    arguments_free(&r);
    return c;
}

/* Nine particles on the zeros of cos(9 pi x): exact where they are, and off by the whole wave between, w in either
 * direction from a mean of 1 at eight places. */
static void a_rung_is_not_exact_for_its_places_alone(void **state) {
    (void)state;
    struct extrapolation c = calibrated("reference rod-cosine --set mode=9 --set kappa=0.0005 --at 0 --time 1",
                                        "so_ssph exact, h/dx 0.9", 1e-5);
    double w = 0.7 * exp(-0.0005 * pow(9 * 3.14159265358979323846, 2));
    int seen = 0;
    for (int i = 0; i < c.rungs; i++) {
        if (c.rung[i].n != 9) continue;
        seen = 1;
        assert_near(c.rung[i].error, w, 1e-9);
    }
    assert_int_equal(seen, 1);
}

/* An error that the coarsest rungs have already: the second one has to have it too. */
static void two_rungs_end_the_calibration(void **state) {
    (void)state;
    struct extrapolation c =
        calibrated("reference rod-gauss --at 0 --time 1 --set kappa=0.1", "so_ssph exact, h/dx 0.9", 3e-2);
    assert_order(c.rungs, >=, 2);
    assert_order(c.rungs, <, 10);
    for (int i = 0; i < c.rungs; i++) assert_int_equal(c.rung[i].error <= 3e-2, i >= c.rungs - 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rung_is_not_exact_for_its_places_alone),
        cmocka_unit_test(two_rungs_end_the_calibration),
    };
    return cmocka_run_group_tests_name("calibrate", tests, NULL, NULL);
}
