/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --solver: the FTCS of ftcs.awk in place of a method, right, wrong and without an answer. */
#include "verification/solve/program.h"

#include "verification/case/command.h"
#include "verification/judge/run.h"

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
static void the_same_scheme_gives_the_same_errors(void **state) {
    (void)state;
    struct result mine, ours;
    assert_int_equal(run_line("run rod-step mine --dx 0.1 --set kappa=0.013 --set a=0.6 --fourier 0.4" MINE, &mine),
                     0);
    assert_int_equal(run_line("run rod-step ftcs --dx 0.1 --set kappa=0.013 --set a=0.6 --fourier 0.4", &ours), 0);
    assert_int_equal(mine.particles, ours.particles);
    assert_int_equal(mine.steps, ours.steps);
    assert_near(mine.error[NORM_L1], ours.error[NORM_L1], 1e-13);
    assert_near(mine.error[NORM_LINF], ours.error[NORM_LINF], 1e-12);
    assert_near(mine.cost.step_seconds, 0.25, 0); /* printed by the program */
}

static void failures_are_named(void **state) {
    (void)state;
#define RUN(command) "run rod-gauss mine --dx 1 --fourier 0.4 --solver '" command "'"
    refused(RUN("true {case} {out}"), STATUS_NUMERICAL, "exit status 0, but no answer at {out}");
    refused(RUN("cat {case} >/dev/null; : > {out}"), STATUS_NUMERICAL, "empty");
    refused(RUN(": {case}; echo x,T > {out}"), STATUS_NUMERICAL, "no point");
    refused(RUN(AWK " {case} | sed 's/,[^T].*/,1e308/' > {out}"), STATUS_UNSTABLE, "overflow");
    refused(RUN(AWK " -v bad=header {case} > {out}"), STATUS_NUMERICAL,
            "{out}, line 4: 1 column where the lines above have 2");
    refused(RUN(AWK " -v bad=word {case} > {out}"), STATUS_NUMERICAL,
            "line 31, column 2 (T): 'warm' is not a decimal number");
    refused(RUN(AWK " -v bad=nan {case} > {out}"), STATUS_NUMERICAL,
            "line 31, column 2 (T): 'nan' is not a finite number");
    refused(RUN("exit 7; {case} {out}"), STATUS_NUMERICAL, "exit status 7");
    refused(RUN("/no/such/program {case} {out} 2>/dev/null"), STATUS_INPUT, "could not be run");
    refused(RUN("kill -9 $$; {case} {out}"), STATUS_NUMERICAL, "signal 9");
    refused(RUN(": {case}; printf \"x,T\\n99,0\\n\" > {out}"), STATUS_NUMERICAL, "x = 99 m: x is outside");
    refused(RUN(AWK " {case} | head -n 20 > {out}"), STATUS_NUMERICAL,
            "17 points where dx = 1 m asks for 29 at least");
    refused(RUN("exit 77; {case} {out}"), STATUS_SKIPPED, "not applicable");
    refused(RUN("ln -s /etc/passwd {out}; : {case}"), STATUS_NUMERICAL, "a link");
    refused(RUN("mkdir {out}; : {case}"), STATUS_NUMERICAL, "a directory");
    refused(RUN("true {case}"), STATUS_INPUT, "must contain {case} and {out}");
#undef RUN
}

/* The program skips the case, with status 77, if the line is there. */
static void the_case_file_has_sides_materials_and_sources(void **state) {
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

/* The axes of the case are -y and x of the scene, its temperature 2 T - 7. */
static void an_answer_is_mapped_back_to_the_case(void **state) {
    (void)state;
    struct program g = {0};
    double x[] = {3, -2}, y[] = {5, 0.5}, T[] = {1, 4}, exact[] = {1.5, 4.5};
    struct field f = {.dim = 2, .n = 2, .x = {x, y}, .T = T};
    assert_int_equal(mapping_read("-y,x", &g.map), 0);
    g.map.scale = 2, g.map.offset = -7;
    struct field given = program_as_given(&g, &f, exact);
    for (int i = 0; i < 2; i++) {
        assert_near(given.x[0][i], -y[i], 0);
        assert_near(given.x[1][i], x[i], 0);
        assert_near(given.T[i], 2 * T[i] - 7, 0);
        assert_near(exact[i], 2 * (i ? 4.5 : 1.5) - 7, 0);
    }
    field_free(&given);
}

static void a_program_ends_with_its_children_and_in_time(void **state) {
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
            "00 | so far"); /* more than a pipe holds, 64 KiB */
    dup2(shown, STDERR_FILENO);
    close(shown);
    close(nowhere);
#undef RUN
}

/* How Rust, Python, Fortran and Java say why they ended. */
static void the_reason_of_a_program_is_quoted(void **state) {
    (void)state;
#define FAILS(text)                                                                                                  \
    "run rod-gauss mine --dx 1 --fourier 0.4 --solver 'printf \"1\n2\n3\n" text "\"; exit 1; {case} {out}'"
    refused(FAILS("thread main panicked at a.rs:2:5:\nindex out of bounds\nnote: run with RUST_BACKTRACE\n"),
            STATUS_NUMERICAL,
            "it said last: thread main panicked at a.rs:2:5: | index out of bounds | note: run with ");
    refused(FAILS("Traceback (most recent call last):\n  File a.py, line 7\n    f()\nValueError: T\n"),
            STATUS_NUMERICAL, "it said last: 3 | Traceback (most recent call last): | ValueError: T");
    refused(FAILS("At line 3 of file a.f90\nFortran runtime error: End of file\n\nError termination. Backtrace:\n"
                  "#0  0x7f in f\n#1  0x7f in g\n"),
            STATUS_NUMERICAL,
            "At line 3 of file a.f90 | Fortran runtime error: End of file | Error termination. Backtr");
    refused(
        FAILS(" diverged\nException in thread main java.lang.Error: T\n\tat A.f(A.java:3)\n\tat A.main(A.java:9)\n"),
        STATUS_NUMERICAL, "it said last: 3 | diverged | Exception in thread main java.lang.Error: T");
#undef FAILS
}

static void scratch_files_are_removed(void **state) {
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

static void signals_end_the_program_and_remove_its_files(void **state) {
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    char dir[UNIT_PATH];
    assert_non_null(scratch_directory(dir, "program-test"));
    for (int i = 0; i < 3; i++) {
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_scheme_gives_the_same_errors),
        cmocka_unit_test(failures_are_named),
        cmocka_unit_test(the_case_file_has_sides_materials_and_sources),
        cmocka_unit_test(an_answer_is_mapped_back_to_the_case),
        cmocka_unit_test(a_program_ends_with_its_children_and_in_time),
        cmocka_unit_test(the_reason_of_a_program_is_quoted),
        cmocka_unit_test(scratch_files_are_removed),
        cmocka_unit_test(signals_end_the_program_and_remove_its_files),
    };
    return cmocka_run_group_tests_name("program", tests, NULL, NULL);
}
