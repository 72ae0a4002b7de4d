/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates: that none can pass without having been judged. */
#include "verification/gates/gates.h"

#include "verification/case/command.h"
#include "verification/fault/headline.h"
#include "verification/report/page.h"
#include "verification/judge/run.h"

#include "solver/field.h"
#include "solver/method.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct measured judge(const char *measure, const char *command, double lo, double hi, double ceiling) {
    struct gate gate = {"test", TIER_QUICK, measure, command, lo, hi, ceiling, "a test"};
    struct measured m;
    gates_judge(&gate, NULL, &m);
    measures_free(&m);
    return m;
}

static void assert_fails(struct measured m, const char *part) {
    assert_int_equal(m.verdict, VERDICT_FAIL);
    if (!strstr(m.reason, part)) fail_msg("\"%s\" does not hold \"%s\"", m.reason, part);
}

#define LADDER "ladder rod-gauss ftcs --dx 0.5,0.25,0.125,0.0625"

static void correct_gate_passes(void **state) {
    (void)state;
    struct measured m = judge("slope", LADDER, 1.9, 2.1, 1e-3);
    if (m.verdict != VERDICT_PASS) fail_msg("%s", m.reason);
    assert_order(m.ci[0], <, m.value);
    assert_order(m.value, <, m.ci[1]);
    assert_order(m.error, >, 0);
    m = judge("error", "run rod-gauss ftcs --dx 0.5", 0, 1e-3, NAN);
    if (m.verdict != VERDICT_PASS) fail_msg("%s", m.reason);
}

/* A number names what it is of, and its unit or norm. */
static void reason_names_the_measure(void **state) {
    (void)state;
    const char *heat = "run rod-cosine ftcs --dx 0.05 --quantity heat";
    assert_fails(judge("quantity_error", heat, 0, -1, NAN), "the error of the heat is ");
    assert_fails(judge("quantity_error", heat, 0, -1, NAN), " of its exact value, above the ceiling -1");
    assert_fails(judge("error_linf", "run rod-gauss ftcs --dx 0.5", 0, 1e-9, NAN), " K, above the ceiling 1e-09");
    assert_fails(judge("error", "run rod-gauss ftcs --dx 0.5", 0, 1e-9, NAN), "the error E1 is ");
    assert_fails(judge("quantity", "run rod-gauss ftcs --dx 0.5 --quantity at:0.125", -2, -1, NAN), "T at 0.125 is ");
    assert_fails(judge("quantity", heat, -2, -1, NAN), " J/m^2, outside [-2, -1]");
}

static void a_wrong_order_fails(void **state) {
    (void)state;
    assert_fails(judge("slope", LADDER, 0.9, 1.1, 1e-3), "is outside");
}

static void correct_order_above_the_ceiling_fails(void **state) {
    (void)state;
    assert_fails(judge("slope", LADDER, 1.9, 2.1, 1e-9), "is above its ceiling");
    assert_fails(judge("error", "run rod-gauss ftcs --dx 0.5", 0, 1, 1e-9), "is above its ceiling");
}

static void an_order_needs_a_ceiling(void **state) {
    (void)state;
    assert_fails(judge("slope", LADDER, 1.9, 2.1, NAN), "needs a ceiling");
    struct measured none = judge("slope", LADDER " --norm linf", 1.9, 2.1, 0);
    assert_fails(none, "needs a ceiling");
    assert_nan(none.value);
    assert_nan(none.ci[0]);
    assert_nan(none.ci[1]);
    assert_nan(none.error);
}

/* A limit of stability has no error. */
static void nan_error_fails(void **state) {
    (void)state;
    const char *command = "limit so_ssph --dim 1 --kernel cubic --h 1.05";
    struct measured m = judge("limit_published", command, 0.95, 1, 1);
    assert_order(0.95, <=, m.value);
    assert_order(m.value, <=, 1);
    assert_nan(m.error);
    assert_int_equal(m.verdict, VERDICT_FAIL);
}

/* At order 4 the hot piece leaves nothing above 10 K, and some 1e-4 K below 0. */
static void undershoot_counts_as_overshoot(void **state) {
    (void)state;
    struct measured m = judge("overshoot", "run rod-step so_ssph --dx 0.1 --order 4", 0, 1e-12, 1);
    assert_order(m.value, >, 1e-5);
    assert_order(m.value, <, 1e-3);
    assert_int_equal(m.verdict, VERDICT_FAIL);
}

static void three_rungs_do_not_pass(void **state) {
    (void)state;
    struct measured m = judge("slope", "ladder rod-gauss ftcs --dx 0.5,0.25,0.125", 1.9, 2.1, 1e-3);
    assert_int_equal(m.verdict, VERDICT_INCONCLUSIVE);
    assert_has(m.reason, "at least 4");
}

static void unknown_names_fail(void **state) {
    (void)state;
    assert_fails(judge("slpoe", LADDER, 1.9, 2.1, 1e-3), "unknown measure 'slpoe'; did you mean 'slope'?");
    assert_fails(judge("slope", "ladder rod-gaus ftcs --dx 1,0.5", 1.9, 2.1, 1), "unknown scene 'rod-gaus'");
    assert_fails(judge("slope", "laddr rod-gauss ftcs --dx 1,0.5", 1.9, 2.1, 1), "unknown verb 'laddr'");
    assert_fails(judge("error", "run rod-gauss ftcs --dx 0.7", 0, 1, NAN), "--dx 0.7");
}

static void instability_fails_with_its_reason(void **state) {
    (void)state;
    assert_fails(judge("error", "run rod-step ftcs --dx 0.025 --fourier 0.7", 0, INFINITY, NAN), "unstable");
    assert_fails(judge("slope", "ladder rod-step ftcs --dx 0.1,0.05,0.025,0.0125 --fourier 0.7", 0, 9, 9),
                 "unstable");
}

static void nonfinite_values_fail(void **state) {
    (void)state;
    assert_fails(judge("error", "run rod-gauss ftcs --dx 0.5", NAN, 1, NAN), ", outside [");
    assert_fails(judge("checkerboard_kept", "run rod-gauss ftcs --dx 0.5 --dt 1e-3", -1, -0.5, NAN), ", outside [");
}

static void operator_slope_needs_a_particle_method(void **state) {
    (void)state;
    const char *line = "ladder rod-gauss so_ssph --dx 0.4,0.1,0.2,0.05"; /* in any order */
    assert_int_equal(judge("operator_slope", line, 1.9, 2.1, 1).verdict, VERDICT_PASS);
    assert_fails(judge("operator_slope", LADDER, 1.9, 2.1, 1), "ftcs is not a particle method");
    assert_int_equal(judge("operator_slope", "ladder square-step fo_ssph --dx 0.4,0.1,0.2,0.05", 1.9, 2.1, 1).verdict,
                     VERDICT_PASS);
}

/* Linear images are second order only if the wall is midway; a fit is at every offset, and its largest error is not
 * at the first. */
static void slope_offsets_needs_every_offset(void **state) {
    (void)state;
    const char *image = "ladder rod-cooling so_ssph --h 1.1 --walls image --dx 0.3/20,0.3/40,0.3/80,0.3/160";
    const char *fit = "ladder rod-cooling so_ssph --walls fit --dx 0.3/20,0.3/40,0.3/80,0.3/160";
    assert_int_equal(judge("slope", image, 1.8, 2.3, 1).verdict, VERDICT_PASS);
    assert_fails(judge("slope_offsets", image, 1.8, 2.3, 1), "offset 0.1 dx: ");
    struct measured one = judge("slope", fit, 1.8, 2.2, 1), all = judge("slope_offsets", fit, 1.8, 2.2, 1);
    assert_int_equal(all.verdict, VERDICT_PASS);
    double most = 0;
    for (int s = 0; s < 10; s++) {
        char line[120];
        snprintf(line, sizeof line, "%s --shift 0.%d", fit, s);
        most = fmax(most, judge("slope", line, 1.8, 2.2, 1).error);
    }
    assert_near(all.error, most, 0);
    assert_order(most, >, 1.2 * one.error);
}

static void nan_ceiling_prints_none(void **state) {
    (void)state;
    const struct gate gate = {"test", TIER_QUICK, "slope", LADDER, 1.9, 2.1, NAN, "a test"};
    char text[400];
    gates_command(&gate, NULL, text, sizeof text);
    assert_string_equal(text, LADDER " --expect 1.9,2.1");
}

/* Measures that no right code would show to be wrong: an interval about its value, and the two times of a wave. */
static void measures_vary_with_their_input(void **state) {
    (void)state;
    struct measured m = judge("operator_slope", "ladder rod-gauss so_ssph --dx 0.4,0.2,0.1,0.05", 1.9, 2.1, 1);
    assert_order(m.ci[0], <, m.value);
    assert_order(m.value, <, m.ci[1]);
    double wave[2];
    const char *const line[] = {"run rod-step ftcs --dx 0.1 --t-end 0.02", "run rod-step ftcs --dx 0.1 --t-end 0.2"};
    for (int i = 0; i < 2; i++) {
        struct command r;
        struct failure why;
        struct result result;
        assert_int_equal(command_read(line[i], &r, &why), STATUS_OK);
        assert_int_equal(run_experiment(&r.experiment, &result, NULL), STATUS_OK);
        wave[i] = result.shape.checkerboard;
        command_free(&r);
    }
    m = judge("checkerboard_kept", line[1], 0, 1, NAN);
    assert_order(fabs(wave[1] / wave[0] - 1), >, 0.1);
    assert_near(m.value, wave[1] / wave[0], 1e-12);
}

/* A reference whose forms disagree, or whose bound is large or not a number. */
static double gap, bound;

static struct exact one(const struct problem *p, const void *shared, const double *x, double t) {
    (void)p, (void)shared, (void)x, (void)t;
    return (struct exact){.temperature = 2.5, .error_bound = bound};
}

static struct exact two(const struct problem *p, const double x[2], double t) {
    (void)p, (void)t;
    return (struct exact){.temperature = 2.5 + (x[0] > 0.9 ? gap : 0)};
}

static struct measured reference(double apart, double promise) {
    static const struct param none[] = {{0}};
    struct scene scene = {.name = "test", .params = none, .exact = one, .second = two};
    struct command r = {.experiment.scene = &scene, .experiment.problem = {.dim = 1, .hi = {1}, .t_end = 1}};
    struct measured m;
    gap = apart, bound = promise;
    measures_find("reference", &m)->take(&r, 0, 1, &m);
    return m;
}

static void references_keep_their_bounds(void **state) {
    (void)state;
    assert_int_equal(reference(0, 0).verdict, VERDICT_PASS);
    assert_int_equal(reference(0.9e-13, 1e-13).verdict, VERDICT_PASS);
    assert_int_equal(reference(1.1e-13, 1e-13).verdict, VERDICT_FAIL);
    assert_int_equal(reference(1e-15, 0).verdict, VERDICT_FAIL);
    assert_int_equal(reference(NAN, 1e-13).verdict, VERDICT_FAIL);
    assert_int_equal(reference(1e-15, NAN).verdict, VERDICT_FAIL);
    assert_int_equal(reference(0, NAN).verdict, VERDICT_FAIL);
    assert_int_equal(reference(0, -1).verdict, VERDICT_FAIL);
    assert_near(reference(0, 0.25).error, 0.1, 1e-15);
}

static void junit_lists_every_verdict(void **state) {
    (void)state;
    struct gates g;
    struct failure why;
    char path[UNIT_PATH], text[20000];
    close(scratch_file(path, "heatladder_junit"));
    assert_int_equal(gates_collect("reference/rod-*", NULL, 0, &g, &why), STATUS_OK);
    gates_run(&g);
    g.result[0].seconds = 1.25, g.result[1].seconds = 0.5;
    for (int i = 2; i < g.declared; i++) g.result[i].seconds = 0;
    g.result[1].measured.verdict = VERDICT_INCONCLUSIVE;
    snprintf(g.result[1].measured.reason, sizeof g.result[1].measured.reason, "3 rungs < 4 & more");
    snprintf(g.result[1].measured.diagnosis, sizeof g.result[1].measured.diagnosis, "as if 1 > 0");
    g.result[1].measured.found = (struct diagnosis){.named = 1, .fault = {FAULT_SOME_STEPS, 0}, .unit = "steps"};
    gates_diagnose(&g);
    assert_int_equal(junit_write(&g, path, &why), STATUS_OK);
    FILE *in = fopen(path, "r");
    text[fread(text, 1, sizeof text - 1, in)] = '\0';
    fclose(in);
    unlink(path);
    assert_has(text, "<testcase classname=\"heatladder.reference\" name=\"reference/rod-step\"");
    assert_has(text, "<property name=\"diagnosis\" value=\"perhaps as if runs at some spacings had stopped one step "
                     "late: `while (t &lt; t_end)`");
    assert_has(text, "<testsuite name=\"reference\" tests=");
    assert_lacks(text, "interrupted");
    assert_has(text, "failures=\"0\" errors=\"1\" skipped=\"0\" time=\"1.750\"");
    assert_has(text, " time=\"1.250\"");
    assert_has(text, " time=\"0.500\"");
    assert_has(text, "<error message=\"3 rungs &lt; 4 &amp; more; diagnosis: as if runs at some");
    gates_free(&g);
}

/* One suite per group; the rows after an interrupt are errors, even if all rows before it passed. */
static void junit_has_groups_and_interrupts(void **state) {
    (void)state;
    struct gate_result result[4] = {{.gate.id = "b/1", .executed = 1},
                                    {.gate.id = "a/1", .executed = 1},
                                    {.gate.id = "b/2", .executed = 0},
                                    {.gate.id = "b/3", .executed = 1}};
    struct gates g = {.declared = 4, .executed = 3, .result = result};
    struct failure why;
    char path[] = "/tmp/heatladder_junit.XXXXXX", text[20000];
    for (int i = 0; i < 4; i++) result[i].measured.verdict = VERDICT_PASS, result[i].gate.why = "it";
    gates_cut(&g, SIGTERM);
    assert_int_equal(g.declared, 3);
    close(mkstemp(path));
    assert_int_equal(junit_write(&g, path, &why), STATUS_OK);
    FILE *in = fopen(path, "r");
    text[fread(text, 1, sizeof text - 1, in)] = '\0';
    fclose(in);
    unlink(path);
    assert_has(text, "<testsuite name=\"b\" tests=\"2\" failures=\"0\" errors=\"0\"");
    assert_has(text, "<testsuite name=\"a\" tests=\"1\"");
    assert_lacks(text, "b/2");
    assert_has(text, "<error message=\"interrupted by signal 15: 3 of 4 rows were judged\"/>");
}

static void failing_gates_are_diagnosed(void **state) {
    (void)state;
    static const enum verdict verdicts[] = {VERDICT_FAIL, VERDICT_PASS, VERDICT_INCONCLUSIVE, VERDICT_SKIPPED};
    struct gate_result result[4] = {0};
    struct gates g = {.declared = 4, .executed = 4, .result = result};
    for (int i = 0; i < 4; i++) {
        result[i].gate.measure = "error";
        result[i].measured.verdict = verdicts[i];
        result[i].measured.found = (struct diagnosis){.named = 1, .fault = {FAULT_SWAP, 0}, .unit = ""};
    }
    struct measured refused = {0};
    measures_fail(&refused, &(struct failure){.status = STATUS_UNSTABLE, .text = "T = 1e+30 K"});
    assert_int_equal(refused.found.fault.kind, FAULT_UNSTABLE);
    measures_fail(&refused, &(struct failure){.status = STATUS_NUMERICAL, .text = "status 1"});
    assert_false(refused.found.named);
    measures_fail(&refused, &(struct failure){.status = STATUS_INPUT, .exchanged = 3});
    assert_has(refused.found.what, "x and z were swapped");
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis, "as if k_x and k_y were in each other's place (2 of 2 rows that do not pass)");
    result[1].gate =
        (struct gate){.measure = "order",
                      .ceiling = 1e-3,
                      .command = "ladder square-step mine --set kappa_x=0.02 --set kappa_y=0.01 --dx 0.2,0.1"};
    gates_diagnose(&g); /* that passes, and could not with the fault */
    assert_lacks(g.diagnosis, "k_x and k_y");
    result[1].gate = (struct gate){.measure = "error",
                                   .hi = 1e-3,
                                   .ceiling = NAN,
                                   .command = "run square-step mine --set kappa_x=0.02 --set kappa_y=0.01 --dx 0.1"};
    gates_diagnose(&g); /* nor could a single run */
    assert_lacks(g.diagnosis, "k_x and k_y");
    result[1].gate.hi = 1;
    gates_diagnose(&g);
    assert_has(g.diagnosis, "k_x and k_y");
}

/* Rows that the first fault leaves unexplained have one of their own; a single row has not. */
static void a_second_fault_is_named(void **state) {
    (void)state;
    struct gate_result result[5] = {0};
    struct gates g = {.declared = 5, .executed = 5, .result = result};
    for (int i = 0; i < 5; i++) {
        result[i].gate.measure = "error";
        result[i].measured.verdict = VERDICT_FAIL;
        result[i].measured.found =
            (struct diagnosis){.named = 1, .fault = {i < 3 ? FAULT_SWAP : FAULT_DIFFUSIVITY, 0}, .unit = ""};
    }
    gates_diagnose(&g);
    assert_has(g.diagnosis,
               "as if k_x and k_y were in each other's place (3 of 5 rows that do not pass); of the others 2: ");
    assert_has(result[4].measured.diagnosis, strstr(g.diagnosis, "others 2: ") + strlen("others 2: "));
    result[4].measured.verdict = VERDICT_PASS;
    gates_diagnose(&g);
    assert_lacks(g.diagnosis, "of the others");
}

/* Without a fault that has a name: what the rows share, or what a row that is alone detects. */
static void rows_without_a_name_say_what_they_share(void **state) {
    (void)state;
    static const char *const commands[] = {"run aligned mine --set angle=0.75 --dx 0.1", "run aligned mine --dx 0.1",
                                           "run ring mine --dx 0.1", "run rod-gauss mine --dx 0.1",
                                           "run wave mine --set kappa_xy=0.006 --dx 0.1"};
    struct gate_result result[5] = {0};
    struct gates g = {.declared = 5, .executed = 5, .result = result};
    for (int i = 0; i < 5; i++) {
        result[i].gate =
            (struct gate){.measure = "leak", .command = commands[i], .why = "detects a face lost; bounds: 2"};
        result[i].measured.verdict = i < 2 ? VERDICT_FAIL : VERDICT_PASS;
    }
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis,
                        "all rows that do not pass (2) have k_xy beside held walls, and no other row does");
    result[1].measured.verdict = VERDICT_PASS;
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis, "one row alone does not pass: it detects a face lost");
    result[0].measured.verdict = VERDICT_INCONCLUSIVE;
    gates_diagnose(&g);
    assert_lacks(g.diagnosis, "detects");
    result[0].measured.verdict = VERDICT_FAIL;
    result[0].measured.value = NAN; /* the program gave no answer */
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis, "all rows that do not pass (1) have k_xy beside held walls");
    result[2].measured.verdict = VERDICT_FAIL; /* a ring: T of its walls is constant beside them too */
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis, "all rows that do not pass (2) have a conductivity along a field");
}

/* Two rows of five with k_xy fail: among 65 rows that is no chance, 1 of 208; among 25 it is 1 of 30. */
static void a_feature_of_few_rows_is_said(void **state) {
    (void)state;
    enum { FEW = 5, ALL = 65 };
    struct gate_result result[ALL] = {0};
    struct gates g = {.result = result};
    for (int i = 0; i < ALL; i++) {
        result[i].gate.measure = "leak";
        result[i].gate.command = i < FEW ? "run ring mine --dx 0.1" : "run rod-gauss mine --dx 0.1";
        result[i].measured.verdict = i < 2 ? VERDICT_FAIL : VERDICT_PASS;
    }
    for (int few = 0; few < 2; few++) {
        g.declared = g.executed = few ? 25 : ALL;
        gates_diagnose(&g);
        assert_string_equal(g.diagnosis, few ? "" : "all rows that do not pass (2) are in the plane");
    }
}

/* A row without an answer, as one that is not a number, does not speak against overflow; another answer does. */
static void overflow_is_firm_where_no_row_has_another_answer(void **state) {
    (void)state;
    struct gate_result result[3] = {0};
    struct gates g = {.declared = 3, .executed = 3, .result = result};
    for (int i = 0; i < 3; i++)
        result[i].gate.measure = "order",
        measures_fail(&result[i].measured, &(struct failure){.status = i ? STATUS_NUMERICAL : STATUS_UNSTABLE});
    gates_diagnose(&g);
    assert_string_equal(g.diagnosis, "temperatures overflow, as in an unstable run (1 of 3 rows that do not pass)");
    result[2].measured.value = 1.2;
    gates_diagnose(&g);
    assert_has(g.diagnosis, "perhaps temperatures overflow");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(correct_gate_passes),
        cmocka_unit_test(reason_names_the_measure),
        cmocka_unit_test(a_wrong_order_fails),
        cmocka_unit_test(correct_order_above_the_ceiling_fails),
        cmocka_unit_test(an_order_needs_a_ceiling),
        cmocka_unit_test(nan_error_fails),
        cmocka_unit_test(undershoot_counts_as_overshoot),
        cmocka_unit_test(three_rungs_do_not_pass),
        cmocka_unit_test(unknown_names_fail),
        cmocka_unit_test(instability_fails_with_its_reason),
        cmocka_unit_test(nonfinite_values_fail),
        cmocka_unit_test(operator_slope_needs_a_particle_method),
        cmocka_unit_test(slope_offsets_needs_every_offset),
        cmocka_unit_test(nan_ceiling_prints_none),
        cmocka_unit_test(measures_vary_with_their_input),
        cmocka_unit_test(references_keep_their_bounds),
        cmocka_unit_test(junit_lists_every_verdict),
        cmocka_unit_test(junit_has_groups_and_interrupts),
        cmocka_unit_test(failing_gates_are_diagnosed),
        cmocka_unit_test(a_second_fault_is_named),
        cmocka_unit_test(rows_without_a_name_say_what_they_share),
        cmocka_unit_test(a_feature_of_few_rows_is_said),
        cmocka_unit_test(overflow_is_firm_where_no_row_has_another_answer),
    };
    return cmocka_run_group_tests_name("gates", tests, NULL, NULL);
}
