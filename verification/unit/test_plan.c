/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plan is checked against what the run then reports, to the last particle, step and byte, and against the heap to 5
 * %. */
#include "verification/choose/plan.h"

#include "verification/command/arguments.h"
#include "verification/run/run.h"

#include "verification/unit/heap.h"
#include "verification/unit/near.h"

#include <math.h>
#include <string.h>

static void plan_of(const char *line, struct request *r, struct plan *plan) {
    struct failure why;
    if (arguments_parse_line(line, r, &why)) fail_msg("%s: %s", line, why.text);
    if (plan_make(&r->experiment, PLAN_RUN, plan, &why)) fail_msg("%s: %s", line, why.text);
}

static void as_planned(const char *line) {
    struct request r;
    struct plan plan;
    struct result result;
    plan_of(line, &r, &plan);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    const struct field *part = &plan.part.run;
    size_t bytes = plan.part.bytes[OUTLINE_STEPS];
    if (plan.particles != result.particles || part->steps != result.steps || bytes != result.cost.bytes ||
        part->cost.updates != result.cost.updates || part->cost.interactions != result.cost.interactions ||
        plan.options.stepper != result.options.stepper)
        fail_msg("%s: planned %zu particles, %lld steps, %lld updates, %zu bytes; the run has %zu, %lld, %lld, %zu",
                 line, plan.particles, part->steps, part->cost.updates, bytes, result.particles, result.steps,
                 result.cost.updates, result.cost.bytes);
    assert_near(part->dt, result.dt, 1e-15 * result.dt);
    assert_near(part->cost.work, result.cost.work, 0);
    if (result.options.stepper != STEPPER_RKL2) /* whose first step may be two of other stages */
        assert_int_equal(part->cost.updates, (long long)part->n * (part->steps ? part->steps * part->stages : 1));
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
    as_planned("run square-step so_ssph --dx 0.1 --layout jitter --jitter 0.2 --stepper chebyshev --dt 0.5");
    as_planned("run square-step so_ssph --dx 0.1 --layout jitter --jitter 0.2 --stepper chebyshev");
    as_planned("run rod-contact brookshaw --dx 0.02 --stepper euler --fourier 0.2");
    as_planned("run rod-contact ftcs --dx 0.02 --fourier 0.2");
    as_planned("run rect-manufactured so_ssph --dx 0.05 --stepper exact");
    as_planned("run rod-gauss ftcs --dx 0.25 --fourier 0.4");
    as_planned("run rod-gauss ftcs --dx 0.25 --stepper matched");
    as_planned("run rod-cosine ftcs_flux --dx 0.05 --layout node --fourier 0.4");
    as_planned("run rect-manufactured ftcs --dx 0.05 --fourier 0.1");
    as_planned("run rect-manufactured ftcs --dx 0.05 --fourier 0.1 --set rise=2"); /* its source changes */
    as_planned("run rect-manufactured ftcs_flux --dx 0.05 --fourier 0.1");         /* q_y of three rows */
    as_planned("run rod-cosine fo_ssph --dx 0.05 --walls fixed"); /* there is no wall that --walls is about */
    as_planned("run plate so_ssph --dx 0.01 --walls fixed");
    as_planned("run plate brookshaw --dx 0.01 --time-error 1e-4");
    as_planned("run rod-cosine ftcs --dx 0.05 --layout node");
}

/* The most that is on the heap during the run.  What is left out is O(1), or O(n) of an n x n lattice, and the
 * allocator's 24 bytes a block: below 5 % from some 1e4 points of the plane.  Rows are assembled in lists that grow
 * by doubling, so that what is taken for twice the rows is between one and three times: a factor of 1.5. */
static void as_allocated(const char *line, double within) {
    struct request r;
    struct plan plan;
    struct result result;
    plan_of(line, &r, &plan);
    size_t begin = 0, planned = plan.part.bytes[plan_peak(&plan)];
    for (int k = 0; k < 2; k++) { /* the second time FFTW and the C library have what they keep for good */
        begin = heap_most = heap_now;
        if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    }
    double held = (double)(heap_most - begin);
    arguments_free(&r);
    assert_order(heap_now, <=, begin);
    if (!(held < within * (double)planned && held > (double)planned / within))
        fail_msg("%s: %zu bytes planned, %.0f held: %.3f", line, planned, held, held / (double)planned);
}

static void what_is_allocated_was_planned(void **state) {
    (void)state;
    if (!HEAP_COUNTED) skip();
    heap_begin();
    as_allocated("run square-step so_ssph --dx 0.0125", 1.05);
    as_allocated("run square-step so_ssph --dx 0.0125 --domain whole --stepper rkl2 --dt 0.5", 1.05);
    as_allocated("run square-step so_ssph --dx 0.02 --stepper matched --h iso --sampling spline", 1.05);
    as_allocated("run rect-manufactured so_ssph --dx 0.005 --stepper exact", 1.05);
    as_allocated("run plate so_ssph --dx 0.0005 --stepper rkl2 --dt 2", 1.05);
    as_allocated("run plate brookshaw --dx 0.001 --walls fixed", 1.05);
    as_allocated("run plate ftcs_flux --dx 0.0005 --layout node --fourier 0.2 --set t_end=0.01", 1.05);
    as_allocated("run rect-manufactured ftcs --dx 0.005 --fourier 0.2 --set t_end=0.01", 1.05);
    /* FFTW's own for a long line: 16 bytes a number of factors, 8 of a buffer, beside the 40 that are planned */
    as_allocated("run rod-cosine so_ssph --dx 1/6400 --layout node", 1.6);
    as_allocated("run rod-step so_ssph --dx 4/6400", 1.6);
    as_allocated("run square-step so_ssph --dx 0.05 --layout jitter --jitter 0.2 --stepper rkl2 --dt 0.5", 1.5);
    as_allocated("run square-step fo_ssph --dx 0.04 --layout jitter --jitter 0 --stepper euler --dt 0.1", 1.5);
    as_allocated("run rod-contact brookshaw --dx 0.001 --stepper rkl2 --dt 0.1", 1.5);
}

/* Rows of many particles are counted on a coarser lattice: jitter of another draw, and walls of twice the share. */
static void many_rows_are_estimated(void **state) {
    (void)state;
    struct request r;
    struct plan plan;
    struct result result;
    plan_of(
        "run square-step brookshaw --dx 4/480 --layout jitter --jitter 0.2 --stepper rkl2 --dt 0.1 --set t_end=0.1",
        &r, &plan);
    assert_near(plan.part.stand_in, 4.0 / 160, 1e-9);
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(plan.particles, result.particles);
    assert_int_equal(plan.part.run.steps, result.steps);
    assert_order(abs(plan.part.run.stages - result.stages), <=, 2);
    assert_near((double)plan.part.bytes[OUTLINE_STEPS] / (double)result.cost.bytes, 1, 0.02);
    assert_near(plan.part.neighbours / ((double)result.cost.interactions / (double)result.cost.updates), 1, 0.02);
    arguments_free(&r);
}

/* Where a number of cells has no factor (457) or the sides have none in common (670 = 10 x 67 and 469 = 7 x 67), the
 * plan is that of the next lattice that has: 1/200 of a cell's side is left, and jitter of another draw. */
static void a_lattice_that_nothing_divides_is_estimated_too(void **state) {
    (void)state;
    static const char *const pair[][2] = {
        {"square-step so_ssph --dx 4/457", "square-step so_ssph --dx 4/456"},
        {"rect-manufactured so_ssph --dx 0.1/67", "rect-manufactured so_ssph --dx 0.1/66"}};
    for (int k = 0; k < 2; k++) {
        struct request r[2];
        struct plan plan[2];
        double bytes[2];
        for (int i = 0; i < 2; i++) {
            char line[160];
            snprintf(line, sizeof line, "plan %s --layout jitter --jitter 0.2 --seed 1 --stepper rkl2 --dt 0.01",
                     pair[k][i]);
            plan_of(line, &r[i], &plan[i]);
            bytes[i] = (double)plan[i].part.bytes[OUTLINE_STEPS] / (double)plan[i].particles;
            assert_order(plan[i].part.stand_in, >, 1.9 * plan[i].options.dx);
        }
        assert_near(plan[0].part.neighbours / plan[1].part.neighbours, 1, 0.01);
        assert_near(bytes[0] / bytes[1], 1, 0.01);
        assert_order(abs(plan[0].part.run.stages - plan[1].part.run.stages), <=, 2);
        for (int i = 0; i < 2; i++) arguments_free(&r[i]);
    }
}

/* Past OUTLINE_ARRAYS an array has no name of its own, and its bytes count. */
static void arrays_without_a_name_count(void **state) {
    (void)state;
    struct outline out = {0};
    for (int i = 0; i < OUTLINE_ARRAYS + 2; i++) outline_hold(&out, "one", 7, OUTLINE_STEPS, OUTLINE_STEPS);
    outline_hold(&out, "none", 0, OUTLINE_STEPS, OUTLINE_STEPS);
    assert_int_equal(out.count, OUTLINE_ARRAYS);
    assert_int_equal(out.bytes[OUTLINE_STEPS], 7 * (OUTLINE_ARRAYS + 2));
    assert_int_equal(out.bytes[OUTLINE_SET_UP], 0);
}

static void a_grid_of_two_materials_says_so(void **state) {
    (void)state;
    const char *const line[] = {"run rod-gauss ftcs --dx 0.25 --dt 0.1", "run rod-contact ftcs --dx 0.1 --dt 0.1",
                                "run plane-contact ftcs --dx 0.1 --dt 0.1"};
    for (size_t k = 0; k < sizeof line / sizeof *line; k++) {
        struct request r;
        struct plan plan;
        plan_of(line[k], &r, &plan);
        assert_has(plan.part.weights, k ? "two materials" : "one material");
        arguments_free(&r);
    }
}

static void a_method_that_does_not_tell_has_no_plan(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    struct plan plan;
    struct method silent = *method_find("ftcs");
    silent.name = "silent", silent.outline = NULL;
    assert_int_equal(arguments_parse_line("plan rod-step ftcs --dx 0.1", &r, &why), STATUS_OK);
    r.experiment.method = &silent;
    assert_int_equal(plan_make(&r.experiment, PLAN_RUN, &plan, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "silent does not tell what it stores and does");
    arguments_free(&r);
}

/* A rung's time error is Richardson's, good to a few percent where the stages stay the same: N goes with its root.
 * Where the particles are jittered, the error of space scatters, and so does N. */
static void as_predicted(const char *line, int runs, double within) {
    struct request r;
    struct plan plan;
    struct result result;
    plan_of(line, &r, &plan);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    double off = log((double)plan.part.run.steps / (double)result.steps);
    if (!plan.refined || plan.forecast.runs != runs || !(fabs(off) <= log(within)))
        fail_msg("%s: %lld steps predicted from %d runs, the search took %lld", line, plan.part.run.steps,
                 plan.forecast.runs, result.steps);
    arguments_free(&r);
}

static void open_steps_are_predicted(void **state) {
    (void)state;
    as_predicted("run rod-contact brookshaw --dx 0.02", 1, 1);
    as_predicted("run rect-manufactured ftcs --dx 1/10 --set rho_c=1.493 --set A=0.3458", 1, 1);
    as_predicted("run plate so_ssph --dx 0.005 --time-error 1e-4", 1, 1);
    as_predicted("run plate brookshaw --dx 0.001 --walls fixed", 2, 1.1);
    as_predicted("run plate so_ssph --dx 0.001 --time-error 1e-4", 2, 1.2);
    as_predicted("run rod-contact brookshaw --dx 0.0005", 2, 1.1);
    as_predicted("run square-step ftcs --dx 0.05", 2, 1.2);
    as_predicted("run square-step so_ssph --dx 0.04 --stepper rk2", 2, 1.2);
    as_predicted("run square-step so_ssph --dx 0.05 --layout jitter --jitter 0.2", 2, 2.5);
}

static void refusals_are_those_of_the_run(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    struct plan plan;
    static const char *const lines[] = {
        "plan rod-step so_ssph --dx 0.3",
        "plan rod-step so_ssph --dx 0.1 --stepper matched --layout jitter",
        "plan rod-contact brookshaw --dx 0.1 --stepper matched",
        "plan rod-contact brookshaw --dx 0.1 --stepper exact",
        "plan square-step so_ssph --dx 2e-6 --stepper euler --fourier 0.1",
        "plan rod-step ftcs --dx 1e-7 --dt 1e-11",
        "plan rod-step so_ssph --dx 0.1 --h 1e9",
        "plan rod-step so_ssph --dx 0.001 --set kappa=1e9 --stepper rkl2 --dt 1",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        struct result result;
        if (arguments_parse_line(lines[i], &r, &why)) fail_msg("%s: %s", lines[i], why.text);
        int status = plan_make(&r.experiment, PLAN_RUN, &plan, &why);
        if (!status_refused(status) || run_experiment(&r.experiment, &result, NULL) != status)
            fail_msg("%s: %d", lines[i], status);
        assert_string_equal(why.text, result.failure.text);
        arguments_free(&r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_do_what_was_planned),
        cmocka_unit_test(what_is_allocated_was_planned),
        cmocka_unit_test(many_rows_are_estimated),
        cmocka_unit_test(a_lattice_that_nothing_divides_is_estimated_too),
        cmocka_unit_test(arrays_without_a_name_count),
        cmocka_unit_test(a_grid_of_two_materials_says_so),
        cmocka_unit_test(a_method_that_does_not_tell_has_no_plan),
        cmocka_unit_test(open_steps_are_predicted),
        cmocka_unit_test(refusals_are_those_of_the_run),
    };
    return cmocka_run_group_tests_name("plan", tests, NULL, NULL);
}
