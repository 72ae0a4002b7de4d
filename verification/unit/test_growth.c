/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growing modes: their rate against all eigenvalues, none where none grows, the run that has one; a start within its
 * data. */
#include "solver/particles/particles.h"
#include "solver/time/growth.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"
#include "verification/stability/model_problem.h"
#include "verification/stability/spectrum.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

extern const struct method method_so_ssph, method_fatehi_manzari, method_fo_ssph;

/* The rate of 14 x 14 particles between cold walls, by powers and by eigenvalues. */
static void compare(const struct method *method, double jitter, unsigned long seed, int *growing) {
    struct model_problem b = {.method = method,
                              .dim = 2,
                              .n = 14,
                              .options = {.layout = LAYOUT_JITTER, .jitter = jitter, .seed = seed},
                              .step = {STEPPER_EULER, 0}};
    struct failure why = {0};
    struct heat_operator a;
    struct spectrum s;
    assert_int_equal(model_problem_resolve(&b, 14, &why), STATUS_OK);
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_operator(&b, &p, &a, &why) || spectrum_create(&s, &a, &b.step, &why)) fail_msg("%s", why.text);
    double time = 100, rate = growth_rate(&a, operator_bound(&a), time);
    if (s.growth * time > 0.2) { /* clear of the tenth below which none is stated */
        ++*growing;
        assert_near(rate, s.growth, 0.1 * s.growth);
    }
    if (s.growth * time < 0.05) assert_near(rate, 0, 0);
    spectrum_free(&s);
    operator_free(&a);
}

static void growth_rates_equal_eigenvalues(void **state) {
    (void)state;
    int growing = 0;
    for (unsigned long seed = 1; seed <= 4; seed++) {
        compare(&method_fatehi_manzari, 0.45, seed, &growing);
        compare(&method_so_ssph, 0.5, seed, &growing);
        compare(&method_so_ssph, 0.1, seed, &growing);
        compare(&method_fo_ssph, 0.3, seed, &growing);
    }
    assert_order(growing, >=, 3);
}

static int run(const char *line, struct result *result) {
    struct command r;
    struct failure why = {0};
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    r.experiment.growth = 1;
    int status = run_experiment(&r.experiment, result, NULL);
    command_free(&r);
    return status;
}

static void growing_mode_is_reported(void **state) {
    (void)state;
    struct result r;
    assert_int_equal(run("run rect-manufactured so_ssph --layout jitter --jitter 0.1 --seed 1 --dx 0.05", &r),
                     STATUS_OK);
    assert_near(r.growth, 0, 0);
    assert_false(result_grows(&r));
    assert_int_equal(
        run("run rect-manufactured fatehi_manzari --layout jitter --jitter 0.4 --seed 0 --dx 0.02 --t-end 0.2", &r),
        STATUS_OK);
    assert_true(result_grows(&r));
    assert_int_equal(run("run rod-gauss so_ssph --dx 0.5", &r), STATUS_OK);
    assert_nan(r.growth);
}

/* A Dirichlet wall with fitted dummies: |Im lambda| is about 0.12 of the bound, and RKL2 damps it for up to about
 * nine stages. */
static void undamped_many_stages_are_refused(void **state) {
    (void)state;
    const char *fit = "run disc-mode so_ssph --walls fit --dx 0.05 --seed 1 --layout jitter --jitter 0.2 --t-end 60 "
                      "--stepper";
    const struct {
        const char *steps;
        int status;
    } run_of[] = {{"rkl2 --dt 1", STATUS_OK},
                  {"rkl2 --dt 2", STATUS_UNSTABLE},
                  {"rkl2 --dt 5", STATUS_UNSTABLE},
                  {"chebyshev --dt 5", STATUS_OK},
                  {"rkl2", STATUS_OK}};
    for (size_t k = 0; k < sizeof run_of / sizeof *run_of; k++) {
        char line[256];
        struct result r;
        snprintf(line, sizeof line, "%s %s", fit, run_of[k].steps);
        assert_int_equal(run(line, &r), run_of[k].status);
        if (run_of[k].status)
            assert_has(r.failure.text, "chebyshev");
        else
            assert_order(r.error[NORM_LINF], <, 1e-6);
    }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(growth_rates_equal_eigenvalues),
        cmocka_unit_test(growing_mode_is_reported),
        cmocka_unit_test(undamped_many_stages_are_refused),
    };
    return cmocka_run_group_tests_name("growth", tests, NULL, NULL);
}
