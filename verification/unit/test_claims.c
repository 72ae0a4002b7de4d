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

static void verdict_follows_the_measured_numbers(void **state) {
    (void)state;
    struct claims_measured m = judge(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    assert_int_equal(m.verdict, CLAIMS_REPRODUCED);
    assert_int_equal(m.count, 1);
    assert_near(m.number[0].value, 2.0283850, 1e-6); /* least squares through the six printed errors, by hand */
    assert_int_equal(judge(ledger_order_printed_order, "1 " SECOND, CLAIMS_CONTRADICTED).verdict,
                     CLAIMS_CONTRADICTED);
    assert_int_equal(judge(ledger_order_printed_order, "2 " FIRST, CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
}

static void condition_verdict_needs_the_published_case(void **state) {
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

/* On that cloud a mode of cspm grows; conjugate is symmetric, and the weights of voronoi_flux are not negative. */
static void only_stable_claim_checks_all_others(void **state) {
    (void)state;
    assert_int_equal(judge(others_only, "conjugate | cspm", CLAIMS_REPRODUCED).verdict, CLAIMS_REPRODUCED);
    assert_int_equal(judge(others_only, "conjugate | voronoi_flux", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
    assert_int_equal(judge(others_only, "cspm | cspm", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
    assert_int_equal(judge(others_orders, "< so_ssph, jitter 0.3", CLAIMS_REPRODUCED).verdict, CLAIMS_CONTRADICTED);
    assert_int_equal(
        judge(others_step, "0.2 1 | kernel_second --dim 2 --layout jitter --jitter 0.3 --seed 1", CLAIMS_CONTRADICTED)
            .verdict,
        CLAIMS_CONTRADICTED);
}

static void changed_verdict_fails(void **state) {
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

static void unmeasured_claim_fails(void **state) {
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

static void claim_rows_are_complete_and_unique(void **state) {
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

static void claim_rows_hold_when_run(void **state) {
    (void)state;
    struct claims c;
    struct failure why;
    assert_int_equal(claims_collect(papers_claims, "pamplona/eq[29]*", &c, &why), STATUS_OK);
    assert_int_equal(c.count, 2);
    double start = omp_get_wtime();
    claims_run(&c);
    double most = omp_get_wtime() - start; /* an upper bound for each */
    for (int i = 0; i < c.count; i++) assert_true(c.result[i].seconds > 0 && c.result[i].seconds <= most);
    for (int i = 0; i < c.count; i++)
        if (!claims_holds(c.result[i].row, &c.result[i].measured)) fail_msg("%s", c.result[i].measured.reason);
    assert_true(claims_hold(&c));
    claims_free(&c);
    assert_int_equal(claims_collect(papers_claims, "pamplona/eq99", &c, &why), STATUS_INPUT);
    assert_holds_text(why.text, "no claim matches 'pamplona/eq99'");
    claims_free(&c);
}

/* A ledger with one of each verdict; the first, not measured, is none expected. */
static void verdicts_are_counted(void **state) {
    (void)state;
    static const char *const due[] = {
        "5 statements of the papers: 1 reproduced, 1 with a condition, 1 contradicted, 1 not "
        "explained, 1 not measured; 1 verdict is not as expected\n",
        "song/odd: reproduced\n  published  |G| <= 1, always (a test, \"eq. 1\")\n  "
        "measured   first -1.25 K; next 3\n"
        "  because    reason 1\n\n",
        "  published  |G| <= 1, always: 0.5, 0.25 (a test, \"eq. 1\")\n"};
    struct claims_row r[5];
    struct claims_result result[5];
    char *text[3] = {0};
    size_t size;
    void (*const print[])(const struct claims *c, FILE *out) = {claims_write_text, claims_write_changed,
                                                                claims_write_json};
    for (int i = 0; i < 5; i++) {
        r[i] = row(NULL, "", (enum claims_verdict)(i ? i : CLAIMS_REPRODUCED));
        r[i].id = i % 2 ? "song/odd" : "pamplona/even";
        result[i] = (struct claims_result){.row = &r[i], .seconds = 0.25};
        struct claims_measured *m = &result[i].measured;
        *m = (struct claims_measured){
            .verdict = (enum claims_verdict)i, .count = 2, .number = {{"first", "K", -1.25}, {"next", "", 3}}};
        snprintf(m->reason, sizeof m->reason, "reason %d", i);
        snprintf(m->published, sizeof m->published, "%s", i == 4 ? "0.5, 0.25" : "");
    }
    for (int k = 0; k < 3; k++) {
        FILE *out = open_memstream(&text[k], &size);
        print[k](&(struct claims){5, result}, out);
        fclose(out);
    }
    for (size_t i = 0; i < sizeof due / sizeof *due; i++) assert_has(text[0], due[i]);
    assert_has(text[1], "pamplona/even: not measured\n");
    assert_lacks(text[1], "reason 1\n");
    assert_has(text[2], "\"name\": \"first\",\n          \"value\": -1.25,\n          \"unit\": \"K\"\n");
    assert_has(text[2], "\"expected\": \"reproduced\"");
    for (int k = 0; k < 3; k++) free(text[k]);
}

static void files_are_written_or_refused(void **state) {
    (void)state;
    char dir[UNIT_PATH], path[UNIT_PATH + 64];
    struct claims_row r = row(ledger_order_printed_order, "2 " SECOND, CLAIMS_REPRODUCED);
    struct claims_result result = {.row = &r};
    struct failure why;
    assert_non_null(scratch_directory(dir, "test_claims"));
    claims_judge(&r, &result.measured);
    assert_int_equal(claims_write_files(&(struct claims){1, &result}, dir, &why), STATUS_OK);
    for (int i = 0; i < 2; i++) {
        snprintf(path, sizeof path, "%s/claims.%s", dir, i ? "md" : "html");
        assert_int_equal(unlink(path), 0);
    }
    assert_int_equal(rmdir(dir), 0); /* nothing else was left there */
    assert_int_equal(claims_write_files(&(struct claims){1, &result}, "/nowhere/at/all", &why), STATUS_INPUT);
    assert_holds_text(why.text, "/nowhere/at/all");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdict_follows_the_measured_numbers),
        cmocka_unit_test(condition_verdict_needs_the_published_case),
        cmocka_unit_test(only_stable_claim_checks_all_others),
        cmocka_unit_test(changed_verdict_fails),
        cmocka_unit_test(unmeasured_claim_fails),
        cmocka_unit_test(claim_rows_are_complete_and_unique),
        cmocka_unit_test(claim_rows_hold_when_run),
        cmocka_unit_test(verdicts_are_counted),
        cmocka_unit_test(files_are_written_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
