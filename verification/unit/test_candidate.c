/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Candidates of choose and bench: which lattices suit a problem, what a run is counted as, and medians. */
#include "verification/choose/candidate.h"

#include "references/scene.h"
#include "verification/command/arguments.h"
#include "verification/bench/bench.h"
#include "verification/run/run.h"

#include "verification/unit/near.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

static int unit_of(const char *name, const char *param, double value) {
    const struct scene *s = scene_find(name);
    struct problem p;
    struct failure why;
    scene_defaults(s, &p);
    for (int i = 0; param && s->params[i].name; i++)
        if (strcmp(s->params[i].name, param) == 0) p.param[i] = value;
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    return candidate_unit(&p);
}

/* The jumps of rod-step lie 3/8 and 5/8 along it, those with a = 0.6 at 7/20 and 13/20, those with a = 0.43711 on no
 * face of a lattice of up to 1024; the layers of wall-composite meet at its middle less a tenth. */
static void lattices_meet_the_jumps(void **state) {
    (void)state;
    assert_int_equal(unit_of("rod-step", NULL, 0), 8);
    assert_int_equal(unit_of("rod-step", "a", 0.6), 20);
    assert_int_equal(unit_of("rod-step", "a", 0.43711), 1);
    assert_int_equal(unit_of("rod-gauss", NULL, 0), 1);
    assert_int_equal(unit_of("rod-contact", NULL, 0), 2);
    assert_int_equal(candidate_member(17, 8), 24);
    assert_int_equal(candidate_member(16, 8), 16);
    assert_int_equal(candidate_member(0.5, 8), 8);
}

/* A quarter of the disc's diameter is its ring; a hole of 0.3 m in a body of 1 m leaves 7 of 20 parts of 2 m. */
static void rings_fill_a_round_body(void **state) {
    (void)state;
    assert_int_equal(unit_of("disc-mode", NULL, 0), 2);
    assert_int_equal(unit_of("annulus", "r1", 0.3), 20);
}

/* Of 0.1 m by 0.0731234567 m: of up to 1024 parts of the width 302 of 413 are the nearest height. */
static void what_would_fit_is_told(void **state) {
    (void)state;
    const struct scene *s = scene_find("plate");
    struct problem p;
    struct failure why;
    char text[200];
    double height, apart = 1;
    int best = 0, tall = 0;
    scene_defaults(s, &p);
    for (int i = 0; s->params[i].name; i++)
        if (strcmp(s->params[i].name, "height") == 0) p.param[i] = 0.0731234567;
    assert_int_equal(s->setup(&p, &why), STATUS_OK);
    for (int n = 1; n <= 1024; n++)
        if (fabs(round(0.731234567 * n) / n - 0.731234567) < apart)
            best = n, tall = (int)round(0.731234567 * n), apart = fabs((double)tall / n - 0.731234567);
    candidate_fitting(&p, text, sizeof text);
    assert_int_equal(sscanf(text, "0.1 m by %lf m, and not 0.0731235 m", &height), 1);
    assert_near(height, 0.1 * tall / best, 1e-12);
}

/* Particles meet a round wall by fit; differences have a polar grid. */
static void particles_meet_round_walls_by_fit(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    if (arguments_parse_line("reference disc-mode --at 0,0 --time 1", &r, &why)) fail_msg("%s", why.text);
    for (const struct candidate *c = candidates_table; c->label; c++)
        assert_int_equal(candidate_options(c, &r.experiment, 8).walls,
                         strncmp(c->method, "ftcs", 4) == 0 ? WALLS_MIRROR : WALLS_FIT);
    arguments_free(&r);
}

static void every_candidate_names_a_method_and_differs(void **state) {
    (void)state;
    for (const struct candidate *c = candidates_table; c->label; c++) {
        assert_non_null(method_find(c->method));
        for (const struct candidate *d = candidates_table; d < c; d++)
            assert_false(strcmp(c->label, d->label) == 0 && c->dim == d->dim);
    }
}

static struct result run(const char *line) {
    struct request r;
    struct result result;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    arguments_free(&r);
    return result;
}

/* 16 of 32 particles are computed, in 40 steps: pairs, two for each update, 16 for each ghost (two on either side),
 * and for each particle 8 operations' worth of its place, 20, and its sample, 36. */
static void work_is_counted(void **state) {
    (void)state;
    struct result ftcs = run("run rod-step ftcs --dx 4/32 --dt 0.125");
    struct result cell = run("run rod-step ftcs --dx 4/32 --dt 0.125 --sampling cell");
    assert_near(ftcs.cost.work, 40 * (16 * (2 + 2) + 16 * 4) + 8 * 16 * (20 + 36), 1e-9);
    assert_near(cell.cost.work - ftcs.cost.work, 8 * 16 * 36 * 3, 1e-9);
    struct result twice = run("run rod-step ftcs --dx 4/32 --dt 0.0625");
    assert_near(twice.cost.work - ftcs.cost.work, 40 * (16 * (2 + 2) + 16 * 4), 1e-9);
}

/* What rkl2 saves is counted over all its updates, those of a damped first step among them: twice the updates, half
 * the saving. */
static void a_damped_start_counts_in_the_saving(void **state) {
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

/* The plan of a run tells its cost to the last pair, and what rounding leaves is no more than what it can. */
static void costs_are_predicted(void **state) {
    (void)state;
    const char *lines[] = {"choose rod-contact --error 1", "choose square-step --error 1",
                           "choose rect-manufactured --error 1"};
    int n = 24;
    int compared = 0;
    for (int i = 0; i < 3; i++) {
        struct request r;
        struct failure why;
        assert_int_equal(arguments_parse_line(lines[i], &r, &why), STATUS_OK);
        for (const struct candidate *c = candidates_table; c->label; c++) {
            struct candidate_cost cost;
            struct result result;
            if (c->dim && c->dim != r.experiment.problem.dim) continue;
            int status = candidate_prove(c, &r.experiment, n, &result, NULL);
            assert_int_equal(candidate_predict(c, &r.experiment, n, &cost, &why), status);
            if (status) continue;
            assert_near(cost.work, result.cost.work, 0);
            assert_order(cost.bytes, >=, (double)result.cost.bytes);
            assert_order(cost.rounding, <, result.rounding);
            assert_order(cost.rounding, >, 0);
            if (c->steps > 0) assert_int_equal(result.steps, 13);
            if (c->options.stepper == STEPPER_CHEBYSHEV) assert_int_equal(result.steps, 1);
            compared++;
        }
        arguments_free(&r);
    }
    assert_order(compared, >, 20);
}

/* What else a candidate may do once outweighs the one stencil of a lattice. */
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

/* A quarter eps a root of roundings: two transforms of 2 n along each axis have 2 log2(2 n) levels, an Euler step
 * one. */
static void rounding_goes_with_the_root_of_its_steps(void **state) {
    (void)state;
    const struct {
        const char *label, *line;
        int n;
        double roundings;
    } row[] = {{"so_ssph exact, h/dx 0.9", "choose rod-gauss --error 1", 48, 2 * log2(2 * 48)},
               {"so_ssph exact, h/dx 0.9", "choose rect-manufactured --error 1", 20, 2 * log2(40) + 2 * log2(28)},
               {"ftcs at F = 1/6", "choose rod-step --error 1", 24, 11}}; /* 5 s of 1/100 m^2/s at 1/6 m: 10.8 */
    for (int i = 0; i < 3; i++) {
        struct request r;
        struct candidate_cost cost;
        struct failure why;
        const struct candidate *c = candidates_table;
        while (strcmp(c->label, row[i].label) != 0) c++;
        assert_int_equal(arguments_parse_line(row[i].line, &r, &why), STATUS_OK);
        assert_int_equal(candidate_predict(c, &r.experiment, row[i].n, &cost, &why), STATUS_OK);
        assert_near(cost.rounding / (DBL_EPSILON / 4 * sqrt(row[i].roundings)), 1, 1e-12);
        arguments_free(&r);
    }
}

/* What choose takes, on a rod and in the plane, and what bench alone takes: a flag of one row among forty may well be
 * wrong.  A new row changes a number here. */
static void choose_takes_what_is_not_for_bench_alone(void **state) {
    (void)state;
    int rod = 0, plane = 0, bench = 0;
    for (const struct candidate *c = candidates_table; c->label; c++) {
        assert_true(c->dim >= 0 && c->dim <= 2);
        assert_true(c->steps == 0 || c->options.stepper == STEPPER_RKL2);
        assert_true(c->dim != 2 || c->options.h_iso == 1);
        bench += c->bench_only != 0;
        rod += !c->bench_only && c->dim != 2;
        plane += !c->bench_only && c->dim != 1;
    }
    assert_int_equal(rod, 23);
    assert_int_equal(plane, 17);
    assert_int_equal(bench, 14);
}

static void a_median_is_no_mean(void **state) {
    (void)state;
    double seconds[5] = {3, 100, 1, 2, 2.5};
    struct bench_time t = bench_summary(seconds, 5);
    assert_near(t.median, 2.5, 0);
    assert_near(t.lowest, 1, 0);
    assert_near(t.highest, 100, 0);
}

static void a_ratio_is_as_wide_as_both(void **state) {
    (void)state;
    struct bench_time t = bench_ratio((struct bench_time){3, 2, 5}, (struct bench_time){1.5, 1, 4});
    assert_near(t.median, 2, 0);
    assert_near(t.lowest, 0.5, 0);
    assert_near(t.highest, 5, 0);
}

static void a_refusal_is_no_failure(void **state) {
    (void)state;
    assert_null(bench_outcome(&(struct bench_row){0}));
    assert_string_equal(bench_outcome(&(struct bench_row){.result.failure.status = STATUS_INPUT}), "not applicable");
    assert_string_equal(bench_outcome(&(struct bench_row){.result.failure.status = STATUS_NUMERICAL}), "failed");
}

/* Song's dt of 5e-5 s on the cooled plate, where all rungs so far took 1e-9 s a pair: to its end 1.2e8 steps, and to
 * t = 0.01 s 200, which are no second. */
static void what_takes_too_long_is_left_out(void **state) {
    (void)state;
    const struct candidate *song = candidates_table;
    while (song->options.dt == 0) song++;
    static struct bench_scene b;
    struct request r;
    struct failure why;
    const struct {
        const char *line;
        double seconds;
        const char *outcome;
    } cases[] = {{"run plate-cooling so_ssph --dx 0.05 --t-end 20", 4, "left out"},
                 {"run plate-cooling so_ssph --dx 0.05 --t-end 20", 0, "left out"},
                 {"run plate-cooling so_ssph --dx 0.05 --t-end 0.01", 1e3, NULL}};
    for (int i = 0; i < 3; i++) {
        if (arguments_parse_line(cases[i].line, &r, &why)) fail_msg("%s: %s", cases[i].line, why.text);
        b = (struct bench_scene){.scene = r.experiment.scene, .seconds = 1, .work = 1e9};
        bench_climb(song, &r.experiment, candidate_unit(&r.experiment.problem), cases[i].seconds, &b);
        const char *outcome = bench_outcome(&b.row[0]);
        assert_true(outcome == cases[i].outcome || strcmp(outcome, cases[i].outcome) == 0);
        if (outcome) {
            assert_int_equal(b.count, 1);
            assert_has(b.row[0].result.failure.text, "s that are left");
            assert_string_equal(b.row[0].result.scene->name, "plate-cooling");
            assert_near(b.seconds, 1, 0);
        } else {
            assert_order(b.count, >, 1);
            assert_order(b.seconds, >, 1);
            assert_order(b.work, >, 1e9);
        }
        arguments_free(&r);
    }
}

/* What took 43.7 s of a processor of 4e9 to 5e9 pairs a second: 6.7e6 exact temperatures at the particles, and as
 * many half-way along each axis, were three quarters of that. */
static void a_proving_run_is_more_than_its_solve(void **state) {
    (void)state;
    struct request r;
    struct candidate_cost cost;
    struct failure why;
    const struct candidate *c = candidates_table;
    while (strcmp(c->label, "ftcs at F = 0.2, cell samples") != 0) c++;
    assert_int_equal(arguments_parse_line("choose plate --error 1e-3 --t-end 0.01", &r, &why), STATUS_OK);
    assert_int_equal(candidate_predict(c, &r.experiment, 2581, &cost, &why), STATUS_OK);
    double n = 2581.0 * 2581;
    assert_near(cost.work / 5.56e10, 1, 0.01);
    assert_near((cost.proof - cost.whole) / n, 2 * 10000, 1);
    assert_order(cost.proof, >, 2e11);
    assert_order(cost.proof, <, 3.3e11);
    arguments_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lattices_meet_the_jumps),
        cmocka_unit_test(rings_fill_a_round_body),
        cmocka_unit_test(what_would_fit_is_told),
        cmocka_unit_test(particles_meet_round_walls_by_fit),
        cmocka_unit_test(every_candidate_names_a_method_and_differs),
        cmocka_unit_test(work_is_counted),
        cmocka_unit_test(a_damped_start_counts_in_the_saving),
        cmocka_unit_test(costs_are_predicted),
        cmocka_unit_test(what_takes_too_long_is_left_out),
        cmocka_unit_test(searches_and_rows_cost_more_than_a_stencil),
        cmocka_unit_test(a_proving_run_is_more_than_its_solve),
        cmocka_unit_test(rounding_goes_with_the_root_of_its_steps),
        cmocka_unit_test(choose_takes_what_is_not_for_bench_alone),
        cmocka_unit_test(a_median_is_no_mean),
        cmocka_unit_test(a_ratio_is_as_wide_as_both),
        cmocka_unit_test(a_refusal_is_no_failure),
    };
    return cmocka_run_group_tests_name("candidate", tests, NULL, NULL);
}
