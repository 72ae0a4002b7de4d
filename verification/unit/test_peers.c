/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench --peers: rows whose programs are stand-ins, so that seconds and errors are known beforehand. */
#include "verification/bench/peers.h"

#include "solver/status.h"
#include "verification/text/output.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROD .scene = "rod-cosine", .side = "1"
/* E1 = dx^2 + tolerance in 2e-5/dx^2 s: E = 1e-3 at dx^2 = 1e-3, in 0.02 s. */
#define STAND_IN "f() { awk -v error=second -v tolerance=$1 -f verification/unit/stand_in.awk {case} >{out}; }; "

static const struct peer table[] = {
    {ROD, .who = "good", .command = STAND_IN "f", .settings = "1e-12 1e-7 1e-2", .gate = {1.9, 2.1},
     .n = {10, 20, 40, 80}},
    {ROD, .who = "absent", .command = "[ -x /nowhere/absent ] || exit 77; : {case} {out}", .gate = {1.9, 2.1},
     .n = {10, 20}},
    {ROD, .who = "crashing", .command = "echo so, much, for that; exit 3; : {case} {out}", .settings = "1e-3 1e-2",
     .gate = {1.9, 2.1}, .n = {10, 20}},
    {ROD, .who = "partial", .command = STAND_IN "[ {dx} = 0.05 ] && exit 77; f 0", .serial = 1, .n = {10, 20, 40}},
    {ROD, .who = "so_ssph rkl2", .kind = PEERS_OURS, .command = "so_ssph --stepper rkl2", .serial = 1,
     .settings = "1e-5 1e-4", .n = {16}},
    {.scene = "plate", .side = "0.1", .who = "elsewhere", .command = "exit 9; : {case} {out}", .n = {16}},
    {.scene = NULL},
};

struct told { /* what one run of the table told */
    struct peers all;
    char *runs;
};

static int run(void **state) {
    struct told *told = xcalloc(1, sizeof *told);
    struct failure why;
    size_t size;
    setenv("PYTHON", "true", 1); /* no versions are asked for */
    told->all = (struct peers){.threads = 2};
    told->all.runs = open_memstream(&told->runs, &size);
    int status = peers_run(table, "rod-cosine", &told->all, &why);
    fclose(told->all.runs);
    *state = told;
    return status;
}

static int forget(void **state) {
    struct told *told = *state;
    peers_free(&told->all);
    free(told->runs);
    free(told);
    return 0;
}

static const char *table_of(const struct peers *all, struct output *page) {
    peers_print(all, output_open(page, "table"));
    output_end(page);
    return page->text;
}

static void rows_are_tuned_timed_and_judged(void **state) {
    const struct told *told = *state;
    static const int repeats[] = {9, 5, 5, 3}; /* of 2, 8, 32, 128 ms */
    const struct peers_row *good = told->all.row, *ours = told->all.row + 4;
    assert_ptr_equal(told->all.row[5].peer, NULL); /* the other scene was not asked for */
    assert_int_equal(good->sizes, 4);
    for (int i = 0; i < 4; i++) {
        double dx = 1.0 / table[0].n[i];
        const struct peers_size *s = &good->size[i];
        assert_string_equal(s->setting, "1e-7"); /* 1e-2 is at least as much as dx^2 */
        for (int many = 0; many < 2; many++) {
            assert_int_equal(s->with[many].count, repeats[i]);
            assert_near(s->with[many].error, dx * dx + 1e-7, 1e-12);
            assert_near(s->with[many].time.median, 2e-5 / (dx * dx), 1e-9);
        }
    }
    assert_string_equal(good->order, "pass: 2.00 (1.9 to 2.1)");
    assert_has(told->runs, "scene,threads,kind,who,n,setting,E1,solve,whole,updates,failure\n"
                           "rod-cosine,1,peer,good,10,1e-7,0.0100001");
    assert_int_equal(ours->size[0].with[0].count > 0, 1);
    assert_has(ours->size[0].setting, "--dt 0.");
    assert_has(told->runs, "\nrod-cosine,2,peer,good,10,1e-7,0.0100001");
    assert_has(told->runs, "\nrod-cosine,1,ours,so_ssph rkl2,16,--dt 0.");
}

static void what_does_not_answer_is_told(void **state) {
    const struct told *told = *state;
    struct output page;
    const char *text = table_of(&told->all, &page);
    const struct peers_row *absent = told->all.row + 1, *crashing = told->all.row + 2, *partial = told->all.row + 3;
    assert_int_equal(absent->missing, 1);
    assert_ptr_equal(strstr(told->runs, "absent"), NULL);
    assert_has(text, "\nnot installed (make setup-peers): absent on rod-cosine\n");
    assert_int_equal(crashing->missing, 0);
    assert_int_equal(crashing->size[1].with[1].count, 0);
    assert_has(
        told->runs,
        "\nrod-cosine,1,peer,crashing,20,1e-3,,,,,--solver: exit status 3; it said last: so; much; for that\n");
    assert_has(text, "\nfailed: rod-cosine, crashing, n = 10, one thread: --solver: exit status 3");
    assert_string_equal(crashing->order, "fail: nan (1.9 to 2.1)");
    assert_int_equal(partial->missing, 0); /* one size is not for it */
    assert_int_equal(partial->size[1].with[0].count, 0);
    assert_int_equal(partial->size[2].with[0].count, 5);
    assert_int_equal(partial->size[2].with[1].count, 0); /* it knows no threads */
    assert_has(text, "failed: rod-cosine, partial, n = 20, one thread: not applicable (exit status 77)");
    output_drop(&page, 1);
}

static void charts_have_a_block_a_program(void **state) {
    const struct told *told = *state;
    struct output page[2];
    for (int many = 0; many < 2; many++) {
        peers_print_data(&told->all, "rod-cosine", many, output_open(&page[many], "chart"));
        output_end(&page[many]);
    }
    const char *one = page[0].text, *both = page[1].text;
    assert_has(one, "# title: rod-cosine: others beside ours, one thread\n# command: make bench-peers\n"
                    "# good\nn,E1 [-],solve [s],good\n10,0.0100001");
    assert_has(one, "\n\n\n# partial\nn,E1 [-],solve [s],partial\n10,");
    assert_has(both, "n,E1 [-],solve [s],partial (one thread)\n10,");
    assert_ptr_equal(strstr(one, "absent"), NULL);
    output_drop(page, 2);
}

/* Two sizes on a line of slope 1 in log E and log t, so that seconds at any error are known. */
static struct peers_row line(const struct peer *p, double seconds) {
    struct peers_row row = {.peer = p, .sizes = 2};
    for (int i = 0; i < 2; i++) {
        double t = seconds * (i ? 100 : 1);
        struct peers_runs runs = {.count = 3, .time = {t, t / 2, t * 2}, .error = i ? 1e-4 : 1e-2, .updates = 1};
        row.size[i] = (struct peers_size){.n = i ? 100 : 10, .with = {runs}};
    }
    return row;
}

static void aims_compare_at_the_same_error(void **state) {
    (void)state;
    static const struct peer who[] = {
        {.scene = "square-step", .who = "so_ssph rkl2", .kind = PEERS_OURS, .serial = 1},
        {.scene = "square-step", .who = "SUNDIALS slow", .serial = 1},
        {.scene = "square-step", .who = "SUNDIALS fast", .serial = 1},
        {.scene = "square-step", .who = "so_ssph rkl2 unfolded", .kind = PEERS_WHOLE, .serial = 1}};
    struct peers_row rows[] = {line(&who[0], 1), line(&who[1], 60), line(&who[2], 50), line(&who[3], 20), {0}};
    struct peers all = {.threads = 1, .row = rows};
    char verdict[2][20];
    struct output page;
    const char *what = "so_ssph rkl2 at E1 = 0.001, SUNDIALS fast", *text = table_of(&all, &page),
               *at = strstr(text, what);
    double ratio, low, high, aim[2], whole, ours, theirs;
    if (!at) fail_msg("%s", text);
    assert_int_equal(sscanf(at + strlen(what), "%lf %lf to %lf %lf %19s %lf %lf %19s %lf %lf", &ratio, &low, &high,
                            &aim[0], verdict[0], &whole, &aim[1], verdict[1], &ours, &theirs),
                     10);
    assert_near(ours, 10, 0);
    assert_near(theirs, 500, 0);
    assert_near(ratio, 50, 0);
    assert_near(low, 12.5, 0); /* half of theirs over twice ours */
    assert_near(high, 200, 0);
    assert_near(whole, 2.5, 0);
    assert_near(aim[0], 10, 0);
    assert_string_equal(verdict[0], "held");
    assert_near(aim[1], 3, 0);
    assert_string_equal(verdict[1], "missed");
    assert_has(text, "so_ssph rkl2 at E1 = 5e-05, SUNDIALS fast"); /* past the finest by a factor of 2 */
    assert_has(text, "~");
    output_drop(&page, 1);
}

static void a_scene_without_rows_is_refused(void **state) {
    (void)state;
    struct failure why;
    struct peers all = {.threads = 1};
    assert_int_equal(peers_run(table, "plat", &all, &why), STATUS_INPUT);
    assert_has(why.text, "did you mean 'plate'? (valid: rod-cosine, plate)");
    peers_free(&all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_tuned_timed_and_judged), cmocka_unit_test(what_does_not_answer_is_told),
        cmocka_unit_test(charts_have_a_block_a_program),   cmocka_unit_test(aims_compare_at_the_same_error),
        cmocka_unit_test(a_scene_without_rows_is_refused),
    };
    return cmocka_run_group_tests_name("peers", tests, run, forget);
}
