/* Ladders and the choice of a time step, on methods whose errors are made to measure: the exact solution plus
 * C dx^P + D dt^Q, so that every answer is known. */
#include "verification/ladder/ladder.h"

#include "references/scene.h"
#include "solver/space/operator.h"
#include "verification/command/arguments.h"
#include "verification/run/run.h"
#include "verification/run/time_step.h"
#include "verification/text/json.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

static const double C = 0.31, D = 0.77;
static double steep; /* s^-2: D (1 + steep dt^2) for D */

static int whole(const struct problem *p, double dx) {
    return (int)nearbyint((p->hi[0] - p->lo[0]) / dx);
}

static int answer(const struct problem *p, const struct options *o, int order, struct field *f) {
    int n = whole(p, o->dx);
    double steps =
        o->stepper == STEPPER_EXACT
            ? 0
            : ceil(p->t_end / (o->dt > 0 ? o->dt : o->fourier * o->dx * o->dx / p->material[0].k[0]) - 1e-9);
    double dt = steps > 0 ? p->t_end / steps : 0;
    field_alloc(f, 1, (size_t)n);
    f->time = p->t_end, f->dt = dt, f->steps = (long long)steps, f->stages = 1;
    for (int i = 0; i < n; i++) {
        f->x[i] = p->lo[0] + (i + 0.5) * (p->hi[0] - p->lo[0]) / n;
        double x[2] = {f->x[i], 0};
        f->T[i] = scene_find("rod-gauss")->exact(p, x, p->t_end).temperature *
                  (1 + C * pow(o->dx, 2) + D * pow(dt, order) * (1 + steep * dt * dt));
    }
    return STATUS_OK;
}

static int solve_euler(const struct problem *p, const struct options *o, struct field *f, struct failure *why) {
    if (o->stepper == STEPPER_EXACT) return refuse(why, STATUS_NOT_APPLICABLE, "--stepper exact: not here");
    return answer(p, o, o->stepper == STEPPER_RKL2 ? 2 : 1, f);
}

static int solve_any(const struct problem *p, const struct options *o, struct field *f, struct failure *why) {
    (void)why;
    return answer(p, o, o->stepper == STEPPER_RKL2 ? 2 : 1, f);
}

static int solve_picky(const struct problem *p, const struct options *o, struct field *f, struct failure *why) {
    double F = o->dt * p->material[0].k[0] / (o->dx * o->dx);
    if (F > 0.01) return refuse(why, STATUS_UNSTABLE, "T grew at step 7");
    return answer(p, o, 1, f);
}

static int solve_broken(const struct problem *p, const struct options *o, struct field *f, struct failure *why) {
    if (o->dx < 0.3) return refuse(why, STATUS_UNSTABLE, "T grew at step 7");
    return answer(p, o, 1, f);
}

static int solve_wrong_input(const struct problem *p, const struct options *o, struct field *f, struct failure *why) {
    if (o->stepper == STEPPER_EXACT) return refuse(why, STATUS_INPUT, "--dx: does not divide the domain");
    return solve_euler(p, o, f, why);
}

static const struct scheme scheme;
static const struct method wrong_input = {"wrong_input", "", "stepper", &scheme, solve_wrong_input, NULL};
static const struct method euler = {"euler_only", "", "stepper", NULL, solve_euler, NULL};
static const struct method no_exact = {"no_exact", "", "stepper", &scheme, solve_euler, NULL};
static const struct method with_exact = {"with_exact", "", "stepper", &scheme, solve_any, NULL};
static const struct method picky = {"picky", "", "stepper", NULL, solve_picky, NULL};
static const struct method broken = {"broken", "", "stepper", NULL, solve_broken, NULL};

static struct request request(const char *line, const struct method *m) {
    struct request r;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    r.experiment.method = m;
    r.experiment.options.domain = DOMAIN_WHOLE; /* these methods know of no lattice, nor of its symmetry */
    return r;
}

static void the_exact_stepper_where_there_is_one(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5", &with_exact);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.options.stepper, STEPPER_EXACT);
    assert_near(result.time_error, 0, 0);
    assert_near(result.error.l1, C * 0.25, 1e-12);
    arguments_free(&r);
}

/* The longest step whose error is what is asked for: D dt^Q, to the 5 % that the search goes by and a whole step. */
static void a_time_error_is_met_and_not_more(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-gauss ftcs --dx 0.5 --stepper euler --time-error 1e-3",
                                        "run rod-gauss ftcs --dx 0.5 --stepper rkl2 --time-error 1e-3",
                                        "run rod-gauss ftcs --dx 0.5 --stepper rkl2 --time-error 0.2"};
    for (int i = 0; i < 3; i++) {
        struct request r = request(lines[i], &with_exact);
        struct result result;
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
        double error = D * pow(result.dt, i ? 2 : 1),
               coarser = r.experiment.problem.t_end / ((double)result.steps / 1.05 - 1);
        assert_true(error <= r.experiment.time_error * (1 + 1e-6));
        assert_true(result.steps <= 2 || D * pow(coarser, i ? 2 : 1) > r.experiment.time_error);
        arguments_free(&r);
    }
}

/* Where the time error grows faster than its order, the first step tried is too long, by as much as half of the error
 * asked for: what is taken has that error all the same, by the search's own account. */
static void a_step_that_is_a_little_too_long_is_not_taken(void **state) {
    (void)state;
    static const char *const asked[] = {"1e-3", "2e-3", "3e-3", "5e-3", "8e-3"};
    for (int i = 0; i < 5; i++) {
        char line[100];
        snprintf(line, sizeof line, "run rod-gauss ftcs --dx 0.5 --stepper rkl2 --time-error %s", asked[i]);
        struct request r = request(line, &with_exact);
        struct result result;
        steep = 200;
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
        steep = 0;
        assert_true(result.time_error * result.error.l1 <= r.experiment.time_error * (1 + 1e-12));
        arguments_free(&r);
    }
}

static void a_time_error_out_of_reach_is_said(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5 --stepper euler --time-error 1e-12", &with_exact);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_GATE);
    assert_non_null(strstr(result.failure.text, "--time-error 1e-12"));
    arguments_free(&r);
}

/* Another stepper is for what the exact one has no answer to, not for input that is wrong. */
static void wrong_input_is_not_tried_again(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5", &wrong_input);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_INPUT);
    assert_int_equal(result.options.stepper, STEPPER_EXACT);
    arguments_free(&r);
}

static void every_status_has_an_exit_status(void **state) {
    (void)state;
    static const int exits[] = {0, 1, 2, 3, 4, 2, 3};
    for (int status = STATUS_OK; status <= STATUS_UNSTABLE; status++)
        assert_int_equal(status_exit(status), exits[status]);
}

static void a_refused_exact_falls_back(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5", &no_exact);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.options.stepper, STEPPER_RKL2);
    assert_true(result.time_error > 0 && result.time_error <= 0.01);
    arguments_free(&r);
}

/* 5 s of 10 m^2/s at dx = 0.5 m are 1000 steps of F = 0.2, whose largest rate is 4 F = 0.8 a step; the fewest stages
 * s of RKL2 have (s^2 + s - 2)/2 >= dt lambda: ten of them. */
static void a_search_begins_with_some_ten_stages(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5 --t-end 5 --set kappa=10 --stepper euler", &with_exact);
    assert_near(time_step_first(&r.experiment), 1000, 0);
    r.experiment.options.stepper = STEPPER_RKL2;
    double part = 0.8 * 1000 / time_step_first(&r.experiment);
    int stages = 1;
    while (stages * (stages + 1) - 2 < 2 * part) stages++;
    assert_int_equal(stages, 10);
    arguments_free(&r);
}

/* The time error that is reported is the one that was put in. */
static void the_step_is_refined_until_it_does_not_matter(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5", &euler);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    double space = C * 0.25, time = D * result.dt;
    assert_near(result.error.l1, space + time, 1e-12);
    assert_near(result.time_error, time / (space + time), 1e-9);
    assert_true(result.time_error <= 0.01 && result.time_error > 0.005); /* and no finer than needed */
    arguments_free(&r);
}

static void an_unstable_first_step_is_halved(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5", &picky);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_true(result.time_error <= 0.01);
    arguments_free(&r);
}

static void a_given_step_is_taken_as_it_is(void **state) {
    (void)state;
    struct request r = request("run rod-gauss ftcs --dx 0.5 --dt 0.7", &euler);
    struct result result;
    assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
    assert_int_equal(result.steps, 8); /* 5 s in whole steps of at most 0.7 s */
    assert_near(result.dt, 0.625, 0);
    assert_true(isnan(result.time_error));
    arguments_free(&r);
}

/* Data of zero, and data whose last trace has decayed past the least double. */
static void no_error_is_relative_to_zero(void **state) {
    (void)state;
    static const char *const lines[] = {
        "run rod-contact brookshaw --dx 0.1 --set T1=0 --stepper euler --dt 0.1",
        "run plate so_ssph --dx 0.01 --set T1=0 --set T2=0 --set T3=0 --set T4=0 --time-error 1e-3",
        "run rod-step so_ssph --dx 0.1 --set t_end=1e7"};
    for (int i = 0; i < 3; i++) {
        struct request r;
        struct failure why;
        struct result result;
        assert_int_equal(arguments_parse_line(lines[i], &r, &why), STATUS_OK);
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_INPUT);
        assert_non_null(strstr(result.failure.text, "the exact solution is 0 K at all points"));
        arguments_free(&r);
    }
}

static void climb(const char *line, const struct method *m, int status, struct ladder *l, struct failure *why) {
    struct request r = request(line, m);
    int got = ladder_run(&r.experiment, &r.rungs, l, why);
    if (got != status) fail_msg("%s: status %d, %s", line, got, why->text);
    arguments_free(&r);
}

static void a_ladder_in_space(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->n, 4);
    assert_near(l->x[0], 1, 0); /* coarsest first, in whatever order they were asked for */
    assert_near(l->x[3], 0.125, 0);
    assert_near(l->slope.value, 2, 1e-9);
    assert_int_equal(l->verdict, VERDICT_PASS);
    ladder_judge(l, 0.9, 1.1);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    ladder_fit(l, LADDER_LINF);
    assert_near(l->slope.value, 2, 0.02);
    free(l);
}

/* As many numbers as there are, in the array of that name. */
static int numbers_in(const char *text, const char *name) {
    const char *at = strstr(text, name);
    int n = 1;
    assert_non_null(at);
    for (at = strchr(at, '['); *at && *at != ']'; at++) n += *at == ',';
    return n;
}

static void json_has_every_number(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5,0.0625 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_object(&j, NULL);
    ladder_json(l, &j);
    json_end(&j);
    fclose(out);
    assert_int_equal(numbers_in(text, "slope_ci95"), 2);
    assert_int_equal(numbers_in(text, "local_slopes"), 4);
    free(text);
    free(l);
}

static void a_ladder_in_time(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04,0.02,0.08 --stepper rkl2", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->in_time, 1);
    assert_near(l->slope.value, 2, 1e-6);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04,0.02,0.08 --stepper euler", &with_exact, STATUS_OK, l, &why);
    assert_near(l->slope.value, 1, 1e-6);
    /* from differences of successive runs, at ratios that are not alike; E1 is over a sum of T with the error in it
     */
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.08,0.05,0.02,0.01,0.004 --stepper rkl2", &euler, STATUS_OK, l, &why);
    assert_int_equal(l->n, 4);
    assert_near(l->slope.value, 2, 0.01);
    for (int i = 0; i < 4; i++) assert_near(l->error[i] / l->error[0], pow(l->x[i] / l->x[0], 2), 0.01);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04", &euler, STATUS_INPUT, l, &why);
    assert_non_null(strstr(why.text, "three time steps at least"));
    free(l);
}

static void short_ladders_are_inconclusive(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1", &with_exact, STATUS_INPUT, l, &why);
    assert_non_null(strstr(why.text, "at least two rungs, and a gate 4"));
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.5", &with_exact, STATUS_INPUT, l, &why);
    assert_non_null(strstr(why.text, "--dx: 0.5 is given twice"));
    climb("ladder rod-gauss ftcs --dx 1 --dt 0.5,0.5", &with_exact, STATUS_INPUT, l, &why);
    assert_non_null(strstr(why.text, "--dt: 0.5 is given twice"));
    free(l);
}

static void two_rungs_have_no_interval_to_print(void **state) {
    (void)state;
    struct failure why;
    char text[160];
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 1,0.5 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    ladder_slope_text(l, text, sizeof text);
    assert_string_equal(text, "slope of E1: 2.0000, 95 % interval - (of two rungs there is none), over 2 of 2 rungs");
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25 --norm interior", &with_exact, STATUS_OK, l, &why);
    ladder_slope_text(l, text, sizeof text);
    assert_non_null(strstr(text, "slope of E1 of the interior: 2.0"));
    assert_null(strstr(text, "nan"));
    free(l);
}

/* E1 = C dx^2 at dx = 0.125. */
static void a_ceiling_bounds_the_finest_rung(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --ceiling 0.0049", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_PASS);
    assert_near(ladder_finest_error(l), C / 64, 1e-9);
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --ceiling 0.0048", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    assert_non_null(strstr(l->reason, "above its ceiling 0.0048"));
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --expect 1.9,2.1 --ceiling 0.0048", &with_exact, STATUS_OK, l,
          &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    /* another norm, another size: that of the largest error, K */
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --norm linf --ceiling 0.0049", &with_exact, STATUS_OK, l,
          &why);
    assert_near(ladder_finest_error(l), l->rung[3].error.linf, 0);
    free(l);
}

static void a_failed_rung_fails_the_ladder(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 3,1,0.75,0.5,0.25 --expect 1.9,2.1", &broken, STATUS_UNSTABLE, l, &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    assert_non_null(strstr(l->reason, "T grew at step 7"));
    ladder_judge(l, 1.9, 2.1);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    free(l);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exact_stepper_where_there_is_one),
        cmocka_unit_test(a_time_error_is_met_and_not_more),
        cmocka_unit_test(a_step_that_is_a_little_too_long_is_not_taken),
        cmocka_unit_test(a_time_error_out_of_reach_is_said),
        cmocka_unit_test(no_error_is_relative_to_zero),
        cmocka_unit_test(a_refused_exact_falls_back),
        cmocka_unit_test(wrong_input_is_not_tried_again),
        cmocka_unit_test(every_status_has_an_exit_status),
        cmocka_unit_test(a_search_begins_with_some_ten_stages),
        cmocka_unit_test(the_step_is_refined_until_it_does_not_matter),
        cmocka_unit_test(an_unstable_first_step_is_halved),
        cmocka_unit_test(a_given_step_is_taken_as_it_is),
        cmocka_unit_test(a_ladder_in_space),
        cmocka_unit_test(json_has_every_number),
        cmocka_unit_test(a_ladder_in_time),
        cmocka_unit_test(short_ladders_are_inconclusive),
        cmocka_unit_test(two_rungs_have_no_interval_to_print),
        cmocka_unit_test(a_ceiling_bounds_the_finest_rung),
        cmocka_unit_test(a_failed_rung_fails_the_ladder),
    };
    return cmocka_run_group_tests_name("ladder", tests, NULL, NULL);
}
