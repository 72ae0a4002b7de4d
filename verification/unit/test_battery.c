/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The battery: correct codes pass it, live and later, and each planted fault is seen by the rows that are there for
 * it. */
#include "verification/unit/control_volumes.inc"

#include "verification/case/command.h"
#include "verification/judge/ladder.h"
#include "verification/solve/program.h"
#include "verification/judge/run.h"

#include "verification/fault/diagnose.h"
#include "verification/gates/ceiling.h"
#include "verification/unit/battery_row.h"
#include "verification/unit/scratch_path.h"

#include <fnmatch.h>
#include <unistd.h>

static const char *self; /* this program */
static char dir[UNIT_PATH];

/* 1 if a code that has only linear conduction in rods and rectangles with walls has the row. */
static int is_box(const char *id) {
    static const char *const others[] = {"round/", "periodic/", "space/", "nonlinear/", "field/", "melt/"};
    for (int k = 0; k < 6; k++)
        if (strncmp(id, others[k], strlen(others[k])) == 0) return 0;
    return 1;
}

/* Number of matching rows with the verdict, answered by this program's code (run as PROGRAM --solve ...).  Without
 * `only`: all but those that these codes do not have (round bodies, k(T), tensors, contacts that resist); of these a
 * first draw has the ones with fast bounds. */
static int count_drawn(unsigned long seed, int order, const char *code, const char *only, enum verdict verdict,
                       int tell) {
    struct program program = {.label = "mine"};
    struct gates g = {.program = &program};
    struct failure why;
    char command[300];
    int n = 0;
    snprintf(command, sizeof command, "%s --solve %s {case} {out}", self, code);
    program.solver = command;
    const char *skip = only   ? (order == 2 ? "*resist*" : NULL)
                       : seed ? "round/*,periodic/*,space/*,nonlinear/*,field/*,melt/*,*resist*"
                              : "round/*,nonlinear/*,field/*,melt/*,*resist*";
    if (battery_add(order, PROFILE_ALL, seed, &g, &why) || gates_choose(&g, only, skip, 0, &why))
        fail_msg("%s", why.text);
    if (battery_bounds(&g, &why)) fail_msg("%s", why.text);
    gates_run(&g);
    for (int i = 0; i < g.declared; i++) {
        const struct measured *m = &g.result[i].measured;
        n += m->verdict == verdict || (tell && m->verdict == VERDICT_SKIPPED && !is_box(g.result[i].gate.id));
        if (tell && m->verdict != verdict && is_box(g.result[i].gate.id))
            print_message("%s, %s: %s\n", code, g.result[i].gate.id, m->reason);
    }
    int left = tell ? g.declared - n : n;
    gates_free(&g);
    return left;
}

static int count(int order, const char *code, const char *only, enum verdict verdict, int tell) {
    return count_drawn(0, order, code, only, verdict, tell);
}

static void correct_codes_pass(void **state) {
    (void)state;
    assert_int_equal(count(2, "cell mean 0.3 none", NULL, VERDICT_PASS, 1), 0);
    assert_int_equal(count(2, "node mean 0.45 none", NULL, VERDICT_PASS, 1), 0);
    assert_int_equal(count(2, "cell mean 0.25 none", "[sjcw]*", VERDICT_PASS, 1), 0); /* F = 1/6 at walls: order 4 */
    assert_int_equal(count(1, "cell point 0.25 wall", "[sjcw]*", VERDICT_PASS, 1),
                     0); /* half a cell off: first order */
    assert_int_equal(count(1, "node point 0.4 jump", "[sjcw]*", VERDICT_PASS, 1), 0);
}

/* Whatever is drawn: the images, scales and parameters of five seeds. */
static void correct_codes_pass_under_any_seed(void **state) {
    (void)state;
    for (unsigned long seed = 1; seed <= 5; seed++)
        assert_int_equal(
            count_drawn(seed, 2, seed % 2 ? "node mean 0.45 none" : "cell mean 0.3 none", NULL, VERDICT_PASS, 1), 0);
    assert_int_equal(count_drawn(1, 1, "node point 0.4 jump", "[sjcw]*", VERDICT_PASS, 1), 0);
}

/* The faults that each row detects, except those that a code cannot have: no face of nodes is on the interface. */
static void planted_faults_fail_a_row(void **state) {
    (void)state;
    static const struct {
        const char *code, *rows;
        int least; /* rows that must not pass */
    } fault[] = {{"cell mean 0.25 step-fewer", "smooth/clock", 1},
                 {"node mean 0.25 step-fewer", "smooth/clock", 1},
                 {"cell point 0.2 step-more", "smooth/clock", 1},
                 {"node mean 0.4 step-more", "smooth/clock", 1},
                 {"cell mean 0.25 last-step", "smooth/clock", 1},
                 {"node mean 0.2 last-step", "smooth/clock", 1},
                 {"cell point 0.2 last-step", "smooth/clock", 1},
                 {"cell mean 0.3 floor", "smooth/clock/2", 1},
                 {"cell mean 0.25 step-fewer", "plane/clock", 1},
                 {"node mean 0.2 step-more", "plane/clock", 1},
                 {"cell mean 0.25 conductivity", "[sw]*[gd]", 1},
                 {"node mean 0.45 conductivity", "walls/*", 2},
                 {"cell mean 0.25 capacity", "contact/[rws]*", 3},
                 {"node mean 0.25 capacity", "contact/[rws]*", 3},
                 {"cell mean 0.25 arithmetic", "contact/[rws]*", 3},
                 {"cell mean 0.25 wall", "walls/cooled", 1},
                 {"node mean 0.25 wall", "walls/*", 2},
                 {"cell mean 0.25 corner", "plane/largest", 1},
                 {"node mean 0.25 corner", "plane/cooled", 1},
                 {"cell mean 0.25 flux-sign", "plane/source", 1},
                 {"cell mean 0.25 swap-k", "plane/s*", 2},
                 {"cell mean 0.25 axes", "plane/s*", 2},
                 {"cell mean 0.25 source", "plane/source", 1},
                 {"cell mean 0.25 frozen", "plane/changing", 1},
                 {"node mean 0.25 frozen", "plane/changing", 1},
                 {"cell mean 0.25 frozen", "driven/[rp]*", 2},
                 {"node mean 0.25 frozen", "driven/rod", 1}, /* a diagnosis in the plane takes seconds */
                 {"cell mean 0.45 late", "driven/rod", 1},
                 {"cell mean 0.25 late", "driven/time", 1},
                 {"cell mean 0.25 interface", "contact/[rws]*", 3},
                 {"node mean 0.25 interface", "contact/[rws]*", 3},
                 {"cell mean 0.25 jump", "jump/*", 2},
                 {"node mean 0.25 jump", "jump/*", 2},
                 {"cell point 0.25 none", "jump/between", 1},
                 {"cell mean 0.25 single", "contact/steady", 1},
                 {"node mean 0.25 single", "contact/steady", 1},
                 {"cell mean 0.25 race", "whole/repeat", 1}};
    int missed = 0;
    for (size_t i = 0; i < sizeof fault / sizeof *fault; i++) {
        struct gates g = {0};
        struct failure why;
        if (battery_add(2, PROFILE_ALL, 0, &g, &why) || gates_choose(&g, fault[i].rows, NULL, 0, &why))
            fail_msg("%s", why.text);
        int seen = g.declared - count(2, fault[i].code, fault[i].rows, VERDICT_PASS, 0);
        if (seen < fault[i].least) missed++, print_message("%s: seen by %d\n", fault[i].code, seen);
        gates_free(&g);
    }
    assert_int_equal(missed, 0);
}

/* The bound of an expression, of the row as it is written and as it is drawn. */
static void bounds_follow_the_draw(void **state) {
    (void)state;
    struct gates g = battery_rows(2, "smooth/gauss,plane/largest"), drawn = {0};
    struct command r;
    struct failure why;
    struct result result;
    if (command_read("run rod-gauss ftcs --set t_end=100 --dx 0.0625", &r, &why) ||
        run_experiment(&r.experiment, &result, NULL))
        fail_msg("%s", why.text);
    /* the ceiling has no error of time; the run has at most 1 % of E1, for which its step is searched */
    assert_near(g.result[0].gate.ceiling, 4 * result.error[NORM_L1], 0.04 * result.error[NORM_L1]);
    command_free(&r);
    if (battery_add(2, PROFILE_ALL, 1, &drawn, &why) ||
        gates_choose(&drawn, "smooth/gauss,plane/largest", NULL, 0, &why) || battery_bounds(&drawn, &why))
        fail_msg("%s", why.text);
    for (int i = 0; i < 2; i++) assert_order(drawn.result[i].gate.ceiling, !=, g.result[i].gate.ceiling);
    gates_free(&g);
    gates_free(&drawn);
}

/* Diagnoses from a single field: differences between two runs, for the row and for any ladder; few digits, in a
 * steady state; a conductivity to 5 % of it if the initial answer identifies cell means; a whole step past the end if
 * that answer has one. */
static void faults_hidden_in_one_field_are_diagnosed(void **state) {
    (void)state;
    static const char *const code[] = {"race", "single", "conductivity", "last-step"},
                             *const rows[] = {"whole/repeat", "contact/steady", "smooth/clock", "smooth/clock"},
                             *const says[] = {"from run to run", "rounded to 7 digits", "end time were 1 % too large",
                                              "stopped late, after the first whole step past t_end"};
    struct program program = {.label = "mine"};
    struct command r;
    struct failure why = {0};
    struct ladder *l = xcalloc(1, sizeof *l);
    struct diagnosis d;
    char line[400], command[300];
    for (int k = 0; k < 4; k++) {
        snprintf(command, sizeof command, "%s --solve cell mean 0.25 %s {case} {out}", self, code[k]);
        program.solver = command;
        struct gates g = battery_rows(2, rows[k]);
        struct measured m;
        gates_judge(&g.result[0].gate, &program, &m);
        if (!strstr(m.diagnosis, says[k])) fail_msg("%s: '%s'", rows[k], m.diagnosis);
        if (m.field.n == 0 || !isfinite(m.due[0])) fail_msg("%s has no picture", rows[k]);
        if (k == 0) assert_near(field_farthest(&m.field, m.due), m.found.size, 0);
        measures_free(&m);
        gates_free(&g);
    }
    snprintf(line, sizeof line,
             "ladder rod-gauss mine --dx 1,0.5 --solver '%s --solve cell mean 0.25 race {case} {out}'", self);
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    r.rungs.diagnose = 1;
    ladder_run(&r.experiment, &r.rungs, l, &why);
    diagnose_ladder(&r.experiment, l, &d);
    assert_has(d.what, says[0]);
    free(d.evidence);
    command_free(&r);
    ladder_free(l);
    free(l);
}

/* Numbers of single precision of at most 1.25 K: half a unit of the last of 7 digits is 5e-7 K. */
static void few_digits_have_a_picture(void **state) {
    (void)state;
    char command[300];
    snprintf(command, sizeof command, "%s --solve cell mean 0.25 single {case} {out}", self);
    struct program program = {.label = "mine", .solver = command};
    struct gate gate = {.measure = "digits", .command = "run rod-cosine mine --dx 1/40", .lo = 8, .hi = 10};
    struct measured m;
    gates_judge(&gate, &program, &m);
    assert_int_equal(m.verdict, VERDICT_FAIL);
    assert_string_equal(m.due_is, "T to 7 digits");
    assert_near(m.due_scale, 5e-7, 1e-20);
    assert_int_equal(m.field.n, 40);
    assert_near(field_farthest(&m.field, m.due), 0, 0);
    measures_free(&m);
}

/* The cases of `case --battery` are complete, and their answers get the verdicts of a live run. */
static void written_cases_and_live_runs_agree(void **state) {
    (void)state;
    struct program program = {.label = "mine", .results = dir};
    struct gates written = {0}, g = {.program = &program};
    struct failure why = {0};
    char path[UNIT_PATH + 200], command[400], line[300];
    int cases, lines = 0;
    if (battery_add(2, PROFILE_ALL, 0, &written, &why) ||
        gates_choose(&written, "[sjcw]*", "whole/repeat,space/*,*resist*", 0, &why) ||
        battery_write(&written, 0, dir, &cases, &why))
        fail_msg("%s", why.text);
    gates_free(&written);
    snprintf(command, sizeof command,
             "while read d; do %s --solve node mean 0.3 none $d/case $d/out.csv || exit 1; done "
             "<%s/cases.txt",
             self, dir);
    assert_int_equal(system(command), 0);
    snprintf(path, sizeof path, "%s/cases.txt", dir);
    FILE *list = fopen(path, "r");
    while (fgets(line, sizeof line, list)) lines++;
    fclose(list);
    assert_order(lines, >, 20);
    assert_int_equal(cases, lines);
    if (battery_add(2, PROFILE_ALL, 0, &g, &why) ||
        gates_choose(&g, "[sjcw]*", "whole/repeat,space/*,*resist*", 0, &why) || battery_bounds(&g, &why))
        fail_msg("%s", why.text);
    gates_run(&g);
    for (int i = 0; i < g.declared; i++)
        if (g.result[i].measured.verdict != VERDICT_PASS)
            fail_msg("%s: %s", g.result[i].gate.id, g.result[i].measured.reason);
    assert_int_equal(gates_status(&g), STATUS_OK);
    gates_free(&g);
}

/* The exact solution with an error in space only: the program's own steps are not judged. */
static void own_time_steps_are_skipped(void **state) {
    (void)state;
    struct program program = {.label = "mine",
                              .solver = "awk -v error=floor -f verification/unit/stand_in.awk {case} >{out}"};
    struct gates g = battery_rows(2, "whole/time");
    struct measured m;
    gates_judge(&g.result[0].gate, &program, &m);
    assert_int_equal(m.verdict, VERDICT_SKIPPED);
    measures_free(&m);
    gates_free(&g);
}

/* Midpoint steps are of second order with the data of the middle, of first order with the data of the start. */
static void judge_steps(const char *row) {
    static const char *const code[] = {"midpoint", "stale"};
    for (int k = 0; k < 2; k++)
        for (unsigned long seed = 1; seed <= 3; seed++) {
            char command[300];
            snprintf(command, sizeof command, "%s --solve cell mean 0.25 %s {case} {out}", self, code[k]);
            struct program program = {.label = "mine", .solver = command};
            struct gates g = {.program = &program};
            struct failure why;
            if (battery_add(2, PROFILE_ALL, seed, &g, &why) || gates_choose(&g, row, NULL, 0, &why) ||
                battery_bounds(&g, &why))
                fail_msg("%s", why.text);
            gates_refine(&g, 0, 2);
            gates_run(&g);
            assert_int_equal(g.result[0].measured.verdict, k ? VERDICT_FAIL : VERDICT_PASS);
            assert_near(g.result[0].measured.value, k ? 1 : 2, 0.1);
            gates_free(&g);
        }
}

static void data_of_the_start_lose_an_order_in_time(void **state) {
    (void)state;
    judge_steps("whole/source");
    judge_steps("driven/time");
}

/* Ceilings are 4 times the error of the five-point difference on the same draw, 5 to 6 times with the Euler steps of
 * a source that depends on time, 6 to 7 times with the half cell at a wall that changes, 6 times where fluxes of k_xy
 * may be at corners.  Round bodies take long: one seed. */
static void ceilings_follow_the_five_point_difference(void **state) {
    (void)state;
    for (unsigned long seed = 1; seed <= 3; seed++) {
        const char *skip = seed > 1 ? "*/box,space/*,nonlinear/*,melt/*,round/*" : "*/box,space/*,nonlinear/*,melt/*";
        struct gates g = {0};
        struct failure why;
        if (battery_add(2, PROFILE_ALL, seed, &g, &why) || gates_choose(&g, NULL, skip, 0, &why) ||
            battery_bounds(&g, &why))
            fail_msg("%s", why.text);
        for (int i = 0; i < g.declared; i++) {
            const struct gate *gate = &g.result[i].gate;
            int linf = strcmp(gate->measure, "order_linf") == 0, faces = strcmp(gate->id, "jump/between") == 0;
            if (strncmp(gate->measure, "order", 5) != 0 || strcmp(gate->id, "whole/flux") == 0) continue;
            struct experiment e = gates_finest(g.result[i].read);
            double five = faces ? ceiling_five_point_on_faces(&e) : ceiling_five_point(&e, linf);
            double most = strcmp(gate->id, "plane/changing") == 0 ? 6
                          : strcmp(gate->id, "driven/rod") == 0   ? 7.5
                          : e.problem.cross[0] != 0               ? 6 * (1 + 1e-9)
                                                                  : 4 * (1 + 1e-9);
            double ratio = gate->ceiling / five;
            if (!(ratio >= 1 && ratio <= most)) fail_msg("%s, seed %lu: %g times", gate->id, seed, ratio);
        }
        gates_free(&g);
    }
}

/* The command beside a failure shows it. */
static void printed_command_repeats_a_failure(void **state) {
    (void)state;
    struct program program = {.timeout = 100};
    char command[GATES_COMMAND], solver[300];
    snprintf(solver, sizeof solver, "%s --solve cell mean 0.25 'arithmetic' {case} {out}", self);
    program.solver = solver;
    struct gates g = battery_rows(2, "contact/wall");
    struct command r;
    struct failure why = {0};
    struct ladder *l = xcalloc(1, sizeof *l);
    gates_command(&g.result[0].gate, &program, command, sizeof command);
    assert_has(command, "--solve cell mean 0.25 '\\''arithmetic'\\'' {case}");
    for (char *c; (c = strstr(command, "'\\''"));) memmove(c, c + 4, strlen(c + 4) + 1); /* as a shell reads it */
    if (command_read(command, &r, &why)) fail_msg("%s: %s", command, why.text);
    ladder_run(&r.experiment, &r.rungs, l, &why);
    assert_int_equal(l->verdict, VERDICT_FAIL);
    command_free(&r);
    ladder_free(l);
    free(l);
    gates_free(&g);
}

/* Each order has a band, a measure, a reason and an id of its own, and time steps that divide the end time, since a
 * step other than the requested one has another error than its order predicts. */
static void battery_rows_are_valid(void **state) {
    (void)state;
    for (int order = 1; order <= 4; order *= 2) {
        struct gates all = battery_rows(order, NULL);
        for (int i = 0; i < all.declared; i++) {
            const struct gate *g = &all.result[i].gate;
            const struct command *c = all.result[i].read;
            struct measured m;
            for (int k = 0; k < c->rungs.dt.count; k++) {
                double steps = c->experiment.problem.t_end / c->rungs.dt.value[k];
                if (fabs(steps - nearbyint(steps)) > 1e-9 * steps) fail_msg("%s: %g steps", g->id, steps);
            }
            assert_non_null(measures_find(g->measure, &m));
            assert_order(g->lo, <, g->hi);
            assert_int_equal(strncmp(g->why, "detects ", 8), 0);
            for (int k = 0; k < i; k++) assert_string_not_equal(all.result[k].gate.id, g->id);
        }
        gates_free(&all);
    }
}

/* Rows that a profile leaves out. */
static void a_profile_has_rows_of_its_own(void **state) {
    (void)state;
    int rows[2], periodic[2] = {0};
    for (int profile = 0; profile < 2; profile++) {
        struct gates g = {0};
        struct failure why;
        if (battery_add(2, (enum profile)profile, 1, &g, &why)) fail_msg("%s", why.text);
        rows[profile] = g.declared;
        for (int i = 0; i < g.declared; i++)
            periodic[profile] +=
                strncmp(g.result[i].gate.id, "periodic/", 9) == 0 || strcmp(g.result[i].gate.id, "space/smooth") == 0;
        gates_free(&g);
    }
    assert_int_equal(rows[PROFILE_PARTICLES], periodic[PROFILE_ALL]);
    assert_order(rows[PROFILE_ALL], >, periodic[PROFILE_ALL]);
    assert_order(periodic[PROFILE_ALL], >, 0);
}

static struct gate refined(const char *command, double lo, const char *measure, int rungs, double time_order,
                           char text[400]) {
    struct gate gate = {.id = "a/b", .measure = measure, .command = command, .lo = lo, .hi = 2.9, .ceiling = 0.064};
    struct gates g = {0};
    gates_add(&g, &gate);
    gates_refine(&g, rungs, time_order);
    gate = g.result[0].gate;
    snprintf(text, 400, "%s", gate.command);
    gates_free(&g);
    return gate;
}

/* Further rungs by halving, and a ceiling that falls as the order does. */
static void rungs_are_added_by_halving(void **state) {
    (void)state;
    char text[400];
    struct gate g = refined("ladder s mine --dx 0.1,0.05,1/30,0.025 --set a=1", 1.5, "order", 6, 0, text);
    assert_string_equal(text, "ladder s mine --dx 0.1,0.05,1/30,0.025,0.025/2,0.025/4 --set a=1");
    assert_near(g.ceiling, 0.064 / 16, 1e-15);
    g = refined("ladder s mine --dx 0.3/15,0.3/60", 0.5, "order", 3, 0, text);
    assert_string_equal(text, "ladder s mine --dx 0.3/15,0.3/60,0.3/120");
    assert_near(g.ceiling, 0.064 / 2, 1e-15);
    g = refined("ladder s mine --dx 0.05 --dt 1/16,1/32", 0.9, "slope_time", 3, 2, text);
    assert_string_equal(text, "ladder s mine --dx 0.05 --dt 1/16,1/32,1/64");
    assert_near(g.ceiling, 0.064 / 2, 1e-15);
    assert_near(g.lo, 1.8, 1e-15);
    assert_near(g.hi, 2.5, 1e-15);
    g = refined("ladder s mine --dx 1,0.5", 1.5, "order", 2, 2, text);
    assert_string_equal(text, "ladder s mine --dx 1,0.5");
    assert_near(g.ceiling, 0.064, 0);
    assert_near(g.lo, 1.5, 0);
    g = refined("run s mine --dx 0.05", 0, "error", 9, 1, text);
    assert_string_equal(text, "run s mine --dx 0.05");
}

static int make(void **state) {
    (void)state;
    return scratch_directory(dir, "battery-test") == NULL;
}

static int clean(void **state) {
    char command[UNIT_PATH + 32];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
}

int main(int argc, char **argv) {
    self = argv[0];
    if (argc == 8 && strcmp(argv[1], "--solve") == 0) return volumes_main(argv, (int)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(correct_codes_pass),
        cmocka_unit_test(correct_codes_pass_under_any_seed),
        cmocka_unit_test(planted_faults_fail_a_row),
        cmocka_unit_test(data_of_the_start_lose_an_order_in_time),
        cmocka_unit_test(ceilings_follow_the_five_point_difference),
        cmocka_unit_test(bounds_follow_the_draw),
        cmocka_unit_test(faults_hidden_in_one_field_are_diagnosed),
        cmocka_unit_test(few_digits_have_a_picture),
        cmocka_unit_test(written_cases_and_live_runs_agree),
        cmocka_unit_test(own_time_steps_are_skipped),
        cmocka_unit_test(printed_command_repeats_a_failure),
        cmocka_unit_test(battery_rows_are_valid),
        cmocka_unit_test(a_profile_has_rows_of_its_own),
        cmocka_unit_test(rungs_are_added_by_halving),
    };
    return cmocka_run_group_tests_name("battery", tests, make, clean);
}
