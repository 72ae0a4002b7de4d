/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run counts and reports beside its errors, by hand: pairs, stages, applications, the mesh Fourier number. */
#include "solver/time/stepper.h"
#include "verification/command/arguments.h"
#include "verification/run/run.h"

#include "verification/unit/near.h"

#include <float.h>
#include <math.h>

static struct result result_of(const char *line) {
    struct request r;
    struct failure why;
    struct result result;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    arguments_free(&r);
    return result;
}

/* Within 2.2 dx lie 2 on either side, and in the plane (1, 0), (1, 1), (2, 0) and what is alike. */
static void pairs_are_neighbours(void **state) {
    (void)state;
    struct result rod = result_of("run rod-cosine so_ssph --dx 0.05 --stepper euler --fourier 0.2");
    assert_near((double)rod.cost.interactions / (double)rod.cost.updates, 4, 0);
    struct result plane = result_of("run plate brookshaw --dx 0.01 --stepper euler --fourier 0.1");
    assert_near((double)plane.cost.interactions / (double)plane.cost.updates, 12, 0);
}

/* kappa = 0.013 m^2/s */
static void the_fourier_number_is_that_of_the_step(void **state) {
    (void)state;
    struct result r = result_of("run rod-cosine so_ssph --dx 0.05 --stepper euler --dt 0.01 --set kappa=0.013");
    assert_near(r.fourier, r.dt * 0.013 / (0.05 * 0.05), 1e-14);
}

/* What rounding can make up of E1: eps for the data, sqrt(applications) for T that is rounded at random, and
 * 4 dim kappa t/dx^2 for weights that are wrong alike at every step. */
static void what_rounding_adds(void **state) {
    (void)state;
    struct result euler = result_of("run rod-cosine so_ssph --dx 0.05 --stepper euler --dt 0.01 --set kappa=0.013");
    assert_near(euler.rounding / DBL_EPSILON, 1 + sqrt((double)euler.steps) + 4 * 0.013 * euler.t_end / (0.05 * 0.05),
                1e-9);
    struct result rk2 = result_of("run rect-manufactured so_ssph --dx 0.1 --stepper rk2 --dt 0.02");
    assert_near(rk2.rounding / DBL_EPSILON,
                1 + sqrt(2.0 * (double)rk2.steps) + 8 * 0.02 / 1.7 * rk2.t_end / (0.1 * 0.1), 1e-9);
}

/* RKL2 is stable for dt lambda <= (s^2 + s - 2)/2 (Meyer, Balsara, Aslam 2014, eq. 21, with lambda = 2/dt_expl): the
 * fewest odd s that holds it, and 3 at least. */
static void stages_are_the_fewest_that_are_stable(void **state) {
    (void)state;
    for (double z = 0.01; z < 1e6; z *= 1.37) {
        int s = stepper_of(STEPPER_RKL2)->count(z / 7.3, 7.3);
        assert_true(s >= 3 && s % 2 == 1);
        assert_order(z, <=, (s * s + s - 2) / 2.0 * (1 + 1e-8));
        if (s > 3) assert_order(z, >, ((s - 2) * (s - 2) + (s - 2) - 2) / 2.0);
    }
}

static void the_bound_of_stages_is_met(void **state) {
    (void)state;
    for (int s = 3; s < 1000; s += 2) {
        double z = (s * s + s - 2) / 2.0;
        assert_int_equal(stepper_of(STEPPER_RKL2)->count(z * (1 - 1e-6), 1), s);
        assert_int_equal(stepper_of(STEPPER_RKL2)->count(z * (1 + 1e-6), 1), s + 2);
    }
}

/* Where the start jumps the first step is two damped quarters, dt lambda <= 4/3 (s^2 + 5 s - 6), and a half.  From
 * the stages of the others dt lambda is known between two bounds. */
static void a_damped_start_takes_what_its_parts_need(void **state) {
    (void)state;
    for (double z = 0.01; z < 1e6; z *= 1.37) {
        int s[2];
        stepper_of(STEPPER_RKL2)->first(z / 7.3, 7.3, s);
        assert_order(s[0], >=, 2);
        assert_order(z, <=, 4.0 / 3 * (s[0] * (s[0] + 5) - 6) * (1 + 1e-8));
        if (s[0] > 2) assert_order(z, >, 4.0 / 3 * ((s[0] - 1) * (s[0] + 4) - 6));
        assert_int_equal(s[1], stepper_of(STEPPER_RKL2)->count(z / 2, 1));
    }
    struct result r = result_of("run rod-step so_ssph --dx 0.02 --stepper rkl2 --dt 0.5 --domain whole");
    long long first = r.cost.updates / (long long)r.particles - (r.steps - 1) * r.stages;
    int least[2], most[2], s = r.stages;
    stepper_of(STEPPER_RKL2)->first(1, ((s - 2) * (s - 1) - 2) / 2.0, least);
    stepper_of(STEPPER_RKL2)->first(1, (s * (s + 1) - 2) / 2.0, most);
    assert_order(s, >, 3);
    assert_order(first, >=, 2 * least[0] + least[1]);
    assert_order(first, <=, 2 * most[0] + most[1]);
}

/* n particles do 8 n updates between two waits. */
static void threads_have_work(void **state) {
    (void)state;
    const size_t one = STEPPER_SHARE / 8;
    assert_int_equal(stepper_threads(0, 100 * one), 1);
    assert_int_equal(stepper_threads(4, 2 * one - 1), 1);
    assert_int_equal(stepper_threads(4, 2 * one), 2);
    assert_int_equal(stepper_threads(4, 3 * one), 3);
    assert_int_equal(stepper_threads(4, 100 * one), 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_have_work),
        cmocka_unit_test(pairs_are_neighbours),
        cmocka_unit_test(the_fourier_number_is_that_of_the_step),
        cmocka_unit_test(what_rounding_adds),
        cmocka_unit_test(stages_are_the_fewest_that_are_stable),
        cmocka_unit_test(the_bound_of_stages_is_met),
        cmocka_unit_test(a_damped_start_takes_what_its_parts_need),
    };
    return cmocka_run_group_tests_name("counts", tests, NULL, NULL);
}
