/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choice of a time step, for methods with prescribed errors. */
#include "verification/judge/run.h"
#include "verification/judge/time_step.h"

#include "verification/unit/made_methods.h"
#include "verification/unit/near.h"

#include <stdio.h>

static void exact_stepper_is_the_default_on_a_lattice(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5", &with_exact);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.options.stepper, STEPPER_EXACT);
    assert_near(result.time_error, 0, 0);
    assert_near(result.error[NORM_L1], C * 0.25, 1e-12);
    command_free(&r);
}

/* Another stepper is tried if the exact one has no answer, but not if the input is wrong. */
static void wrong_input_is_not_tried_again(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5", &wrong_input);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_INPUT);
    assert_int_equal(result.options.stepper, STEPPER_EXACT);
    command_free(&r);
}

static void every_status_has_an_exit_status(void **state) {
    (void)state;
    static const int exits[] = {0, 1, 2, 3, 4, 2, 3};
    for (int status = STATUS_OK; status <= STATUS_UNSTABLE; status++)
        assert_int_equal(status_exit(status), exits[status]);
}

static void refused_exact_stepper_falls_back(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5", &no_exact);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.options.stepper, STEPPER_RKL2);
    assert_order(result.time_error, >, 0);
    assert_order(result.time_error, <=, 0.01);
    command_free(&r);
}

/* The time error that is reported is the one that was put in. */
static void step_is_refined_until_time_error_is_small(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5 --stepper euler", &euler);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    double space = C * 0.25, time = D * result.dt;
    assert_near(result.error[NORM_L1], space + time, 1e-12);
    assert_near(result.time_error, time / (space + time), 1e-9);
    assert_order(result.time_error, <=, 0.01);
    assert_order(result.time_error, >, 0.005); /* and no finer than needed */
    command_free(&r);
}

static void an_unstable_first_step_is_halved(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5", &picky);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_order(result.time_error, <=, 0.01);
    command_free(&r);
}

/* Particles next to a Dirichlet wall: the first step of rkl2 has enough stages to be damped, the next has too
 * few. */
static void an_unstable_second_step_is_halved(void **state) {
    (void)state;
    struct command_run run;
    int status =
        command_run_line(&run, "run disc-mode so_ssph --walls fit --origin 0.0001,0 --angle 0 --dx 0.05 --t-end 300");
    if (status) fail_msg("%s", run.result.failure.text);
    assert_order(run.result.error[NORM_LINF], <, 1e-9);
    command_run_free(&run);
}

/* Against a run of six times as many steps: within 10 % with steady data, no less otherwise; and 1 % of E1 at most.
 * Data of high modes and data that change take another run. */
static void finite_differences_state_their_time_error(void **state) {
    (void)state;
    static const struct {
        const char *line;
        int steady, again;
    } row[] = {{"rod-step ftcs --dx 0.05", 1, 0},
               {"rod-step ftcs_flux --dx 0.05", 1, 0},
               {"rod-cosine ftcs --dx 1/40 --set mode=8", 1, 1},
               {"plate-cooling ftcs --dx 0.05 --t-end 600", 1, 0},
               {"rod-contact ftcs --mean series --dx 0.05", 1, 0},
               {"rod-gauss ftcs --layout node --dx 0.25", 1, 0},
               {"box-manufactured ftcs --dx 0.1", 1, 0},
               {"wall-kirchhoff ftcs --dx 1/20", 0, 0},
               {"plate-driven ftcs --dx 0.1", 0, 1},
               {"front ftcs --dx 1/20", 0, 1}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char line[200];
        struct command r;
        struct result result;
        struct failure why;
        struct field f, fine;
        snprintf(line, sizeof line, "run %s --domain whole", row[k].line);
        if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
        assert_int_equal(result.options.stepper, STEPPER_RKL2);
        struct options o = result.options;
        o.dt = result.dt;
        assert_int_equal(method_solve(r.experiment.method, &r.experiment.problem, &o, &f, &why), STATUS_OK);
        o.dt = result.dt / 6;
        assert_int_equal(method_solve(r.experiment.method, &r.experiment.problem, &o, &fine, &why), STATUS_OK);
        double stated = f.time_error, steps_error = 0, volume = 0;
        for (size_t i = 0; i < f.n; i++) {
            const double w = f.weight ? f.weight[i] : 1;
            steps_error += w * fabs(f.T[i] - fine.T[i]), volume += w;
        }
        steps_error *= 36. / 35 / volume;
        print_message("%s: stated over measured %.3f, share %.2g\n", row[k].line, stated / steps_error,
                      result.time_error);
        assert_order(stated, >, 0.9 * steps_error);
        if (row[k].steady) assert_order(stated, <, 1.1 * steps_error);
        assert_order(result.time_error, <=, 0.01);
        assert_int_equal(result.search_updates > 0, row[k].again);
        field_free(&f);
        field_free(&fine);
        command_free(&r);
    }
}

static void given_step_is_not_refined(void **state) {
    (void)state;
    struct command r = request("run rod-gauss ftcs --dx 0.5 --dt 0.7", &euler);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.steps, 8); /* 5 s in whole steps of at most 0.7 s */
    assert_near(result.dt, 0.625, 0);
    assert_nan(result.time_error);
    command_free(&r);
}

/* Zero data, and data whose temperatures have decayed below the smallest double. */
static void zero_solution_has_no_relative_error(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-contact brookshaw --dx 0.1 --set T1=0 --stepper euler --dt 0.1",
                                        "run plate so_ssph --dx 0.01 --set T1=0 --set T2=0 --set T3=0 --set T4=0",
                                        "run rod-step so_ssph --dx 0.1 --set t_end=1e7"};
    for (int i = 0; i < 3; i++) {
        struct command r;
        struct failure why;
        struct result result;
        assert_int_equal(command_read(lines[i], &r, &why), STATUS_OK);
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_INPUT);
        assert_has(result.failure.text, "the exact solution, to which E1 is relative, is 0 K at all points");
        command_free(&r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_stepper_is_the_default_on_a_lattice),
        cmocka_unit_test(zero_solution_has_no_relative_error),
        cmocka_unit_test(refused_exact_stepper_falls_back),
        cmocka_unit_test(wrong_input_is_not_tried_again),
        cmocka_unit_test(every_status_has_an_exit_status),
        cmocka_unit_test(step_is_refined_until_time_error_is_small),
        cmocka_unit_test(an_unstable_first_step_is_halved),
        cmocka_unit_test(an_unstable_second_step_is_halved),
        cmocka_unit_test(finite_differences_state_their_time_error),
        cmocka_unit_test(given_step_is_not_refined),
    };
    return cmocka_run_group_tests_name("time_step", tests, NULL, NULL);
}
