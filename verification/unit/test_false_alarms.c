/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Correct or undecidable answers do not fail: exact, noisy, or with few digits. */
#include "verification/unit/made_answers.inc"

#include "verification/fault/diagnose.h"
#include "verification/case/command.h"
#include "verification/solve/program.h"
#include "verification/judge/ladder.h"

#include "verification/unit/battery_row.h"

#include <gsl/gsl_cdf.h>

#include <unistd.h>

static const char *self; /* this program */

/* The row of the battery, judged by this program's answer of that kind ("MODE AMOUNT"). */
static void row(int order, const char *id, const char *made, struct measured *m) {
    struct program program = {.label = "mine"};
    char command[300];
    snprintf(command, sizeof command, "%s --made %s {case} {out}", self, made);
    program.solver = command;
    struct gates g = battery_rows(order, id);
    gates_judge(&g.result[0].gate, &program, m);
    measures_free(m);
    gates_free(&g);
}

static void ladder(const char *line, const char *made, struct ladder *l) {
    struct command r;
    struct failure why = {0};
    char command[600];
    snprintf(command, sizeof command, "%.250s --solver '%s --made %s {case} {out}'", line, self, made);
    if (command_read(command, &r, &why)) fail_msg("%s: %s", command, why.text);
    struct diagnosis d;
    if (ladder_run(&r.experiment, &r.rungs, l, &why)) fail_msg("%s: %s", command, why.text);
    diagnose_ladder(&r.experiment, l, &d);
    free(d.evidence);
    command_free(&r);
    ladder_free(l);
}

static void an_exact_code_passes(void **state) {
    (void)state;
    static const char *const id[] = {"smooth/gauss",  "walls/insulated", "walls/cooled", "jump/faces",
                                     "plane/largest", "contact/rod",     "whole/flux",   "whole/heat"};
    static const int order4[] = {1, 1, 0, 1, 1, 0, 0, 0};
    struct measured m;
    for (int i = 0; i < 8; i++)
        for (int order = 2; order <= (order4[i] ? 4 : 2); order += 2) {
            row(order, id[i], "exact 1e-15", &m);
            if (m.verdict != VERDICT_PASS) fail_msg("%s: %s", id[i], m.reason);
        }
}

/* T of 2 K above an offset of 1e6 K rounds to eps 1e6/4 on average, 3e-11 of it; a scale rounds like T. */
static void an_exact_code_in_other_temperatures_passes(void **state) {
    (void)state;
    struct ladder *l = xcalloc(1, sizeof *l);
    for (int scaled = 0; scaled < 2; scaled++) {
        char line[200];
        snprintf(line, sizeof line,
                 "ladder rod-cosine mine --dx 1/20,1/40,1/60,1/80 --expect 1.9,2.1 --ceiling 1e-10 %s",
                 scaled ? "--scale 1e-6" : "--offset 1e6");
        ladder(line, "exact 1e-15", l);
        if (l->verdict != VERDICT_PASS) fail_msg("%s", l->reason);
        assert_has(l->reason, "4 of 4 rungs are at round-off");
        ladder(line, "second 1e-2", l); /* far above rounding: its order counts */
        assert_int_equal(l->slope.n, 4);
    }
    free(l);
}

/* Cells of widths 0.8 dx and 1.2 dx in turn: mean errors and fluxes. */
static void a_code_with_cells_of_two_widths_passes(void **state) {
    (void)state;
    static const char *const id[] = {"smooth/gauss", "walls/insulated", "walls/cooled", "jump/faces", "whole/flux"};
    struct measured m;
    for (int i = 0; i < 5; i++) {
        row(2, id[i], "widths 0.05", &m);
        if (m.verdict != VERDICT_PASS) fail_msg("%s: %s", id[i], m.reason);
    }
}

/* As a typed ladder: passes below a ceiling, fails above it, and is inconclusive without one. */
static void rung_at_round_off_passes_its_ceiling(void **state) {
    (void)state;
    static const char *const line = "ladder rod-cosine mine --dx 1/20,1/40,1/60,1/80 --expect 1.9,2.1";
    char with[200];
    struct ladder *l = xcalloc(1, sizeof *l);
    snprintf(with, sizeof with, "%s --ceiling 1e-14", line);
    ladder(with, "exact 1e-15", l);
    assert_int_equal(l->verdict, VERDICT_PASS);
    assert_has(l->reason, "4 of 4 rungs are at round-off, without an order; the error ");
    assert_near(ladder_finest_error(l), l->rung[3].error[NORM_L1], 0);
    snprintf(with, sizeof with, "%s --ceiling 1e-17", line);
    ladder(with, "exact 1e-15", l);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    ladder(line, "exact 1e-15", l);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    snprintf(with, sizeof with, "%s --ceiling 1e-3", line); /* an error that is no rounding has its order */
    ladder(with, "exact 1e-5", l);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    free(l);
}

static void is_inconclusive(const char *id, const char *made, const char *said) {
    struct measured m;
    row(2, id, made, &m);
    if (m.verdict != VERDICT_INCONCLUSIVE || !strstr(m.reason, said))
        fail_msg("%s, %s: %s: %s", id, made, verdict_words[m.verdict], m.reason);
}

/* A cloud whose errors are far below the ceiling: the number of rungs that decide. */
/* Half the interval of a slope over the ladder's rungs and more by halving, `count` in all: scatter is that of the
 * ladder's own interval. */
static double half_interval(const struct ladder *l, int count) {
    double u[20], mean = 0, square[2] = {0, 0}, half = (l->slope.ci[1] - l->slope.ci[0]) / 2;
    for (int i = 0; i < count; i++) u[i] = i < l->n ? log(l->x[i]) : u[i - 1] - log(2);
    for (int k = 0; k < 2; k++) {
        int n = k ? count : l->n;
        mean = 0;
        for (int i = 0; i < n; i++) mean += u[i] / n;
        for (int i = 0; i < n; i++) square[k] += (u[i] - mean) * (u[i] - mean);
    }
    return half * gsl_cdf_tdist_Pinv(0.975, count - 2) / gsl_cdf_tdist_Pinv(0.975, l->n - 2) *
           sqrt(square[0] / square[1]);
}

static void the_number_of_missing_rungs_is_stated(void **state) {
    (void)state;
    static const char *const line = "ladder rod-cosine mine --dx 1/20,1/40,1/60,1/80 --expect 1.5,2.9 --ceiling 1";
    struct ladder *l = xcalloc(1, sizeof *l);
    ladder(line, "solver 5e-5", l);
    assert_int_equal(l->verdict, VERDICT_INCONCLUSIVE);
    print_message("%s\n", l->reason);
    assert_has(l->reason, "times below its ceiling and falls throughout (slopes ");
    assert_has(l->reason, "(--rungs ");
    int rungs = atoi(strstr(l->reason, "(--rungs ") + 9);
    double room = fmin(l->slope.value - 1.5, 2.9 - l->slope.value);
    assert_order(rungs, >, l->n + 1); /* so that the spacing of further rungs counts */
    assert_order(half_interval(l, rungs), <=, room);
    assert_order(half_interval(l, rungs - 1), >, room);
    free(l);
}

/* One draw a rung scatters by a factor of up to e^0.6; 12 of them show the order. */
static void draws_are_pooled(void **state) {
    (void)state;
    static const char *const line = "ladder rod-cosine mine --dx 1/20,1/40,1/60,1/80 --expect 1.5,2.5 --ceiling 1e-3";
    char with[200];
    struct ladder *l = xcalloc(1, sizeof *l);
    ladder(line, "cloud 0.6", l);
    assert_int_not_equal(l->verdict, VERDICT_PASS);
    snprintf(with, sizeof with, "%s --seeds 12", line);
    ladder(with, "cloud 0.6", l);
    if (l->verdict != VERDICT_PASS) fail_msg("%s", l->reason);
    assert_int_equal(l->draws, 12);
    double mean = 0, x[48], error[48];
    for (int k = 0; k < 12; k++) mean += log(l->draw[k][3]) / 12;
    assert_near(l->rung[3].error[NORM_L1], exp(mean), 1e-15);
    assert_true(l->draw[0][3] != l->draw[1][3]);
    for (int k = 0; k < 48; k++) x[k] = l->x[k / 12], error[k] = l->draw[k % 12][k / 12];
    struct slope all = slope_fit(x, error, 48);
    for (int i = 0; i < 2; i++) assert_near(l->slope.ci[i], all.ci[i], 1e-12);
    free(l);
}

/* Random numbers, digits and a tolerance have reasons of their own; where the error is above its ceiling by more than
 * they explain, it is wrong. */
static void undecidable_answers_are_inconclusive(void **state) {
    (void)state;
    struct measured m;
    is_inconclusive("walls/insulated", "noise 1e-3", "from run to run");
    is_inconclusive("walls/insulated", "noise 0.1", "random numbers, threads or an unset variable");
    is_inconclusive("whole/repeat", "noise 1e-3", "answers differ by 0.00");
    is_inconclusive("smooth/gauss", "digits 4", "printed digits: 4 in the file make up");
    is_inconclusive("walls/insulated", "solver 2e-4", "errors do not fall smoothly (slopes");
    is_inconclusive("smooth/clock", "noise 1e-3", "from run to run");
    row(2, "walls/insulated", "second 100", &m); /* its order, and an error too large */
    assert_int_equal(m.verdict, VERDICT_FAIL);
    row(2, "walls/insulated", "noise 1e-7", &m);
    assert_int_equal(m.verdict, VERDICT_PASS);
    row(2, "walls/insulated", "digits 9", &m);
    assert_int_equal(m.verdict, VERDICT_PASS);
}

int main(int argc, char **argv) {
    self = argv[0];
    if (argc == 6 && strcmp(argv[1], "--made") == 0) return made_main(argv, (int)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_exact_code_passes),
        cmocka_unit_test(an_exact_code_in_other_temperatures_passes),
        cmocka_unit_test(a_code_with_cells_of_two_widths_passes),
        cmocka_unit_test(rung_at_round_off_passes_its_ceiling),
        cmocka_unit_test(the_number_of_missing_rungs_is_stated),
        cmocka_unit_test(draws_are_pooled),
        cmocka_unit_test(undecidable_answers_are_inconclusive),
    };
    return cmocka_run_group_tests_name("false_alarms", tests, NULL, NULL);
}
