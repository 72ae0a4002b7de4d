/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --solver: an FTCS written in awk stands in for a method, and must be seen as ours is: where it is right, where it
 * is wrong, and where it does not answer. */
#include "verification/foreign/program.h"

#include "verification/ladder/command.h"
#include "verification/foreign/process.h"
#include "verification/foreign/scratch.h"
#include "verification/gates/gates.h"
#include "verification/ladder/ladder.h"
#include "verification/run/run.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <fcntl.h>
#include <glob.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <sys/wait.h>
#include <unistd.h>

#define AWK "awk -f verification/unit/ftcs.awk"
#define MINE " --solver '" AWK " {case} > {out}'"

static int run_line(const char *line, struct result *result) {
    struct command r;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    int status = run_experiment(&r.experiment, result, NULL);
    command_free(&r);
    return status;
}

static void refused(const char *line, int status, const char *because) {
    struct result result;
    assert_int_equal(run_line(line, &result), status);
    if (!strstr(result.failure.text, because)) fail_msg("%s: %s", line, result.failure.text);
}

/* The same scheme on the same points gives the same field, to rounding. */
static void agrees_with_our_own(void **state) {
    (void)state;
    struct result mine, ours;
    assert_int_equal(run_line("run rod-step mine --dx 0.1 --set kappa=0.013 --set a=0.6 --fourier 0.4" MINE, &mine),
                     0);
    assert_int_equal(run_line("run rod-step ftcs --dx 0.1 --set kappa=0.013 --set a=0.6 --fourier 0.4", &ours), 0);
    assert_int_equal(mine.particles, ours.particles);
    assert_int_equal(mine.steps, ours.steps);
    assert_near(mine.error.l1, ours.error.l1, 1e-13);
    assert_near(mine.error.linf, ours.error.linf, 1e-12);
    assert_near(mine.cost.step_seconds, 0.25, 0); /* as the program says */
}

static void its_order_is_judged(void **state) {
    (void)state;
    struct gate gate = {.id = "mine", .measure = "slope", .lo = 1.9, .hi = 2.1, .ceiling = 1.63e-4, .why = ""};
    struct measured m;
    gate.command = "ladder rod-gauss mine --set kappa=0.4 --fourier 0.4 --dx 1,0.5,0.25,0.2,0.125" MINE;
    gates_judge(&gate, NULL, &m);
    if (m.verdict != VERDICT_PASS) fail_msg("%s", m.reason);
}

/* Errors made to measure, each of which the interval of a line through all rungs lets pass as second order. */
static void a_made_up_error_does_not_pass(void **state) {
    (void)state;
    static const struct {
        const char *error, *dx;
        enum verdict verdict;
        const char *said;
    } made[] = {
        /* a quarter of the finest error is a floor; at ratios of some 1.4, and of some 1.2 */
        {"floor", "1/10,1/14,1/20,1/28,1/40,1/57,1/80,1/113,1/160,1/226,1/320", VERDICT_FAIL, "2 finest rungs"},
        {"floor",
         "1/10,1/12,1/14,1/17,1/21,1/25,1/30,1/36,1/43,1/52,1/62,1/74,1/89,1/107,1/128,1/154,1/185,1/222,1/266,1/319",
         VERDICT_FAIL, "2 finest rungs"},
        {"exponential", "10/100,10/101,10/102,10/103 --set L=10", VERDICT_INCONCLUSIVE, "span a factor of 1.03"},
        {"stall", "1/10,1/20,1/40,1/80,1/160,1/320,1/640,1/1280,1/2560,1/5120", VERDICT_FAIL, "does not fall"}};
    for (int k = 0; k < 4; k++) {
        char line[512];
        struct command r;
        struct failure why;
        struct ladder *l = xcalloc(1, sizeof *l);
        snprintf(line, sizeof line,
                 "ladder rod-cosine odd --dx %s --solver 'awk -v error=%s -f verification/unit/stand_in.awk {case} > "
                 "{out}' "
                 "--expect 1.9,2.1",
                 made[k].dx, made[k].error);
        if (command_read(line, &r, &why)) fail_msg("%s", why.text);
        assert_int_equal(ladder_run(&r.experiment, &r.rungs, l, &why), STATUS_OK);
        assert_near(l->rung[0].dt, 0, 0); /* it has told of no steps */
        if (l->verdict != made[k].verdict || !strstr(l->reason, made[k].said))
            fail_msg("%s: %s: %s", made[k].error, verdict_words[l->verdict], l->reason);
        command_free(&r);
        free(l);
    }
}

/* A wrong factor in kappa does not fall with dx. */
static void a_wrong_conductivity_is_caught(void **state) {
    (void)state;
    struct gate gate = {.id = "mine", .measure = "slope", .lo = 1.9, .hi = 2.1, .ceiling = 1.63e-4, .why = ""};
    struct measured m;
    gate.command = "ladder rod-gauss mine --set kappa=0.4 --fourier 0.2 --dx 1,0.5,0.25,0.2,0.125 --solver '" AWK
                   " -v wrong=2 {case} > {out}'";
    gates_judge(&gate, NULL, &m);
    assert_int_equal(m.verdict, VERDICT_FAIL);
    assert_has(m.reason, "above its ceiling");
}

/* A diagnosis is made of the two finest rungs: those above them change nothing. */
static void a_diagnosis_is_of_the_two_finest_rungs(void **state) {
    (void)state;
    static const char *const dx[] = {"0.05,0.025", "0.2,0.1,0.05,0.025"};
    struct diagnosis found[2];
    for (int k = 0; k < 2; k++) {
        char line[300];
        struct command r;
        struct failure why;
        struct ladder *l = xcalloc(1, sizeof *l);
        snprintf(line, sizeof line,
                 "ladder rod-step mine --fourier 0.2 --dx %s --solver '" AWK " -v wrong=1.2 {case} > {out}'", dx[k]);
        if (command_read(line, &r, &why)) fail_msg("%s", why.text);
        r.rungs.diagnose = 1;
        assert_int_equal(ladder_run(&r.experiment, &r.rungs, l, &why), STATUS_OK);
        assert_int_equal(l->diagnosed, 1);
        found[k] = l->diagnosis;
        command_free(&r);
        free(l);
    }
    assert_int_equal(found[0].named, 1);
    assert_string_equal(found[0].what, found[1].what);
    assert_near(found[0].size, found[1].size, 0);
    assert_near(found[0].share, found[1].share, 0);
}

static void what_is_wrong_is_named(void **state) {
    (void)state;
#define RUN(command) "run rod-gauss mine --dx 1 --fourier 0.4 --solver '" command "'"
    refused(RUN("true {case} {out}"), STATUS_INPUT, "no such file; the program left no answer");
    refused(RUN("cat {case} >/dev/null; : > {out}"), STATUS_INPUT, "empty");
    refused(RUN(": {case}; echo x,T > {out}"), STATUS_INPUT, "no point");
    refused(RUN(AWK " {case} | sed 's/,[^T].*/,1e308/' > {out}"), STATUS_NUMERICAL, "E1 = inf");
    refused(RUN(AWK " -v bad=header {case} > {out}"), STATUS_INPUT,
            "{out}, line 4: 1 column where the lines above have 2");
    refused(RUN(AWK " -v bad=word {case} > {out}"), STATUS_INPUT,
            "line 31, column 2: T = 'warm' is not a decimal number");
    refused(RUN(AWK " -v bad=nan {case} > {out}"), STATUS_NUMERICAL, "line 31, column 2: T = nan is not finite");
    refused(RUN("exit 7; {case} {out}"), STATUS_NUMERICAL, "exit status 7");
    refused(RUN("/no/such/program {case} {out} 2>/dev/null"), STATUS_INPUT, "could not be run");
    refused(RUN("kill -9 $$; {case} {out}"), STATUS_NUMERICAL, "signal 9");
    refused(RUN(": {case}; printf \"x,T\\n99,0\\n\" > {out}"), STATUS_INPUT, "x = 99 m is outside");
    refused(RUN(AWK " {case} | head -n 20 > {out}"), STATUS_INPUT, "17 points where dx = 1 m asks for 29 at least");
    refused(RUN("exit 77; {case} {out}"), STATUS_SKIPPED, "not applicable");
    refused(RUN("ln -s /etc/passwd {out}; : {case}"), STATUS_INPUT, "a link");
    refused(RUN("mkdir {out}; : {case}"), STATUS_INPUT, "a directory");
    refused(RUN("true {case}"), STATUS_INPUT, "must contain {case} and {out}");
#undef RUN
}

static void the_label_is_free_and_options_of_the_model_are_not(void **state) {
    (void)state;
    struct command r;
    struct failure why;
    assert_int_equal(command_read("run rod-step any.name --dx 0.1 --solver 'x {case} {out}'", &r, &why), 0);
    assert_string_equal(r.experiment.method->name, "any.name");
    command_free(&r);
    assert_int_equal(command_read("run rod-step mine --dx 0.1", &r, &why), STATUS_INPUT);
    command_free(&r);
    assert_int_equal(command_read("run rod-step --dx 0.1 --solver=x", &r, &why), STATUS_INPUT);
    command_free(&r);
    assert_int_equal(command_read("run rod-step mine --kernel cubic --dx 0.1 --solver=x", &r, &why),
                     STATUS_INPUT);
    assert_has(why.text, "--kernel has no meaning for mine");
    command_free(&r);
}

/* Two dimensions, two materials, sides that vary: all of it is in the case file, on which the last line of each
 * command's output depends. */
static void the_case_file_tells_all(void **state) {
    (void)state;
#define CASE(scene, text)                                                                                            \
    refused("run " scene " --solver 'grep -qx \"" text "\" {case} && exit 77; {out}'", STATUS_SKIPPED, "77")
    CASE("plate mine --dx 0.01 --set material=titanium", "side_x_hi = dirichlet, 0.5");
    CASE("plate mine --dx 0.01 --set material=titanium", "param_material = titanium");
    CASE("plate mine --dx 0.01 --set height=0.05", "cells = 10, 5");
    CASE("rod-contact mine --dx 0.1", "interface = .*");
    CASE("rod-contact mine --dx 0.1", "k_x = .*, .*");
    CASE("rod-contact mine --dx 0.1 --set L=1.5", "oracle = rod-contact .*--set L=1.5 .*");
    CASE("rect-manufactured mine --dx 0.1", "source = yes");
    CASE("rect-manufactured mine --dx 0.1 --set rise=1", "source = changing");
    CASE("rect-manufactured mine --dx 0.1", "side_.* = neumann, .*, .*");
#undef CASE
}

/* Points of the scene, temperatures and exact ones, in the axes and the scale of a case whose x is y of the scene
 * against its direction. */
static void a_field_is_handed_back_as_it_came(void **state) {
    (void)state;
    struct program g = {0};
    double x[] = {3, -2}, y[] = {5, 0.5}, T[] = {1, 4}, exact[] = {1.5, 4.5};
    struct field f = {.dim = 2, .n = 2, .x = x, .y = y, .T = T};
    assert_int_equal(mapping_read("-y,x", &g.map), 0);
    g.map.scale = 2, g.map.offset = -7;
    struct field given = program_as_given(&g, &f, exact);
    for (int i = 0; i < 2; i++) {
        assert_near(given.x[i], -y[i], 0);
        assert_near(given.y[i], x[i], 0);
        assert_near(given.T[i], 2 * T[i] - 7, 0);
        assert_near(exact[i], 2 * (i ? 4.5 : 1.5) - 7, 0);
    }
    field_free(&given);
}

/* All that a program starts ends with it, what it leaves is removed, and interrupts are heard at once. */
static void it_ends_in_time(void **state) {
    (void)state;
#define RUN(more, command) "run rod-gauss mine --dx 1 --fourier 0.4 " more " --solver '" command "'"
    refused(RUN("--timeout 0.2", "sleep 50 & sleep 50; {case} {out}"), STATUS_NUMERICAL,
            "not done after 0.2 s (--timeout)");
    refused(RUN("", "echo so far; exit 3; {case} {out}"), STATUS_NUMERICAL, "exit status 3; it said last: so far");
    refused(RUN("", "(sleep 50; " AWK " {case} > {out}) & true"), STATUS_NUMERICAL,
            "ended before what it had started");
    int shown = dup(STDERR_FILENO), nowhere = open("/dev/null", O_WRONLY);
    assert_true(shown >= 0 && dup2(nowhere, STDERR_FILENO) >= 0);
    refused(RUN("--timeout 60", "printf \"%090000d\\n\" 1; echo so far; exit 3; {case} {out}"), STATUS_NUMERICAL,
            "exit status 3; it said last: so far"); /* more than a pipe holds, 64 KiB */
    dup2(shown, STDERR_FILENO);
    close(shown);
    close(nowhere);
#undef RUN
}

static void nothing_is_left_behind(void **state) {
    (void)state;
    char dir[UNIT_PATH], pattern[UNIT_PATH + 64];
    struct result result;
    glob_t found;
    assert_non_null(scratch_directory(dir, "external-test"));
    assert_int_equal(setenv("TMPDIR", dir, 1), 0);
    assert_int_equal(run_line("run rod-step mine --dx 0.1 --fourier 0.4" MINE, &result), 0);
    refused("run rod-step mine --dx 0.1 --solver 'echo x > {out}; exit 3; {case}'", STATUS_NUMERICAL, "status 3");
    refused(
        "run rod-step mine --dx 0.1 --solver 'cd $TMPDIR && mkdir -p a/b && echo x > a/b/c && chmod 0 a && exit 4; "
        "{case} {out}'",
        STATUS_NUMERICAL, "status 4");
    unsetenv("TMPDIR");
    snprintf(pattern, sizeof pattern, "%s/*", dir);
    assert_int_equal(glob(pattern, 0, NULL, &found), GLOB_NOMATCH);
    assert_int_equal(remove(dir), 0);
}

/* Waits until the number of directories in `dir` is `wanted`; 0, or -1 after ten seconds. */
static int wait_for(const char *dir, size_t wanted) {
    char pattern[UNIT_PATH + 8];
    snprintf(pattern, sizeof pattern, "%s/*", dir);
    for (int i = 0; i < 1000; i++) {
        glob_t found = {0};
        size_t n = glob(pattern, 0, NULL, &found) ? 0 : found.gl_pathc;
        globfree(&found);
        if (n == wanted) return 0;
        nanosleep(&(struct timespec){0, 10000000}, NULL);
    }
    return -1;
}

/* An interrupt is heard while the program runs, and nothing is left; nor where nothing can be heard any more. */
static void signals_leave_nothing(void **state) {
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGKILL};
    char dir[UNIT_PATH];
    assert_non_null(scratch_directory(dir, "program-test"));
    for (int i = 0; i < 4; i++) {
        int status;
        pid_t child = fork();
        assert_order(child, >=, 0);
        if (child == 0) {
            struct result result;
            signal(signals[i], SIG_DFL);
            setenv("TMPDIR", dir, 1);
            run_line("run rod-gauss mine --dx 1 --solver 'sleep 60 & sleep 60; {case} {out}'", &result);
            _exit(0);
        }
        assert_int_equal(wait_for(dir, 1), 0);
        kill(child, signals[i]);
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), signals[i]);
        assert_int_equal(wait_for(dir, 0), 0);
    }
    assert_int_equal(remove(dir), 0);
}

/* Who is told of the program's process group is told by the program: that nobody listens is its failure, not ours. */
static void a_guard_that_is_gone_ends_nobody_else(void **state) {
    (void)state;
    struct failure why = {0};
    struct scratch scratch;
    int code;
    struct process process = {.command = "exit 0", .label = "it", .scratch = &scratch, .code = &code};
    assert_int_equal(scratch_open(&scratch, &why), STATUS_OK);
    kill(scratch.guard, SIGKILL);
    waitpid(scratch.guard, NULL, 0);
    signal(SIGPIPE, SIG_DFL);
    assert_int_equal(process_run(&process, &why), STATUS_NUMERICAL);
    assert_int_equal(remove(scratch.dir), 0);
    close(scratch.pipe);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_our_own),
        cmocka_unit_test(its_order_is_judged),
        cmocka_unit_test(a_made_up_error_does_not_pass),
        cmocka_unit_test(a_wrong_conductivity_is_caught),
        cmocka_unit_test(a_diagnosis_is_of_the_two_finest_rungs),
        cmocka_unit_test(what_is_wrong_is_named),
        cmocka_unit_test(the_label_is_free_and_options_of_the_model_are_not),
        cmocka_unit_test(the_case_file_tells_all),
        cmocka_unit_test(a_field_is_handed_back_as_it_came),
        cmocka_unit_test(it_ends_in_time),
        cmocka_unit_test(nothing_is_left_behind),
        cmocka_unit_test(signals_leave_nothing),
        cmocka_unit_test(a_guard_that_is_gone_ends_nobody_else),
    };
    return cmocka_run_group_tests_name("program", tests, NULL, NULL);
}
