/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files in memory: there whole, or not at all, and several together. */
#include "verification/text/output.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/judge/command_run.h"
#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif

static void assert_text(const char *path, const char *expected) {
    char text[80] = "";
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    size_t n = fread(text, 1, sizeof text - 1, in);
    fclose(in);
    text[n] = '\0';
    assert_string_equal(text, expected);
}

static void file_appears_when_closed(void **state) {
    (void)state;
    char dir[UNIT_PATH], path[UNIT_PATH + 64];
    struct failure why;
    struct output page;
    assert_non_null(scratch_directory(dir, "test_output"));
    snprintf(path, sizeof path, "%s/%d.csv", dir, 7);
    FILE *out = output_open(&page, "%s/%d.csv", dir, 7);
    fprintf(out, "x,T\n%g,%g\n", 0.31, 2.385);
    assert_int_equal(access(path, F_OK), -1); /* nothing before it is closed */
    output_end(&page);
    assert_string_equal(page.text, "x,T\n0.31,2.385\n");
    assert_int_equal(output_close(&page, 1, &why), STATUS_OK);
    assert_text(path, "x,T\n0.31,2.385\n");
    output_open(&page, "%s/8.csv", dir);
    output_drop(&page, 1);
    unlink(path);
    assert_int_equal(rmdir(dir), 0);
}

static void files_of_one_set_appear_together_or_not_at_all(void **state) {
    (void)state;
    char dir[UNIT_PATH];
    struct failure why = {0};
    struct output page[2] = {0};
    assert_non_null(scratch_directory(dir, "test_output"));
    output_open(&page[0], "%s/one", dir);
    output_open(&page[1], "%s/nowhere/two", dir);
    assert_int_equal(output_close(page, 2, &why), STATUS_INPUT);
    assert_has(why.text, "nowhere/two");
    assert_int_equal(rmdir(dir), 0); /* the first one is not there */
}

/* A command that fails is named with its reason; one of another verb is read and not run. */
static void failed_command_gives_its_reason(void **state) {
    (void)state;
    struct command_run run;
    struct failure why;
    assert_int_equal(command_run_line(&run, "run rod-step so_ssph --dx %s", "0.3"), STATUS_INPUT);
    assert_int_equal(command_run_check(&run, &why), STATUS_INPUT);
    assert_has(why.text, "heatladder run rod-step so_ssph --dx 0.3: ");
    command_run_free(&run);
    assert_int_equal(command_run_line(&run, "reference rod-cosine --at 0.31 --time %g", 1.7), STATUS_OK);
    assert_near(run.typed.time.value[0], 1.7, 0);
    assert_null(run.field.T);
    const double kappa = 0.013, mode = 3, pi = M_PI, x[2] = {0.31, 0};
    assert_near(command_run_exact(&run, x, 1.7) - command_run_exact(&run, x, 1e9),
                (command_run_exact(&run, x, 0) - command_run_exact(&run, x, 1e9)) *
                    exp(-kappa * pow(mode * pi, 2) * 1.7),
                1e-12);
    command_run_free(&run);
    assert_int_equal(command_run_line(&run, "%0500d", 7), STATUS_INPUT);
    command_run_free(&run);
}

static void a_directory_is_made_once(void **state) {
    (void)state;
    char dir[UNIT_PATH], path[UNIT_PATH + 16], deeper[UNIT_PATH + 32], wanted[UNIT_PATH + 96];
    struct failure why = {0};
    assert_non_null(scratch_directory(dir, "test_output"));
    snprintf(path, sizeof path, "%s/made", dir);
    assert_int_equal(output_directory(path, "one", &why), STATUS_OK);
    assert_int_equal(output_directory(path, "one", &why), STATUS_OK);
    assert_int_equal(access(path, W_OK), 0);
    snprintf(deeper, sizeof deeper, "%s/none/of/it", dir);
    assert_int_equal(output_directory(deeper, "one", &why), STATUS_INPUT);
    snprintf(wanted, sizeof wanted, "cannot make the directory '%s': No such file or directory", deeper);
    assert_string_equal(why.text, wanted);
    assert_int_equal(rmdir(path), 0);
    FILE *file = fopen(path, "w");
    fclose(file);
    assert_int_equal(output_directory(path, "one", &why), STATUS_INPUT);
    snprintf(wanted, sizeof wanted, "cannot write '%s/one': Not a directory", path);
    assert_string_equal(why.text, wanted);
    unlink(path);
    assert_int_equal(rmdir(dir), 0);
}

static double exact(const struct command_run *run, const double x[2], double t) {
    const struct experiment *e = &run->typed.experiment;
    return e->scene->published ? e->scene->published(&e->problem, x, t) : command_run_exact(run, x, t);
}

/* Against the solution (as published, if it is) later by 0.25 s, or rounded to two decimals. */
static void field_file_has_the_relative_error(void **state) {
    (void)state;
    static const char *const line[] = {
        "run rod-cosine voronoi_flux --dx 0.1 --layout jitter --jitter 0.3 --set L=1.3 --dt 0.1",
        "run rod-step ftcs --dx 0.5 --dt 1"};
    for (int i = 0; i < 2; i++) {
        struct command_run run;
        assert_int_equal(command_run_line(&run, "%s", line[i]), STATUS_OK);
        const struct field *f = &run.field;
        double late = 0, rounded = 0, whole[2] = {0};
        for (size_t k = 0; k < f->n; k++) {
            double x[] = {f->x[0][k], 0}, w = f->weight ? f->weight[k] : 1;
            double T[] = {exact(&run, x, f->time + 0.25), rint(100 * exact(&run, x, f->time)) / 100};
            late += w * fabs(f->T[k] - T[0]), whole[0] += w * fabs(T[0]);
            rounded += w * fabs(f->T[k] - T[1]), whole[1] += w * fabs(T[1]);
        }
        assert_near(command_run_error(&run, 0, 0.25), late / whole[0], 1e-12);
        assert_near(command_run_error(&run, 2, 0), rounded / whole[1], 1e-12);
        command_run_free(&run);
    }
}

/* In a process limited to 64 MB: 256 MB of lines.  glibc's open_memstream drops data without an error if memory is
 * exhausted. */
static void write_much(void) {
    enum { ROOM = 64 << 20 };
    struct output page;
    struct failure why;
    struct rlimit limit = {ROOM, ROOM};
    if (!freopen("/dev/null", "w", stderr) || setrlimit(RLIMIT_DATA, &limit)) _exit(99);
    FILE *out = output_open(&page, "/dev/null");
    for (int i = 0; i < ROOM / 16; i++) fprintf(out, "%063d\n", i);
    _exit(output_close(&page, 1, &why));
}

static void out_of_memory_writes_nothing(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    skip(); /* it has an allocator of its own */
#endif
    int status;
    pid_t child = fork();
    if (child == 0) write_much();
    waitpid(child, &status, 0);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), STATUS_NUMERICAL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(file_appears_when_closed),
        cmocka_unit_test(files_of_one_set_appear_together_or_not_at_all),
        cmocka_unit_test(field_file_has_the_relative_error),
        cmocka_unit_test(out_of_memory_writes_nothing),
        cmocka_unit_test(failed_command_gives_its_reason),
        cmocka_unit_test(a_directory_is_made_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
