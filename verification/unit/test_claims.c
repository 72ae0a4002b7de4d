/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Claims: that no verdict can come from anywhere but a measurement, and that none can change unseen. */
#include "reports/ledger/claims.h"
#include "reports/ledger/claim.h"
#include "reports/ledger/order.h"
#include "reports/operators/operators.h"
#include "reports/papers.h"
#include "reports/song/song.h"

#include "solver/method.h"
#include "verification/text/output.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef void take(struct claims_measured *m);

static struct claims_row row(take *measure, const char *argument, enum claims_verdict expected) {
    return (struct claims_row){"test/a", "a test, \"eq. 1\"", "|G| <= 1, always", measure, argument, expected,
                               "because"};
}

static struct claims_measured judge(take *measure, const char *argument, enum claims_verdict expected) {
    struct claims_row r = row(measure, argument, expected);
    struct claims_measured m;
    claims_judge(&r, &m);
    return m;
}

static void assert_holds_text(const char *text, const char *part) {
    if (!strstr(text, part)) fail_msg("\"%s\" does not hold \"%s\"", text, part);
}

/* Printed errors of second and of first order */
#define SECOND "song_table1 so_ssph"
#define FIRST "song_table1 fo_ssph"

static void the_numbers_decide(void **state) {
    (void)state;
    struct claims_measured m = judge(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    assert_int_equal(m.verdict, CLAIMS_REPRODUCED);
    assert_int_equal(m.count, 1);
    assert_near(m.number[0].value, 2.0283850, 1e-6); /* least squares through the six printed errors, by hand */
    assert_int_equal(judge(ledger_order_printed_order, "1 " SECOND, CLAIMS_CONTRADICTED).verdict,
                     CLAIMS_CONTRADICTED);
    assert_int_equal(judge(ledger_order_printed_order, "2 " FIRST, CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
}

static void a_condition_is_what_holds_as_published_alone(void **state) {
    (void)state;
    static const char midway[] = "2 | midway: rod-step so_ssph --dx 4/40,4/80,4/160,4/320 | "
                                 "on a particle: rod-step so_ssph --dx 4/44,4/84,4/164,4/324";
    struct claims_measured m = judge(ledger_order_order, midway, CLAIMS_CONDITION);
    assert_int_equal(m.verdict, CLAIMS_CONDITION);
    assert_int_equal(m.count, 2);
    assert_holds_text(m.number[1].name, "on a particle");
    assert_near(m.number[1].value, 1, 0.05);
    m = judge(ledger_order_order, "2 | on a particle: rod-step so_ssph --dx 4/44,4/84,4/164,4/324", CLAIMS_CONDITION);
    assert_int_equal(m.verdict, CLAIMS_CONTRADICTED);
}

/* On that cloud a mode of cspm grows; of conjugate, which is symmetric, none does, nor of voronoi_flux, whose weights
 * are not negative. */
static void the_only_stable_one_is_alone(void **state) {
    (void)state;
    assert_int_equal(judge(others_only, "conjugate | cspm", CLAIMS_REPRODUCED).verdict, CLAIMS_REPRODUCED);
    assert_int_equal(
        judge(others_orders, "> brookshaw, jitter 0 | + > brookshaw, jitter 0.3", CLAIMS_CONDITION).verdict,
        CLAIMS_CONDITION);
    assert_int_equal(judge(others_orders, "< so_ssph, jitter 0.3", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
    assert_int_equal(
        judge(others_step, "0.2 1 | kernel_second --dim 2 --layout jitter --jitter 0.3 --seed 1", CLAIMS_CONTRADICTED)
            .verdict,
        CLAIMS_CONTRADICTED);
    assert_int_equal(judge(others_only, "conjugate | voronoi_flux", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
    assert_int_equal(judge(others_only, "cspm | cspm", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
}

static void a_verdict_that_changes_is_seen(void **state) {
    (void)state;
    struct claims_row r = row(ledger_order_printed_order, "2 " SECOND, CLAIMS_CONDITION);
    struct claims_measured m;
    claims_judge(&r, &m);
    assert_int_equal(m.verdict, CLAIMS_REPRODUCED);
    assert_false(claims_holds(&r, &m));
    assert_holds_text(m.reason, "the verdict changed, expected: reproduced with a condition");
    struct claims_result result = {&r, m, 0};
    struct claims c = {1, &result};
    assert_false(claims_hold(&c));
    r.expected = CLAIMS_REPRODUCED;
    assert_true(claims_hold(&c));
    assert_false(claims_hold(&(struct claims){0, NULL}));
}

static void what_cannot_be_measured_never_holds(void **state) {
    (void)state;
    static const struct {
        take *measure;
        const char *argument, *reason;
    } bad[] = {
        {ledger_order_order, "2 | rod-setp so_ssph --dx 1,0.5", "unknown scene 'rod-setp'"},
        {ledger_order_table, "song_table9 | rod-step --h 1.05", "there is no reports/published/song_table9.csv"},
        {ledger_order_table, "song_table1 | rod-step --set L=1.9", "--dx 0.25"},
        {ledger_order_table, "song_table1 | rod-step --h 9", "--h"},
        {ledger_order_printed_order, "2 song_table1 ftcs", "not finite"},
        {ledger_order_printed_order, "", "nothing was measured"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int expected = CLAIMS_UNMEASURED; expected <= CLAIMS_UNEXPLAINED; expected++) {
            struct claims_row r = row(bad[i].measure, bad[i].argument, (enum claims_verdict)expected);
            struct claims_measured m;
            claims_judge(&r, &m);
            assert_int_equal(m.verdict, CLAIMS_UNMEASURED);
            assert_false(claims_holds(&r, &m));
            assert_holds_text(m.reason, bad[i].reason);
        }
}

static void rows_are_whole_and_named_once(void **state) {
    (void)state;
    int n = 0;
    for (const struct claims_row *r = papers_claims; r->id; r++, n++) {
        assert_true(strcspn(r->id, "/") > 0 && strchr(r->id, '/')); /* the paper, and its statement */
        assert_true(*r->source && *r->published && r->measure);
        assert_int_not_equal(r->expected, CLAIMS_UNMEASURED);
        for (const struct claims_row *other = papers_claims; other < r; other++)
            assert_string_not_equal(other->id, r->id);
    }
    assert_order(n, >, 60);
}

static void rows_hold_when_run(void **state) {
    (void)state;
    struct claims c;
    struct failure why;
    assert_int_equal(claims_collect(papers_claims, "pamplona/eq[29]*", &c, &why), STATUS_OK);
    assert_int_equal(c.count, 2);
    double start = omp_get_wtime();
    claims_run(&c);
    double most = omp_get_wtime() - start; /* what each of them took at most */
    for (int i = 0; i < c.count; i++) assert_true(c.result[i].seconds > 0 && c.result[i].seconds <= most);
    for (int i = 0; i < c.count; i++)
        if (!claims_holds(c.result[i].row, &c.result[i].measured)) fail_msg("%s", c.result[i].measured.reason);
    assert_true(claims_hold(&c));
    claims_free(&c);
    assert_int_equal(claims_collect(papers_claims, "pamplona/eq99", &c, &why), STATUS_INPUT);
    assert_holds_text(why.text, "no claim matches 'pamplona/eq99'");
    claims_free(&c);
}

static void every_number_that_a_reader_needs_is_there(void **state) {
    (void)state;
    struct claims_row r = row(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    struct claims_result result = {.row = &r, .seconds = 0.25};
    char numbers[80];
    claims_judge(&r, &result.measured);
    claims_numbers(&result.measured, numbers, sizeof numbers);
    assert_string_equal(numbers, "slope of song_table1 so_ssph 2.028");
    claims_numbers(&result.measured, numbers, 6);
    assert_string_equal(numbers, "slope");
}

/* What one claim looks like in a file of each kind. */
static char *printed(void (*print)(const struct claims *c, FILE *out)) {
    struct claims_row r = row(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    r.id = "song/test";
    struct claims_result result = {.row = &r, .seconds = 0.25};
    struct claims c = {1, &result};
    char *text = NULL;
    size_t size = 0;
    claims_judge(&r, &result.measured);
    FILE *out = open_memstream(&text, &size);
    print(&c, out);
    fclose(out);
    return text;
}

static void json_has_the_fields_of_the_contract(void **state) {
    (void)state;
    static const char *const part[] = {"\"claims\": [",
                                       "\"id\": \"song/test\"",
                                       "\"source\": \"a test, \\\"eq. 1\\\"\"",
                                       "\"published\": \"|G| <= 1, always\"",
                                       "\"measured\": \"slope of song_table1 so_ssph 2.028\"",
                                       "\"name\": \"slope of song_table1 so_ssph\"",
                                       "\"verdict\": \"reproduced\"",
                                       "\"expected\": \"reproduced\"",
                                       "\"reason\": \"slope of the printed numbers"};
    char *text = printed(claims_write_json);
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) assert_holds_text(text, part[i]);
    free(text);
}

static void tables_keep_quotes_and_bars(void **state) {
    (void)state;
    char *text = printed(claims_write_csv);
    assert_holds_text(text, "id,source,published,measured,verdict,expected,reason\n");
    assert_holds_text(text, "\"song/test\",\"a test, \"\"eq. 1\"\"\",\"|G| <= 1, always\",\"slope of song_table1 "
                            "so_ssph 2.028\",\"reproduced\"");
    free(text);
    text = printed(claims_write_markdown);
    assert_holds_text(text, "| \\|G\\| \\<= 1, always ");
    assert_holds_text(text, "| *reproduced* ");
    assert_lacks(text, "0.25"); /* no time: equal verdicts make equal files */
    free(text);
    text = printed(claims_write_text);
    assert_holds_text(text, "1 claims: 1 reproduced, 0 with a condition, 0 contradicted, 0 not explained, 0 not "
                            "measured; 0 verdicts changed");
    free(text);
}

/* One of each verdict; `changed` of them were expected to be another, from the last on. */
static char *printed_verdicts(int changed, void (*print)(const struct claims *c, FILE *out)) {
    struct claims_row r[6];
    struct claims_result result[6];
    char *text = NULL;
    size_t size = 0;
    for (int i = 0; i < 6; i++) {
        enum claims_verdict v = (enum claims_verdict)(i < 5 ? i : CLAIMS_CONDITION);
        int as_expected = i > 0 && i < 7 - changed;
        r[i] = row(NULL, "", as_expected ? v : v == CLAIMS_REPRODUCED ? CLAIMS_CONDITION : CLAIMS_REPRODUCED);
        r[i].id = i % 2 ? "song/odd" : "pamplona/even";
        result[i] = (struct claims_result){.row = &r[i], .seconds = 0.25};
        struct claims_measured *m = &result[i].measured;
        *m = (struct claims_measured){.verdict = v, .count = 2, .number = {{"first", "K", -1.25}, {"next", "", 3}}};
        snprintf(m->reason, sizeof m->reason, "reason %d", i);
        snprintf(m->published, sizeof m->published, "%s", i == 5 ? "0.5, 0.25" : "");
    }
    FILE *out = open_memstream(&text, &size);
    print(&(struct claims){6, result}, out);
    fclose(out);
    return text;
}

static void verdicts_are_counted(void **state) {
    (void)state;
    static const char counts[] = "6 claims: 1 reproduced, 2 with a condition, 1 contradicted, 1 not explained";
    char due[200];
    for (int changed = 1; changed <= 2; changed++) { /* one was not measured, which is none expected */
        char *text = printed_verdicts(changed, claims_write_text);
        snprintf(due, sizeof due, "%s, 1 not measured; %d verdict%s changed\n", counts, changed,
                 changed == 1 ? "" : "s");
        assert_has(text, due);
        assert_has(text, "song/odd: reproduced\n  published  |G| <= 1, always (a test, \"eq. 1\")\n"
                         "  measured   first -1.25 K; next 3\n  because    reason 1\n\n");
        assert_has(text, "  published  |G| <= 1, always: 0.5, 0.25 (a test, \"eq. 1\")\n");
        free(text);
        text = printed_verdicts(changed, claims_write_changed);
        assert_has(text, "pamplona/even: not measured\n");
        assert_lacks(text, "reason 1\n");
        assert_int_equal(strstr(text, "reason 5\n") != NULL, changed == 2);
        free(text);
        text = printed_verdicts(changed, claims_write_markdown);
        snprintf(due, sizeof due, "%s.\n\n**%d verdicts differ from those expected.**\n\n## Song", counts, changed);
        assert_has(text, due);
        assert_has(text, "|---|---|---|---|---|---|\n| song/odd | a test");
        assert_has(text, "|---|---|---|---|---|---|\n| pamplona/even | a test");
        assert_has(text, "| *not measured* | reason 0 |\n| pamplona/even |");
        free(text);
        text = printed_verdicts(changed, claims_write_json);
        assert_has(text, "\"name\": \"first\",\n          \"value\": -1.25,\n          \"unit\": \"K\"\n");
        assert_has(text, "\"seconds\": 0.25");
        free(text);
    }
}

static void files_are_written_or_refused(void **state) {
    (void)state;
    char dir[UNIT_PATH], path[UNIT_PATH + 64];
    struct claims_row r = row(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    struct claims_result result = {.row = &r};
    struct claims c = {1, &result};
    struct failure why;
    assert_non_null(scratch_directory(dir, "test_claims"));
    claims_judge(&r, &result.measured);
    assert_int_equal(output_directory(dir, "claims.csv", &why), STATUS_OK);
    assert_int_equal(claims_write_files(&c, dir, &why), STATUS_OK);
    static const char *const name[] = {"claims.csv", "claims.md"};
    for (int i = 0; i < 2; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, name[i]);
        assert_int_equal(unlink(path), 0);
    }
    assert_int_equal(rmdir(dir), 0); /* nothing else was left there */
    assert_int_equal(output_directory("/nowhere/at/all", "claims.csv", &why), STATUS_INPUT);
    assert_holds_text(why.text, "/nowhere/at/all");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_numbers_decide),
        cmocka_unit_test(a_condition_is_what_holds_as_published_alone),
        cmocka_unit_test(the_only_stable_one_is_alone),
        cmocka_unit_test(a_verdict_that_changes_is_seen),
        cmocka_unit_test(what_cannot_be_measured_never_holds),
        cmocka_unit_test(rows_are_whole_and_named_once),
        cmocka_unit_test(rows_hold_when_run),
        cmocka_unit_test(every_number_that_a_reader_needs_is_there),
        cmocka_unit_test(json_has_the_fields_of_the_contract),
        cmocka_unit_test(tables_keep_quotes_and_bars),
        cmocka_unit_test(verdicts_are_counted),
        cmocka_unit_test(files_are_written_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
