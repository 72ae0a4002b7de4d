/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A benchmark as text, JSON and CSV, from rows with known seconds and errors; and a short measured one: which rows
 * are on a front. */
#include "verification/bench/bench_print.h"

#include "references/scene.h"
#include "solver/method.h"
#include "solver/options.h"
#include "verification/bench/bench.h"
#include "verification/case/command.h"
#include "verification/text/json.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>

static const struct candidate fine = {.label = "so_ssph exact, cubic kernel", .method = "so_ssph"},
                              plain = {.label = "ftcs", .method = "ftcs"},
                              song = {.label = "so_ssph at Song's dt", .method = "so_ssph"};

static struct bench_row row(const struct candidate *c, int n, double error, double seconds, double work) {
    struct bench_row r = {.candidate = c, .n = n, .work = work, .time = {seconds, 0.9 * seconds, 1.2 * seconds}};
    r.result.scene = scene_find("rod-cosine");
    r.result.method = method_find(c->method);
    r.result.error[NORM_L1] = error;
    r.result.particles = (size_t)n;
    r.result.cost.bytes = 40 * (size_t)n;
    r.result.cost.updates = 1000LL * n;
    return r;
}

static struct bench_row not_run(const struct candidate *c, int n, int status, int left_out, const char *text) {
    struct bench_row r = {.candidate = c, .n = n, .left_out = left_out, .result.failure.status = status};
    r.result.scene = scene_find("rod-cosine");
    r.result.method = method_find(c->method);
    snprintf(r.result.failure.text, sizeof r.result.failure.text, "%s", text);
    return r;
}

/* Two candidates that ran, with rows on the front by time, by work and by both; three that did not run. */
static const struct bench_scene *made(void) {
    static struct bench_scene b;
    b = (struct bench_scene){.scene = scene_find("rod-cosine")};
    b.row[b.count] = row(&fine, 8, 2.5e-3, 2e-6, 150);
    b.row[b.count++].front_time = 1;
    b.row[b.count] = row(&fine, 16, 6.25e-4, 3e-6, 700);
    b.row[b.count].front_time = 1, b.row[b.count++].front_work = 1;
    b.row[b.count] = row(&plain, 8, 3e-3, 5e-6, 120);
    b.row[b.count++].front_work = 1;
    b.row[b.count++] = row(&plain, 16, 7e-4, 9e-6, 1900);
    b.row[b.count++] = not_run(&song, 32, STATUS_NUMERICAL, 0, "unstable at t = 1 s");
    b.row[b.count++] = not_run(&song, 64, STATUS_NUMERICAL, 0, "unstable at t = 1 s");
    b.row[b.count++] = not_run(&song, 128, STATUS_INPUT, 1, "takes 12 s of the 3 s that are left");
    return &b;
}

/* The output of `print`; the caller frees it. */
static char *printed(void (*print)(FILE *out)) {
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    print(out);
    fclose(out);
    return text;
}

static void scene_text(FILE *out) {
    bench_print_scene(made(), out);
}

static void scene_data(FILE *out) {
    bench_print_data(made(), out);
}

static void tables_list_fronts_and_refused_candidates(void **state) {
    (void)state;
    char *text = printed(scene_text);
    assert_string_equal(
        text,
        "rod-cosine\n"
        "on a front                   along x         E1  seconds  spread [%]  work [pairs]  B/particle  fronts\n"
        "so_ssph exact, cubic kernel        8  2.500e-03    2e-06          30           150          40  time\n"
        "so_ssph exact, cubic kernel       16  6.250e-04    3e-06          30           700          40  time, work\n"
        "ftcs                               8  3.000e-03    5e-06          30           120          40  work\n"
        "failed: so_ssph at Song's dt, 32 to 64 along x: unstable at t = 1 s\n"
        "left out: so_ssph at Song's dt, 128 along x: takes 12 s of the 3 s that are left\n"
        "\n");
    free(text);
}

/* After the lines on the machine. */
static void charts_have_one_block_per_candidate_and_front(void **state) {
    (void)state;
    char *text = printed(scene_data), *blocks = strstr(text, "# seconds: ");
    assert_has(text, "# title: rod-cosine: error against cost\n# command: heatladder bench --scene rod-cosine\n"
                     "# processor: ");
    assert_has(text, "# compiler: ");
    assert_non_null(blocks);
    assert_string_equal(
        blocks, "# seconds: median of 5; work: pairs\n"
                "# so_ssph exact, cubic kernel\n"
                "n,particles,E1,seconds,lowest,highest,work,bytes,updates,so_ssph exact; cubic kernel\n"
                "8,8,0.0025000000000000001,2e-06,1.8e-06,2.4e-06,150,320,8000,\"so_ssph exact, cubic kernel\"\n"
                "16,16,0.00062500000000000001,3e-06,2.7e-06,3.6e-06,700,640,16000,"
                "\"so_ssph exact, cubic kernel\"\n"
                "\n\n# ftcs\n"
                "n,particles,E1,seconds,lowest,highest,work,bytes,updates,ftcs\n"
                "8,8,0.0030000000000000001,5e-06,4.5e-06,6e-06,120,320,8000,\"ftcs\"\n"
                "16,16,0.00069999999999999999,9e-06,8.1e-06,1.08e-05,1900,640,16000,\"ftcs\"\n"
                "# failed: so_ssph at Song's dt, 32 along x: unstable at t = 1 s\n"
                "# failed: so_ssph at Song's dt, 64 along x: unstable at t = 1 s\n"
                "# left out: so_ssph at Song's dt, 128 along x: takes 12 s of the 3 s that are left\n"
                "\n\n# front by time\n"
                "n,particles,E1,seconds,lowest,highest,work,bytes,updates,Pareto front\n"
                "8,8,0.0025000000000000001,2e-06,1.8e-06,2.4e-06,150,320,8000,\"so_ssph exact, cubic kernel\"\n"
                "16,16,0.00062500000000000001,3e-06,2.7e-06,3.6e-06,700,640,16000,"
                "\"so_ssph exact, cubic kernel\"\n"
                "\n\n# front by work\n"
                "n,particles,E1,seconds,lowest,highest,work,bytes,updates,Pareto front\n"
                "8,8,0.0030000000000000001,5e-06,4.5e-06,6e-06,120,320,8000,\"ftcs\"\n"
                "16,16,0.00062500000000000001,3e-06,2.7e-06,3.6e-06,700,640,16000,"
                "\"so_ssph exact, cubic kernel\"\n"
                "\n");
    free(text);
}

static void json(FILE *out) {
    struct json j = json_on(out);
    bench_print_machine_json(&j);
    bench_print_scene_json(made(), &j);
    json_end(&j);
}

static void json_has_every_row(void **state) {
    (void)state;
    char *text = printed(json);
    assert_has(text, "\"lanes\": ");
    assert_has(text, "\"candidate\": \"ftcs\",\n      \"along_x\": 8,\n      \"outcome\": \"ran\",\n");
    assert_has(text, "\"along_x\": 128,\n      \"outcome\": \"left out\",\n");
    assert_has(text,
               "\"seconds_median\": 5.0000000000000004e-06,\n      \"seconds_lowest\": 4.5000000000000001e-06,\n"
               "      \"seconds_highest\": 6.0000000000000002e-06,\n      \"work\": 120,\n"
               "      \"front_time\": 0,\n      \"front_work\": 1\n");
    free(text);
}

static void machine_line_lists_vector_flags(void **state) {
    (void)state;
    char *text = printed(bench_print_machine);
    assert_has(text, "processor  ");
    assert_has(text, " cores, vectors of ");
    assert_has(text, "\nflags      -std=c11 -ffp-contract=off -fopenmp ");
    assert_has(text, "\ntimes      median of 5 runs after one to warm up\n\n");
    free(text);
}

/* A row is on a front where no other has at most its error for at most its cost. */
static void front_is_pareto_optimal(void **state) {
    (void)state;
    static struct bench_scene b;
    struct command r;
    struct failure why;
    if (command_read("run rod-cosine ftcs --dx 0.1", &r, &why)) fail_msg("%s", why.text);
    bench_run(&r.experiment, BENCH_LONG, 0.2, &b);
    int fronts = 0, ran = 0;
    for (const struct bench_row *p = b.row; p < b.row + b.count; p++) {
        int beaten[2] = {0, 0};
        if (bench_outcome(p)) continue;
        ran++;
        assert_order(p->time.lowest, <=, p->time.median);
        assert_order(p->time.median, <=, p->time.highest);
        for (const struct bench_row *q = b.row; q < b.row + b.count; q++)
            for (int by_work = 0; by_work < 2 && !bench_outcome(q); by_work++)
                beaten[by_work] |= q->result.error[NORM_L1] <= p->result.error[NORM_L1] &&
                                   bench_cost(q, by_work) <= bench_cost(p, by_work) &&
                                   (q->result.error[NORM_L1] < p->result.error[NORM_L1] ||
                                    bench_cost(q, by_work) < bench_cost(p, by_work));
        assert_int_equal(p->front_time, !beaten[0]);
        assert_int_equal(p->front_work, !beaten[1]);
        fronts += p->front_time + p->front_work;
    }
    assert_order(ran, >=, 1); /* the first is not predicted, and runs on any machine */
    assert_order(fronts, >=, 2);
    command_free(&r);
}

static void scenes_of_each_dimension_are_timed(void **state) {
    (void)state;
    static const char *const lines[] = {"run rod-cosine ftcs --dx 0.1", "run wave so_ssph --dx 0.1",
                                        "run box-cosine ftcs --dx 0.2"};
    for (int dim = 1; dim <= 3; dim++) {
        static struct bench_scene b;
        struct command r;
        struct failure why;
        if (command_read(lines[dim - 1], &r, &why)) fail_msg("%s", why.text);
        b = (struct bench_scene){.scene = r.experiment.scene};
        bench_climb(bench_candidates, &r.experiment, bench_candidate_unit(&r.experiment.problem), 0.01, &b);
        assert_in_range(b.row[0].n, 8, 32);
        command_free(&r);
    }
}

static void brief_benchmark_has_every_method(void **state) {
    (void)state;
    for (const struct method *const *m = methods; *m; m++) {
        int in = 0;
        for (const struct candidate *c = bench_candidates; c->label; c++)
            in += c->in != BENCH_LONG && method_find(c->method) == *m;
        if (!in) fail_msg("%s has no candidate", (*m)->name);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_list_fronts_and_refused_candidates),
        cmocka_unit_test(charts_have_one_block_per_candidate_and_front),
        cmocka_unit_test(json_has_every_row),
        cmocka_unit_test(machine_line_lists_vector_flags),
        cmocka_unit_test(front_is_pareto_optimal),
        cmocka_unit_test(brief_benchmark_has_every_method),
        cmocka_unit_test(scenes_of_each_dimension_are_timed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
