/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates as rows: the list, the choice of rows, the commands as typed, and the execution of all of them. */
#include "verification/gates/gates.h"

#include "verification/case/command.h"
#include "verification/judge/ladder.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Bounds are numbers: a ceiling where the measure needs one, above 0; a band that has an inside. */
static void gate_table_is_valid(void **state) {
    (void)state;
    struct gates all;
    struct failure why = {0};
    assert_int_equal(gates_collect(NULL, NULL, 0, &all, &why), STATUS_OK);
    for (int i = 0; i < all.declared; i++) {
        const struct gate *g = &all.result[i].gate;
        struct measured m;
        const struct measure *measure = measures_find(g->measure, &m);
        char command[GATES_COMMAND];
        if (!measure) fail_msg("%s: %s", g->id, m.reason);
        if (!(g->lo <= g->hi)) fail_msg("%s: [%g, %g] is no band", g->id, g->lo, g->hi);
        if (measure->ceiling && !(g->ceiling > 0)) fail_msg("%s: no ceiling", g->id);
        if (strcmp(g->measure, "slope") == 0 && floor(g->hi) > ceil(g->lo))
            fail_msg("%s: [%g, %g] has room for two orders", g->id, g->lo, g->hi);
        if (strlen(g->why) < 10) fail_msg("%s: no reason", g->id);
        if (strpbrk(g->id, "{} ") || strpbrk(g->command, "{}")) fail_msg("%s: a word is left", g->id);
        for (int k = 0; k < i; k++)
            if (strcmp(all.result[k].gate.id, g->id) == 0) fail_msg("%s is there twice", g->id);
        gates_command(g, NULL, command, sizeof command);
        assert_order(strlen(command), <, sizeof command - 1); /* none is cut */
    }
    gates_free(&all);
}

/* Each word in braces makes one gate, whose bounds belong to its own experiment. */
static void braces_expand_to_gates(void **state) {
    (void)state;
    struct gates g;
    struct failure why;
    assert_int_equal(gates_collect("lattice/so_ssph,lattice/ftcs,rod-step/*/midway", NULL, 0, &g, &why), STATUS_OK);
    assert_int_equal(g.declared, 6);
    assert_string_equal(g.result[0].gate.id, "lattice/so_ssph");
    assert_string_equal(g.result[1].gate.command, "ladder rod-cosine ftcs --dx 1/20,1/40,1/80,1/160,1/320");
    assert_order(g.result[0].gate.ceiling, >, 1.1 * g.result[1].gate.ceiling);
    assert_string_equal(g.result[3].gate.id, "rod-step/so_ssph/midway");
    assert_has(g.result[3].gate.command, "ladder rod-step so_ssph --h 1.05 --dx");
    gates_free(&g);
}

/* The typed command gives the same verdict for the same reason: interval, norm or ceiling. */
static void gate_command_runs_as_printed(void **state) {
    (void)state;
    static const struct gate rows[] = {
        {"a", TIER_QUICK, "slope", "ladder rod-gauss so_ssph --dx 1,0.5,0.25,0.125", 2.01, 2.3, 1, "too high"},
        {"b", TIER_QUICK, "slope", "ladder plate so_ssph --dx 0.01,0.005,0.0025,0.00125 --norm linf", 1.9, 2.1, 1,
         "a corner"},
        {"c", TIER_QUICK, "slope", "ladder rod-step so_ssph --dx 0.2,0.1,0.05,0.025 --norm boundary", 1.8, 2.2, 1e-7,
         "low"},
        {"d", TIER_QUICK, "slope", "ladder rod-gauss so_ssph --dx 1,0.5", 1.9, 2.1, 1, "short"}};
    for (int k = 0; k < 4; k++) {
        char command[GATES_COMMAND];
        struct measured m;
        struct command r;
        struct failure why;
        struct ladder *l = xcalloc(1, sizeof *l);
        gates_judge(&rows[k], NULL, &m);
        assert_int_not_equal(m.verdict, VERDICT_PASS);
        gates_command(&rows[k], NULL, command, sizeof command);
        if (command_read(command, &r, &why)) fail_msg("%s: %s", command, why.text);
        assert_int_equal(ladder_run(&r.experiment, &r.rungs, l, &why), STATUS_OK);
        assert_int_equal(l->verdict, m.verdict);
        assert_string_equal(l->reason, m.reason);
        measures_free(&m);
        command_free(&r);
        ladder_free(l);
        free(l);
    }
    const struct gate other = {"symmetry/odd", TIER_QUICK, "symmetry", "run plate ftcs --dx 0.005", 2, 2, 1,
                               "no ladder"};
    char command[GATES_COMMAND];
    gates_command(&other, NULL, command, sizeof command);
    assert_string_equal(command, "verify --only symmetry/odd");
}

static void globs_select_gates(void **state) {
    (void)state;
    struct gates g;
    struct failure why;
    assert_int_equal(gates_collect("reference/*", NULL, 0, &g, &why), STATUS_OK);
    int n = 0;
    while (scenes[n]) n++;
    assert_int_equal(g.declared, n); /* one for every scene */
    gates_free(&g);
    assert_int_equal(gates_collect("reference/rod-setp", NULL, 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "no gate matches 'reference/rod-setp'");
    gates_free(&g);
    assert_int_equal(gates_collect("reference/rod-stp", NULL, 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "did you mean 'reference/rod-step'");
    gates_free(&g);
    assert_int_equal(gates_collect("nosuch*", NULL, 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "--only: no gate matches 'nosuch*' (see: heatladder list gates)");
    gates_free(&g);
    assert_int_equal(gates_collect("walls/cooled", NULL, 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "'walls/cooled' is a row of the battery: --solver or --results is missing");
    gates_free(&g);
}

static void skipped_rows_exist(void **state) {
    (void)state;
    struct gates g;
    struct failure why;
    assert_int_equal(gates_collect("reference/rod-*", "rod-step/*", 0, &g, &why), STATUS_OK); /* others' rows */
    int n = g.declared;
    gates_free(&g);
    assert_int_equal(gates_collect("reference/rod-*", "reference/rod-step", 0, &g, &why), STATUS_OK);
    assert_int_equal(g.declared, n - 1);
    gates_free(&g);
    assert_int_equal(gates_collect(NULL, "reference/rod-setp", 0, &g, &why), STATUS_INPUT);
    assert_non_null(
        strstr(why.text, "--skip: no gate matches 'reference/rod-setp'; did you mean 'reference/rod-step'?"));
    gates_free(&g);
    assert_int_equal(gates_collect("reference/*", "refrence/*", 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "--skip: no gate matches 'refrence/*'; did you mean 'reference/*'?");
    gates_free(&g);
    assert_int_equal(gates_collect("reference/*", "reference/*", 0, &g, &why), STATUS_INPUT);
    assert_has(why.text, "no gate is left");
    gates_free(&g);
}

static void external_runs_are_counted(void **state) {
    (void)state;
    static const struct gate rows[] = {
        {.id = "a", .measure = "slope", .command = "ladder rod-gauss x --dx 1,0.5,0.25"},
        {.id = "b", .measure = "slope", .command = "ladder rod-gauss x --dx 1 --fourier 0.4,0.2"},
        {.id = "c", .measure = "drift", .command = "run rod-gauss x --dx 1"}};
    for (int seeds = 1; seeds <= 2; seeds++) {
        const struct program program = {.solver = "true", .seeds = seeds};
        struct gates g = {.program = &program};
        for (int i = 0; i < 3; i++) gates_add(&g, &rows[i]);
        assert_int_equal(gates_runs(&g), seeds * (3 + 2)); /* the last is a rung of the first */
        gates_free(&g);
    }
}

static void declared_gates_are_executed(void **state) {
    (void)state;
    struct gates g;
    struct failure why;
    assert_int_equal(gates_collect("reference/rod-*", NULL, 0, &g, &why), STATUS_OK);
    assert_int_equal(gates_status(&g), STATUS_GATE); /* none was run */
    gates_run(&g);
    assert_int_equal(g.executed, g.declared);
    assert_int_equal(gates_status(&g), STATUS_OK);
    g.executed--;
    assert_int_equal(gates_status(&g), STATUS_GATE);
    g.executed++;
    g.result[0].executed = 0;
    assert_int_equal(gates_status(&g), STATUS_GATE);
    g.result[0].executed = 1;
    g.result[0].measured.verdict = VERDICT_INCONCLUSIVE;
    assert_int_equal(gates_status(&g), STATUS_INCONCLUSIVE);
    g.result[1].measured.verdict = VERDICT_FAIL;
    assert_int_equal(gates_status(&g), STATUS_GATE); /* a failure is one, whatever else could not tell */
    g.result[1].measured.verdict = VERDICT_PASS;
    g.result[0].measured.verdict = VERDICT_MEASURED;
    assert_int_equal(gates_status(&g), STATUS_GATE);
    gates_free(&g);
    assert_int_equal(gates_status(&(struct gates){0}), STATUS_GATE); /* nothing is not enough */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gate_table_is_valid),          cmocka_unit_test(braces_expand_to_gates),
        cmocka_unit_test(gate_command_runs_as_printed), cmocka_unit_test(globs_select_gates),
        cmocka_unit_test(skipped_rows_exist),           cmocka_unit_test(external_runs_are_counted),
        cmocka_unit_test(declared_gates_are_executed),
    };
    return cmocka_run_group_tests_name("gate_rows", tests, NULL, NULL);
}
