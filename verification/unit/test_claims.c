/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Claims: that no verdict can come from anywhere but a measurement, and that none can change unseen. */
#include "reports/ledger/claims.h"
#include "reports/ledger/claim.h"
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

static const struct claims_reading *const none = (const struct claims_reading[]){{0}};

static struct claims_row row(const struct claims_reading *reading, enum claims_verdict expected) {
    return (struct claims_row){
        "test/a", "a test, \"eq. 1\"", "|G| <= 1, always", claims_read, "a rule of 1 %", expected, "because",
        reading};
}

static struct claims_measured judge(const struct claims_reading *reading, enum claims_verdict expected) {
    struct claims_row r = row(reading, expected);
    struct claims_measured m;
    claims_judge(&r, &m);
    return m;
}

static void assert_holds_text(const char *text, const char *part) {
    if (!strstr(text, part)) fail_msg("\"%s\" does not hold \"%s\"", text, part);
}

#define FORTY "run rod-step ftcs --dx 0.1 --fourier 0.2" /* 4 m */
#define EIGHTY "run rod-step ftcs --dx 0.05 --fourier 0.2"
#define MIDWAY "ladder rod-step so_ssph --dx 4/40,4/80,4/160,4/320"
#define ON_ONE "ladder rod-step so_ssph --dx 4/44,4/84,4/164,4/324"

static void verdict_follows_the_measured_numbers(void **state) {
    (void)state;
    struct claims_reading r[] = {{CLAIMS_STATED, 0, "n", "", FORTY, "particles", 40, 40}, {0}};
    struct claims_measured m = judge(r, CLAIMS_REPRODUCED);
    assert_int_equal(m.verdict, CLAIMS_REPRODUCED);
    assert_int_equal(m.count, 1);
    assert_near(m.number[0].value, 40, 0);
    assert_holds_text(m.reason, "a rule of 1 %; because");
    r[0].lo = 41, r[0].hi = 50;
    assert_int_equal(judge(r, CLAIMS_CONTRADICTED).verdict, CLAIMS_CONTRADICTED);
    r[0].lo = 30, r[0].hi = 39;
    assert_int_equal(judge(r, CLAIMS_CONTRADICTED).verdict, CLAIMS_CONTRADICTED);
    struct claims_row printed = {.id = "test/b", .measure = song_printed_orders, .why = ""};
    claims_judge(&printed, &m);
    assert_near(m.number[1].value, 2.0283850, 1e-6); /* least squares through the six printed errors, by hand */
}

static void condition_verdict_needs_the_published_case(void **state) {
    (void)state;
    struct claims_reading r[] = {{CLAIMS_STATED, 0, "midway", "", MIDWAY, "order", 1.9, 2.1},
                                 {CLAIMS_WIDER, 0, NULL, "", ON_ONE, "order", 1.9, 2.1},
                                 {0}};
    struct claims_measured m = judge(r, CLAIMS_CONDITION);
    assert_int_equal(m.verdict, CLAIMS_CONDITION);
    assert_int_equal(m.count, 2);
    assert_string_equal(m.number[1].name, ON_ONE + strlen("ladder "));
    assert_near(m.number[1].value, 1, 0.05);
    r[1].part = CLAIMS_SHOWN;
    assert_int_equal(judge(r, CLAIMS_REPRODUCED).verdict, CLAIMS_REPRODUCED);
    r[1].part = CLAIMS_STATED;
    assert_int_equal(judge(r, CLAIMS_CONTRADICTED).verdict, CLAIMS_CONTRADICTED);
}

/* In units of an earlier reading, of either sign. */
static void bands_are_in_units_of_another_reading(void **state) {
    (void)state;
    struct claims_reading twice[] = {{CLAIMS_SHOWN, 0, "n", "", FORTY, "particles", 0, 0},
                                     {CLAIMS_STATED, 1, "n", "", EIGHTY, "particles", 1.9, 2.1},
                                     {0}};
    struct claims_reading flux[] = {
        {CLAIMS_SHOWN, 0, "q", "", "run rod-cooling so_ssph --dx 0.03 --quantity flux_x_hi", "quantity_exact", 0, 0},
        {CLAIMS_STATED, 1, "q", "", "run rod-cooling so_ssph --dx 0.03 --quantity flux_x_hi", "quantity_exact", 0.5,
         1.5},
        {0}};
    assert_int_equal(judge(twice, CLAIMS_REPRODUCED).verdict, CLAIMS_REPRODUCED);
    twice[1].hi = 1.95;
    assert_int_equal(judge(twice, CLAIMS_CONTRADICTED).verdict, CLAIMS_CONTRADICTED);
    struct claims_measured m = judge(flux, CLAIMS_REPRODUCED);
    assert_true(m.number[0].value < 0);
    assert_int_equal(m.verdict, CLAIMS_REPRODUCED);
}

static void changed_verdict_fails(void **state) {
    (void)state;
    const struct claims_reading forty[] = {{CLAIMS_STATED, 0, "n", "", FORTY, "particles", 40, 40}, {0}};
    struct claims_row r = row(forty, CLAIMS_CONDITION);
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
        const char *command, *key, *reason;
    } bad[] = {{"run rod-setp so_ssph --dx 1", "error_l1", "unknown scene 'rod-setp'"},
               {"run rod-step so_ssph --set L=1.9 --dx 0.25", "error_l1", "--dx 0.25"},
               {"run rod-step so_ssph --dx 0.25 --h 9", "error_l1", "--h"},
               {FORTY, "no such key", "not finite"},
               {FORTY, "quantity", "not finite"},
               {"ladder rod-step so_ssph --dx 0.5,0.25,0.125", "order", "at least 4 must"},
               {NULL, NULL, "nothing was measured"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int expected = CLAIMS_UNMEASURED; expected <= CLAIMS_UNEXPLAINED; expected++) {
            const struct claims_reading reading[] = {
                {CLAIMS_STATED, 0, "n", "", bad[i].command, bad[i].key, 1.5, 2.5}, {0}};
            struct claims_row r = row(bad[i].command ? reading : none, (enum claims_verdict)expected);
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
        assert_true((r->measure == claims_read) == (r->reading != NULL));
        int numbers = 0;
        for (const struct claims_reading *k = r->reading; k && k->command; k++)
            if (numbers++ < k->of) fail_msg("%s: a band in units of a later number", r->id);
        assert_order(numbers, <=, CLAIMS_NUMBERS);
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
        r[i] = row(none, (enum claims_verdict)(i ? i : CLAIMS_REPRODUCED));
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
    const struct claims_reading forty[] = {{CLAIMS_STATED, 0, "n", "", FORTY, "particles", 40, 40}, {0}};
    struct claims_row r = row(forty, CLAIMS_REPRODUCED);
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
        cmocka_unit_test(bands_are_in_units_of_another_reading),
        cmocka_unit_test(changed_verdict_fails),
        cmocka_unit_test(unmeasured_claim_fails),
        cmocka_unit_test(claim_rows_are_complete_and_unique),
        cmocka_unit_test(claim_rows_hold_when_run),
        cmocka_unit_test(verdicts_are_counted),
        cmocka_unit_test(files_are_written_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
