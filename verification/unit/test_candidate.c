/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Candidates of bench: lattices that suit a problem, the counted work of a run, medians. */
#include "verification/bench/bench.h"

#include "references/scene.h"
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/near.h"

#include <string.h>

static int unit_of(const char *name, const char *param, double value) {
    const struct scene *s = scene_find(name);
    struct problem p;
    struct failure why;
    scene_defaults(s, &p);
    for (int i = 0; param && s->params[i].name; i++)
        if (strcmp(s->params[i].name, param) == 0) p.param[i] = value;
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    return bench_candidate_unit(&p);
}

/* The jumps of rod-step are at 3/8 and 5/8 of its length, with a = 0.6 at 7/20 and 13/20, with a = 0.43711 on no
 * face of a lattice of up to 1024 cells; the layers of wall-composite meet a tenth before its middle. */
static void cell_counts_put_faces_on_jumps(void **state) {
    (void)state;
    assert_int_equal(unit_of("rod-step", NULL, 0), 8);
    assert_int_equal(unit_of("rod-step", "a", 0.6), 20);
    assert_int_equal(unit_of("rod-step", "a", 0.43711), 1);
    assert_int_equal(unit_of("rod-gauss", NULL, 0), 1);
    assert_int_equal(unit_of("rod-contact", NULL, 0), 2);
    assert_int_equal(bench_candidate_member(17, 8), 24);
    assert_int_equal(bench_candidate_member(16, 8), 16);
    assert_int_equal(bench_candidate_member(0.5, 8), 8);
}

/* A quarter of the disc's diameter is its ring; a hole of 0.3 m in a body of 1 m leaves 7 of 20 parts of 2 m. */
static void ring_counts_fill_a_round_body(void **state) {
    (void)state;
    assert_int_equal(unit_of("disc-mode", NULL, 0), 2);
    assert_int_equal(unit_of("annulus", "r1", 0.3), 20);
}

/* Particles meet a round wall by fit; differences have a polar grid. */
static void particles_use_fit_at_round_walls(void **state) {
    (void)state;
    struct command r;
    struct failure why;
    if (command_read("reference disc-mode --at 0,0 --time 1", &r, &why)) fail_msg("%s", why.text);
    for (const struct candidate *c = bench_candidates; c->label; c++)
        assert_int_equal(bench_candidate_options(c, &r.experiment, 8).walls,
                         strncmp(c->method, "ftcs", 4) == 0 ? WALLS_MIRROR : WALLS_FIT);
    command_free(&r);
}

static void every_candidate_names_a_method_and_differs(void **state) {
    (void)state;
    for (const struct candidate *c = bench_candidates; c->label; c++) {
        assert_non_null(method_find(c->method));
        for (const struct candidate *d = bench_candidates; d < c; d++)
            assert_false(strcmp(c->label, d->label) == 0 && c->dim == d->dim);
    }
}

static struct result run(const char *line) {
    struct command r;
    struct result result;
    struct failure why;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    command_free(&r);
    return result;
}

/* 16 of 32 particles are computed, in 40 steps: pairs, two for each update, 16 for each ghost (one on either side),
 * and for each particle 8 operations' worth of its place, 20, and its sample, 36. */
static void work_is_counted(void **state) {
    (void)state;
    struct result ftcs = run("run rod-step ftcs --dx 4/32 --dt 0.125");
    struct result cell = run("run rod-step ftcs --dx 4/32 --dt 0.125 --sampling cell");
    assert_near(ftcs.cost.work, 40 * (16 * (2 + 2) + 16 * 2) + 8 * 16 * (20 + 36), 1e-9);
    assert_near(cell.cost.work - ftcs.cost.work, 8 * 16 * 36 * 3, 1e-9);
    struct result twice = run("run rod-step ftcs --dx 4/32 --dt 0.0625");
    assert_near(twice.cost.work - ftcs.cost.work, 40 * (16 * (2 + 2) + 16 * 2), 1e-9);
}

/* The saving of rkl2 counts all updates, those of a damped first step too: twice the updates, half the saving. */
static void updates_of_a_damped_start_are_counted(void **state) {
    (void)state;
    const char *lines[] = {"run square-step so_ssph --stepper rkl2 --dx 4/160 --dt 5/6",
                           "run square-step so_ssph --stepper rkl2 --dx 4/160 --dt 5/24"};
    double euler[2];
    for (int i = 0; i < 2; i++) {
        struct result r = run(lines[i]);
        double quarter = (double)r.particles / 4;
        assert_order((double)r.cost.updates, >, quarter * (double)r.steps * r.stages);
        euler[i] = r.saving * (double)r.cost.updates / quarter;
    }
    assert_near(euler[0] / euler[1], 1, 1e-12);
}

/* Searches, rows and transforms cost more than the one stencil of a lattice. */
static void searches_and_rows_cost_more_than_a_stencil(void **state) {
    (void)state;
    double once = run("run square-step so_ssph --dx 0.1 --fourier 1e9 --stepper euler --set t_end=1e-9").cost.work;
    double searched =
        run("run square-step so_ssph --dx 0.1 --h iso --fourier 1e9 --stepper euler --set t_end=1e-9").cost.work;
    double rows = run("run square-step so_ssph --dx 0.1 --layout jitter --jitter 0 --fourier 1e9 --stepper euler "
                      "--set t_end=1e-9")
                      .cost.work;
    double exact = run("run square-step so_ssph --dx 0.1 --stepper exact --set t_end=1e-9").cost.work;
    assert_order(searched, >, 1.2 * once);
    assert_order(rows, >, 5 * once);
    assert_order(exact, >, 2 * once);
}

static void timing_summary_is_median_and_range(void **state) {
    (void)state;
    double seconds[5] = {3, 100, 1, 2, 2.5};
    struct bench_time t = bench_summary(seconds, 5);
    assert_near(t.median, 2.5, 0);
    assert_near(t.lowest, 1, 0);
    assert_near(t.highest, 100, 0);
}

/* The coarsest rung runs whatever the time, and predicts the next one; 4e5 given steps are predicted too. */
static void rungs_that_take_too_long_are_left_out(void **state) {
    (void)state;
    static struct bench_scene b;
    struct command r;
    struct failure why;
    const struct candidate *c = bench_candidates;
    while (c->dim == 2) c++;
    if (command_read("run rod-cosine ftcs --dx 0.1", &r, &why)) fail_msg("%s", why.text);
    b = (struct bench_scene){.scene = r.experiment.scene};
    bench_climb(c, &r.experiment, 1, 0, &b);
    assert_int_equal(b.count, 2);
    assert_null(bench_outcome(&b.row[0]));
    assert_string_equal(bench_outcome(&b.row[1]), "left out");
    assert_has(b.row[1].result.failure.text, "s are left");
    assert_string_equal(b.row[1].result.scene->name, "rod-cosine");
    command_free(&r);
    while (c->options.dt == 0) c++;
    if (command_read("run plate-cooling so_ssph --dx 0.05 --t-end 20", &r, &why)) fail_msg("%s", why.text);
    b = (struct bench_scene){.scene = r.experiment.scene};
    bench_climb(c, &r.experiment, 1, 0.1, &b);
    assert_int_equal(b.count, 1);
    assert_string_equal(bench_outcome(&b.row[0]), "left out");
    command_free(&r);
}

static void refused_and_failed_candidates_differ(void **state) {
    (void)state;
    assert_null(bench_outcome(&(struct bench_row){0}));
    assert_string_equal(bench_outcome(&(struct bench_row){.result.failure.status = STATUS_INPUT}), "not applicable");
    assert_string_equal(bench_outcome(&(struct bench_row){.result.failure.status = STATUS_NUMERICAL}), "failed");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cell_counts_put_faces_on_jumps),
        cmocka_unit_test(ring_counts_fill_a_round_body),
        cmocka_unit_test(particles_use_fit_at_round_walls),
        cmocka_unit_test(every_candidate_names_a_method_and_differs),
        cmocka_unit_test(work_is_counted),
        cmocka_unit_test(updates_of_a_damped_start_are_counted),
        cmocka_unit_test(searches_and_rows_cost_more_than_a_stencil),
        cmocka_unit_test(timing_summary_is_median_and_range),
        cmocka_unit_test(refused_and_failed_candidates_differ),
        cmocka_unit_test(rungs_that_take_too_long_are_left_out),
    };
    return cmocka_run_group_tests_name("candidate", tests, NULL, NULL);
}
