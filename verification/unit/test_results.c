/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases written now and judged later, and ladders in a parameter of a program. */
#include "verification/case/case_file.h"
#include "verification/case/results.h"

#include "solver/status.h"
#include "verification/case/command.h"
#include "verification/cli/verb.h"
#include "verification/judge/ladder.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define AWK "awk -f verification/unit/ftcs.awk"

static char dir[UNIT_PATH];

/* DIR/name */
static const char *below(const char *name) {
    static char path[UNIT_PATH + 20];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    return path;
}

static int write_cases(const char *options, char *text, size_t size) {
    struct command r;
    struct failure why = {0};
    char line[400];
    int written;
    snprintf(line, sizeof line, "run rod-gauss mine --solver '{case}{out}' %s", options);
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    int status = results_write(&(struct results_place){dir, "", "", NULL, 0}, r.experiment.scene,
                               &r.experiment.problem, &r.experiment.options, r.rungs.dx.text, &written, &why);
    command_free(&r);
    snprintf(text, size, "%s", why.text);
    return status;
}

static void climb(const char *line, struct ladder *l, int wanted) {
    struct command r;
    struct failure why = {0};
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    int status = ladder_run(&r.experiment, &r.rungs, l, &why);
    if (status != wanted) fail_msg("%s: %d, %s", line, status, why.text);
    command_free(&r);
    ladder_free(l);
}

static void run_all(void) {
    char command[400];
    snprintf(command, sizeof command, "while read d; do " AWK " $d/case > $d/out.csv; done < %s/cases.txt", dir);
    assert_int_equal(system(command), 0);
}

/* Neither spacings nor parameters are typed again, and the ladder is that of --solver. */
static void judging_later_gives_the_same_verdicts(void **state) {
    (void)state;
    char text[480], line[400];
    struct ladder now, later;
    assert_int_equal(write_cases("--dx 1,0.50,0.25,2e-1,1/8 --set kappa=0.4 --fourier 0.4", text, sizeof text), 0);
    run_all();
    climb("ladder rod-gauss mine --dx 1,0.5,0.25,0.2,0.125 --set kappa=0.4 --fourier 0.4 --solver '" AWK
          " {case} > {out}'",
          &now, 0);
    snprintf(line, sizeof line, "ladder rod-gauss mine --results %s", dir);
    climb(line, &later, 0);
    assert_int_equal(later.n, 5);
    for (int i = 0; i < 5; i++) assert_near(later.rung[i].error[NORM_L1], now.rung[i].error[NORM_L1], 0);
}

static void missing_answers_are_listed(void **state) {
    (void)state;
    char line[400], path[400];
    struct ladder l;
    snprintf(path, sizeof path, "%s/rod-gauss/2e-1/out.csv", dir);
    assert_int_equal(unlink(path), 0);
    snprintf(line, sizeof line, "ladder rod-gauss mine --results %s", dir);
    climb(line, &l, STATUS_INPUT);
    assert_int_equal(l.n, 5);
    assert_int_equal(l.rung[3].failure.status, STATUS_INPUT);
    assert_has(l.rung[3].failure.text, "2e-1/out.csv: no such file");
    assert_int_equal(l.rung[4].failure.status, 0);
    assert_int_equal(l.verdict, VERDICT_FAIL);
    run_all();
}

/* More cases join those that are there; none takes the place of one that has an answer. */
static void cases_are_added_without_replacing_others(void **state) {
    (void)state;
    char text[480], line[400], path[400];
    struct ladder l;
    struct stat before, after;
    snprintf(path, sizeof path, "%s/rod-gauss/1/case", dir);
    assert_int_equal(stat(path, &before), 0);
    assert_int_equal(write_cases("--dx 1,0.1 --set kappa=0.4 --fourier 0.4", text, sizeof text), 0);
    assert_int_equal(stat(path, &after), 0);
    assert_int_equal(before.st_ino, after.st_ino);
    run_all();
    snprintf(line, sizeof line, "ladder rod-gauss mine --results %s", dir);
    climb(line, &l, 0);
    assert_int_equal(l.n, 6);
    assert_int_equal(write_cases("--dx 1 --set kappa=0.3 --fourier 0.4", text, sizeof text), STATUS_INPUT);
    assert_has(text, "an answer to another case is there");
    struct command r;
    struct failure why;
    snprintf(line, sizeof line, "ladder rod-gauss mine --set kappa=0.3 --results %s", dir);
    assert_int_equal(command_read(line, &r, &why), STATUS_INPUT);
    assert_has(why.text, "param_kappa = 0.4");
    command_free(&r);
    snprintf(line, sizeof line, "ladder rod-step mine --results %s", dir);
    assert_int_equal(command_read(line, &r, &why), STATUS_INPUT);
    assert_has(why.text, "No such file");
    command_free(&r);
}

/* An end time that was edited after the answer was made. */
static void an_edited_case_is_refused(void **state) {
    (void)state;
    static const char *const edit[] = {"s/^t_end = .*/t_end = 7/", "s/^t_end = 7/t_end = 0.5e1/"};
    char command[5 * UNIT_PATH], line[400];
    struct ladder l;
    snprintf(line, sizeof line, "ladder rod-gauss mine --dx 1,0.5,0.25,0.1 --results %s", dir);
    for (int k = 0; k < 2; k++) {
        snprintf(command, sizeof command,
                 "sed '%s' %s/rod-gauss/0.25/case >%s/new && mv %s/new %s/rod-gauss/0.25/case", edit[k], dir, dir,
                 dir, dir);
        assert_int_equal(system(command), 0);
        climb(line, &l, k ? 0 : STATUS_INPUT);
        if (!k)
            assert_has(l.rung[2].failure.text, "t_end = 7, where this command has 5: the answer beside it is of ");
    }
}

/* The answer for 0.25 m in the place of that for 0.5 m. */
static void an_answer_of_a_finer_rung_is_refused(void **state) {
    (void)state;
    char command[4 * UNIT_PATH], line[400];
    struct ladder l;
    snprintf(command, sizeof command, "cp %s/rod-gauss/0.25/out.csv %s/rod-gauss/0.50/out.csv", dir, dir);
    assert_int_equal(system(command), 0);
    snprintf(line, sizeof line, "ladder rod-gauss mine --results %s", dir);
    climb(line, &l, STATUS_INPUT);
    assert_has(l.rung[1].failure.text, "0.50/out.csv: the same file as ");
    run_all();
    climb(line, &l, 0);
}

/* dy is written to the case and read from it; 20 by 7 cells of 0.05 m by 0.1 m, for which 19 by 6 points are the
 * minimum. */
static void a_second_spacing_is_kept(void **state) {
    (void)state;
    char line[400], path[400], text[4000] = "";
    struct command r;
    struct failure why = {0};
    int written;
    if (command_read("run rect-manufactured mine --dx 0.05 --aspect 2 --solver '{case}{out}'", &r, &why))
        fail_msg("%s", why.text);
    const struct experiment *e = &r.experiment;
    assert_int_equal(results_write(&(struct results_place){dir, "", "", NULL, 0}, e->scene, &e->problem, &e->options,
                                   r.rungs.dx.text, &written, &why),
                     0);
    command_free(&r);
    snprintf(path, sizeof path, "%s/rect-manufactured/0.05/case", dir);
    FILE *in = fopen(path, "r");
    assert_true(in && fread(text, 1, sizeof text - 1, in) > 0);
    fclose(in);
    assert_has(text, "\ncells = 20, 7\n");
    assert_has(text, "\ndy = 0.1");
    snprintf(line, sizeof line, "run rect-manufactured mine --dx 0.05 --results %s", dir);
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    assert_near(r.experiment.options.aspect, 2, 1e-15);
    command_free(&r);
    snprintf(line, sizeof line, "run rect-manufactured mine --dx 0.05 --aspect 3 --results %s", dir);
    assert_int_equal(command_read(line, &r, &why), STATUS_INPUT);
    assert_has(why.text, "dy is 2 dx, but 3 dx");
    command_free(&r);
    snprintf(line, sizeof line,
             "ladder rect-manufactured mine --dx 0.05,0.025 --aspect 3 --solver '" AWK " {case} > {out}'");
    struct ladder l;
    climb(line, &l, STATUS_INPUT);
    assert_has(l.rung[0].failure.text, "--aspect 3: does not divide");
}

/* 1 m by 0.7 m with the axes exchanged: cells of 0.1 m by 0.07 m divide the scene and not the case, 0.07 m by 0.1 m
 * the other way round. */
static void spacings_are_along_the_axes_of_the_case(void **state) {
    (void)state;
    static const char *const spacing[] = {"0.1 --aspect 0.7", "0.07 --aspect 1/0.7"};
    for (int k = 0; k < 2; k++) {
        char line[400];
        struct command r;
        struct failure why = {0};
        int written;
        snprintf(line, sizeof line, "run rect-manufactured mine --dx %s --map y,-x --solver '{case}{out}'",
                 spacing[k]);
        if (command_read(line, &r, &why)) fail_msg("%s", why.text);
        const struct experiment *e = &r.experiment;
        assert_int_equal(results_write(&(struct results_place){below("turned"), "", "", &e->program.map, 0}, e->scene,
                                       &e->problem, &e->options, r.rungs.dx.text, &written, &why),
                         k == 0 ? STATUS_INPUT : 0);
        if (k == 0) assert_has(why.text, "--dx 0.1 --aspect 0.7: does not divide the domain");
        command_free(&r);
    }
}

/* A program that adds 1e-3 seed K, of the seed that its case says: the errors of a rung are those of both draws, and
 * their parameters are read. */
static void draws_are_judged_later(void **state) {
    (void)state;
    char line[600];
    struct command r;
    struct failure why = {0};
    struct ladder one, both;
    int written;
    if (command_read("ladder rod-gauss mine --set kappa=0.4 --fourier 0.4 --dx 1,0.5,0.25,0.2 --seeds 2 "
                     "--solver '{case}{out}'",
                     &r, &why))
        fail_msg("%s", why.text);
    const struct experiment *e = &r.experiment;
    assert_int_equal(results_write(&(struct results_place){below("drawn"), "", "", NULL, 2}, e->scene, &e->problem,
                                   &e->options, r.rungs.dx.text, &written, &why),
                     0);
    assert_int_equal(written, 8);
    command_free(&r);
    snprintf(line, sizeof line,
             "for d in %s/drawn/rod-gauss/*/seed=*; do s=$(sed -n 's/^seed = //p' $d/case); " AWK
             " $d/case | awk -F, -v OFS=, -v s=$s '$1 + 0 == $1 { $2 += 1e-3 * s } { print }' > $d/out.csv; done",
             dir);
    assert_int_equal(system(line), 0);
    snprintf(line, sizeof line, "ladder rod-gauss mine --seeds 2 --results %s/drawn", dir);
    if (command_read(line, &r, &why)) fail_msg("%s", why.text);
    const double *kappa = r.experiment.problem.param;
    assert_near(kappa[2], 0.4, 0);
    command_free(&r);
    climb(line, &both, 0);
    assert_int_equal(both.draws, 2);
    assert_near(both.rung[0].error[NORM_L1], sqrt(both.draw[0][0] * both.draw[1][0]), 1e-15);
    assert_order(both.draw[1][3], >, both.draw[0][3] + 0.5e-3);
    snprintf(line, sizeof line, "ladder rod-gauss mine --results %s/drawn", dir);
    climb(line, &one, STATUS_INPUT); /* there is no answer without a seed */
}

/* The number of cells rises where dx falls; the order is the same. */
static void vary_sets_a_parameter_of_the_program(void **state) {
    (void)state;
    struct ladder in_dx, in_cells;
    climb("ladder rod-gauss mine --dx 1,0.5,0.25,0.125 --set kappa=0.4 --fourier 0.4 --solver '" AWK
          " {case} > {out}'",
          &in_dx, 0);
    climb(
        "ladder rod-gauss mine --dx 1 --vary cells_x=30,60,120,240 --set kappa=0.4 --fourier 0.4 --solver 'grep -qx "
        "\"cells_x = {cells_x}\" {case} && sed \"s/^dx = .*/dx = $(awk \"BEGIN{print 30/{cells_x}}\")/\" {case} > "
        "{case}.m && " AWK " {case}.m > {out}'",
        &in_cells, 0);
    for (int i = 0; i < 4; i++) assert_near(in_cells.rung[i].error[NORM_L1], in_dx.rung[i].error[NORM_L1], 1e-12);
    assert_near(in_cells.slope.value, in_dx.slope.value, 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(judging_later_gives_the_same_verdicts),    cmocka_unit_test(missing_answers_are_listed),
        cmocka_unit_test(cases_are_added_without_replacing_others), cmocka_unit_test(an_edited_case_is_refused),
        cmocka_unit_test(an_answer_of_a_finer_rung_is_refused),     cmocka_unit_test(a_second_spacing_is_kept),
        cmocka_unit_test(spacings_are_along_the_axes_of_the_case),  cmocka_unit_test(draws_are_judged_later),
        cmocka_unit_test(vary_sets_a_parameter_of_the_program),
    };
    char command[UNIT_PATH + 32];
    if (!scratch_directory(dir, "results-test")) return 1;
    int failed = cmocka_run_group_tests_name("results", tests, NULL, NULL);
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command) || failed;
}
