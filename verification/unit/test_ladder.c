/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ladders of methods with prescribed errors. */
#include "verification/judge/ladder.h"

#include "verification/text/json.h"

#include "verification/unit/made_methods.h"
#include "verification/unit/near.h"

static void climb(const char *line, const struct method *m, int status, struct ladder *l, struct failure *why) {
    struct command r = request(line, m);
    int got = ladder_run(&r.experiment, &r.rungs, l, why);
    if (got != status) fail_msg("%s: status %d, %s", line, got, why->text);
    command_free(&r);
    ladder_free(l); /* no test looks at fields */
}

static void spatial_ladder_reports_its_slope(void **state) {
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
    ladder_fit(l, NORM_LINF);
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
    ladder_json(l, &j);
    json_end(&j);
    fclose(out);
    assert_int_equal(numbers_in(text, "slope_ci95"), 2);
    assert_int_equal(numbers_in(text, "local_slopes"), 4);
    free(text);
    free(l);
}

/* A passing or unjudged ladder has no fault; a ladder in time has no cells for a diagnosis. */
static void only_failures_in_space_are_diagnosed(void **state) {
    (void)state;
    static const struct {
        const char *line;
        int open;
    } ladders[] = {
        {"ladder rod-gauss ftcs --dx 1,0.5,0.25,0.125 --expect 1.9,2.1", 0},
        {"ladder rod-gauss ftcs --dx 1,0.5,0.25,0.125", 0},
        {"ladder rod-gauss ftcs --dx 1,0.5,0.25,0.125 --expect 2.9,3.1", 1},
        {"ladder rod-gauss ftcs --dx 0.25 --dt 0.5,0.25,0.125,0.0625 --expect 2.9,3.1", 0},
    };
    for (size_t k = 0; k < sizeof ladders / sizeof *ladders; k++) {
        struct failure why;
        struct ladder *l = xcalloc(1, sizeof *l);
        climb(ladders[k].line, &with_exact, STATUS_OK, l, &why);
        if (l->open != ladders[k].open) fail_msg("%s: open %d", ladders[k].line, l->open);
        free(l);
    }
}

static void temporal_ladder_reports_its_slope(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04,0.02,0.08 --stepper rkl2", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->in_time, 1);
    assert_near(l->slope.value, 2, 1e-6);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04,0.02,0.08 --stepper euler", &with_exact, STATUS_OK, l, &why);
    assert_near(l->slope.value, 1, 1e-6);
    /* from differences of successive runs at unequal ratios; E1 is relative to sums of T with the error in it */
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.08,0.05,0.02,0.01,0.004 --stepper rkl2", &euler, STATUS_OK, l, &why);
    assert_int_equal(l->n, 4);
    assert_near(l->slope.value, 2, 0.01);
    for (int i = 0; i < 4; i++) assert_near(l->error[i] / l->error[0], pow(l->x[i] / l->x[0], 2), 0.01);
    climb("ladder rod-gauss ftcs --dx 0.5 --dt 0.01,0.04", &euler, STATUS_INPUT, l, &why);
    assert_has(why.text, "at least three time steps");
    free(l);
}

static void short_ladders_are_inconclusive(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25 --expect 1.9,2.1 --ceiling 1", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE); /* a ceiling does not make up for the rung */
    assert_has(l->reason, "3 rungs count, at least 4 must");
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25", &with_exact, STATUS_OK, l, &why);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1", &with_exact, STATUS_INPUT, l, &why);
    assert_has(why.text, "at least two rungs, and a gate 4");
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.5", &with_exact, STATUS_INPUT, l, &why);
    assert_has(why.text, "--dx: 0.5 is given twice");
    climb("ladder rod-gauss ftcs --dx 1 --dt 0.5,0.5", &with_exact, STATUS_INPUT, l, &why);
    assert_has(why.text, "--dt: 0.5 is given twice");
    free(l);
}

static void two_rungs_have_no_interval(void **state) {
    (void)state;
    struct failure why;
    char text[160];
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 1,0.5 --expect 1.9,2.1", &with_exact, STATUS_OK, l, &why);
    ladder_slope_text(l, text, sizeof text);
    assert_string_equal(text, "slope of E1: 2.0000, 95 % interval - (undefined for two rungs), over 2 of 2 rungs");
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    climb("ladder rod-gauss ftcs --dx 1,0.5,0.25 --norm interior", &with_exact, STATUS_OK, l, &why);
    ladder_slope_text(l, text, sizeof text);
    assert_has(text, "slope of E1 of the interior: 2.0");
    assert_lacks(text, "nan");
    free(l);
}

/* Bounds of a quantity are fractions of its own error, those of a field are fractions of E1. */
static void floors_are_relative_to_the_fitted_error(void **state) {
    (void)state;
    struct ladder *l = xcalloc(1, sizeof *l);
    l->n = 4;
    for (int i = 0; i < 4; i++) {
        l->x[i] = 1 / pow(2, i);
        l->rung[i] = (struct result){.error[NORM_L1] = 0.004, .error[NORM_QUANTITY] = 0.001, .time_error = NAN};
    }
    l->rung[0].derived_bound = 2e-4, l->rung[1].derived_rounding = 3e-4, l->rung[2].reference_error = 2e-3;
    l->rung[3].rounding = 1e-3;
    ladder_fit(l, NORM_QUANTITY);
    assert_string_equal(l->window.left_out[0], "reference floor: up to 20 % is the reference's own error");
    assert_string_equal(l->window.left_out[1], "round-off floor: up to 30 % of the error is rounding");
    assert_true(l->window.counts[2] && l->window.counts[3]);
    ladder_fit(l, NORM_L1);
    assert_true(l->window.counts[0] && l->window.counts[1]);
    assert_string_equal(l->window.left_out[2], "reference floor: up to 50 % is the reference's own error");
    assert_string_equal(l->window.left_out[3], "round-off floor: up to 25 % of the error is rounding");
    l->rung[0].time_error = 0.034; /* which is all of the error of a ladder in time */
    ladder_fit(l, NORM_L1);
    assert_string_equal(l->window.left_out[0], "time-error floor: 3.4 % of the error is the time step's");
    l->in_time = 1;
    ladder_fit(l, NORM_L1);
    assert_true(l->window.counts[0]);
    free(l);
}

/* Two of three rungs are included, and one of these has an error; an excluded one has one too. */
static void rungs_that_count_and_have_an_error_are_counted(void **state) {
    (void)state;
    struct ladder *l = xcalloc(1, sizeof *l);
    char text[160];
    l->n = 3, l->slope.value = NAN;
    l->window.counts[0] = l->window.counts[1] = 1;
    l->error[0] = NAN, l->error[1] = 1e-3, l->error[2] = 2e-3;
    ladder_slope_text(l, text, sizeof text);
    assert_string_equal(text, "slope of E1: - (of 3 rungs 1 have an error, a slope needs two)");
    l->error[1] = 0;
    ladder_slope_text(l, text, sizeof text);
    assert_has(text, "of 3 rungs 0 have an error");
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
    assert_has(l->reason, "above its ceiling 0.0048");
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --expect 1.9,2.1 --ceiling 0.0048", &with_exact, STATUS_OK, l,
          &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    /* another norm, another size: that of the largest error, K */
    climb("ladder rod-gauss ftcs --dx 0.25,1,0.125,0.5 --norm linf --ceiling 0.0049", &with_exact, STATUS_OK, l,
          &why);
    assert_near(ladder_finest_error(l), l->rung[3].error[NORM_LINF], 0);
    free(l);
}

/* One of four rungs has no answer: the ladder fails, and the slope is that of the others. */
static void failed_rungs_are_left_out_of_the_slope(void **state) {
    (void)state;
    struct ladder *l = xcalloc(1, sizeof *l);
    char text[160];
    l->n = 4;
    for (int i = 0; i < 4; i++) {
        l->x[i] = 1 / pow(2, i);
        l->rung[i] = (struct result){.error[NORM_L1] = 0.3 * pow(4, -i), .time_error = NAN};
    }
    l->rung[2].failure.status = l->failure.status = STATUS_INPUT;
    ladder_fit(l, NORM_L1);
    assert_near(l->slope.value, 2, 1e-12);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    ladder_slope_text(l, text, sizeof text);
    assert_has(text, "over 3 of 4 rungs");
    free(l);
}

static void a_failed_rung_fails_the_ladder(void **state) {
    (void)state;
    struct failure why;
    struct ladder *l = xcalloc(1, sizeof *l);
    climb("ladder rod-gauss ftcs --dx 3,1,0.75,0.5,0.25 --expect 1.9,2.1", &broken, STATUS_UNSTABLE, l, &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    assert_has(l->reason, "T grew at step 7");
    ladder_judge(l, 1.9, 2.1);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    free(l);
}

/* Jumps of square-step at 1/2 and -1/2 of [-1, 1]: faces of 4 n cells; of rod-step at 1/3 of [-2, 2], a third of
 * a cell from a face where 12 does not divide the number of cells.  The interface of wall-composite at 0.4 of [0, 1]:
 * faces of 5 n cells. */
static void jumps_at_other_places_in_a_cell_are_named(void **state) {
    (void)state;
    static const struct {
        const char *line, *text;
    } row[] = {
        {"ladder square-step ftcs --dx 0.5,0.2,0.1,1/15", "the jump at x = -0.5 m is 0, 0.5, 0, 0.5 cells from a "
                                                          "face: the error scatters from rung to rung; on faces with "
                                                          "--dx 0.5,0.25,0.1,0.071428571"},
        {"ladder square-step ftcs --dx 0.5,0.25,0.1,0.05", ""},
        {"ladder wall-composite ftcs --dx 0.2,0.125,0.1,0.05 --set rho_c1=2 --set k2=0.2 --set rho_c2=0.1 --set "
         "t_end=0.15",
         "the interface at x = 0.4 m is 0, 0.2, 0, 0 cells from a face: the error scatters from rung to rung; on "
         "faces with "
         "--dx 0.2,0.1,0.066666667,0.05"},
        {"ladder rod-step ftcs --dx 0.1,0.05,0.025,0.0125 --set a=1/3", ""},
        {"ladder rod-step ftcs --dx 0.1,0.05,1/30,0.025 --set a=1/3",
         "the jump at x = -0.3333 m is 0.33, 0.33, 0, 0.33 cells from a face: the error scatters from rung to rung; "
         "on faces "
         "with --dx 0.11111111,0.047619048,0.033333333,0.025641026"},
        {"ladder rod-step ftcs --dx 0.1,0.05,1/30,0.025 --set a=0.318309886183791",
         "the jump at x = -0.3183 m is 0.18, 0.37, 0.45, 0.27 cells from a face: the error scatters from rung to "
         "rung"},
        {"ladder rod-cosine ftcs --dx 0.1,0.05,1/30,0.025", ""},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct ladder *l = xcalloc(1, sizeof *l);
        struct command r = request(row[k].line, method_find("ftcs"));
        struct failure why;
        char text[480];
        if (ladder_run(&r.experiment, &r.rungs, l, &why)) fail_msg("%s: %s", row[k].line, why.text);
        ladder_places_text(l, &r.experiment.problem, text, sizeof text);
        assert_string_equal(text, row[k].text);
        command_free(&r);
        ladder_free(l);
        free(l);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spatial_ladder_reports_its_slope),
        cmocka_unit_test(json_has_every_number),
        cmocka_unit_test(only_failures_in_space_are_diagnosed),
        cmocka_unit_test(temporal_ladder_reports_its_slope),
        cmocka_unit_test(short_ladders_are_inconclusive),
        cmocka_unit_test(two_rungs_have_no_interval),
        cmocka_unit_test(floors_are_relative_to_the_fitted_error),
        cmocka_unit_test(rungs_that_count_and_have_an_error_are_counted),
        cmocka_unit_test(a_ceiling_bounds_the_finest_rung),
        cmocka_unit_test(failed_rungs_are_left_out_of_the_slope),
        cmocka_unit_test(a_failed_rung_fails_the_ladder),
        cmocka_unit_test(jumps_at_other_places_in_a_cell_are_named),
    };
    return cmocka_run_group_tests_name("ladder", tests, NULL, NULL);
}
