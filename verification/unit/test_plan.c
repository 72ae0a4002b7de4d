/* A plan is checked against what the run then reports: particles, steps, work and memory, to the last one. */
#include "verification/plan.h"

#include "verification/arguments.h"
#include "verification/run.h"

#include "verification/unit/near.h"

static void as_planned(const char *line) {
    struct request r;
    struct failure why;
    struct plan plan;
    struct result result;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (plan_make(&r, &r.options, &plan, &why)) fail_msg("%s: %s", line, why.text);
    if (run_request(&r, &r.options, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    size_t sum = 0;
    for (int i = 0; i < plan.count; i++) sum += plan.array[i].bytes;
    if (plan.particles != result.particles || plan.steps != result.steps || plan.bytes != result.bytes ||
        plan.updates != result.updates || plan.interactions != result.interactions || plan.bytes != sum ||
        plan.options.stepper != result.options.stepper)
        fail_msg("%s: planned %zu particles, %lld steps, %lld updates, %zu bytes; the run has %zu, %lld, %lld, %zu",
                 line, plan.particles, plan.steps, plan.updates, plan.bytes, result.particles, result.steps,
                 result.updates, result.bytes);
    assert_near(plan.dt, result.dt, 1e-15 * result.dt);
    arguments_free(&r);
}

static void runs_do_what_was_planned(void **state) {
    (void)state;
    as_planned("run rod-step so_ssph --dx 0.05");
    as_planned("run rod-step fo_ssph --dx 0.05 --stepper euler --fourier 0.2");
    as_planned("run rod-cosine so_ssph --dx 0.05 --stepper rk2 --dt 0.01");
    as_planned("run plate so_ssph --dx 0.005");
    as_planned("run plate so_ssph --dx 0.005 --stepper rkl2 --dt 0.3");
    as_planned("run plate brookshaw --dx 0.005 --walls fixed --stepper euler --fourier 0.1");
    as_planned("run square-step so_ssph --dx 0.1 --h iso --stepper matched --sampling spline");
    as_planned("run square-step so_ssph --dx 0.1 --stepper matched --h iso --set kappa_y=0.0025");
    as_planned("run square-step so_ssph --dx 0.1 --layout jitter --jitter 0.2 --stepper rkl2 --dt 0.5");
    as_planned("run rod-contact brookshaw --dx 0.02 --stepper euler --fourier 0.2");
    as_planned("run rect-manufactured so_ssph --dx 0.05 --stepper exact");
    as_planned("run rod-gauss ftcs --dx 0.25 --fourier 0.4");
    as_planned("run rod-gauss ftcs --dx 0.25 --stepper matched");
    as_planned("run rod-cosine ftcs_flux --dx 0.05 --layout node --fourier 0.4");
    as_planned("run rect-manufactured ftcs --dx 0.05 --fourier 0.1");
}

static void refusals_are_those_of_the_run(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    struct plan plan;
    assert_int_equal(arguments_parse_line("plan rod-step so_ssph --dx 0.3", &r, &why), STATUS_OK);
    assert_int_equal(plan_make(&r, &r.options, &plan, &why), STATUS_INPUT);
    arguments_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_do_what_was_planned),
        cmocka_unit_test(refusals_are_those_of_the_run),
    };
    return cmocka_run_group_tests_name("plan", tests, NULL, NULL);
}
