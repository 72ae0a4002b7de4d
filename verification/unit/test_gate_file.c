/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of gates as text: valid rows are read, and errors are reported with their position. */
#include "verification/gates/gate_file.h"

#include "solver/status.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define ROW(id) "GATE(\"" id "\", QUICK, \"error\", \"run rod-gauss ftcs --dx 0.5\", 0, 1e-3, NAN, \"small\")\n"

static int read_text(const char *text, struct gate_file *f, struct failure *why) {
    *why = (struct failure){0};
    return gate_file_read(text, strlen(text), "rows", f, why);
}

static void gate_rows_are_read_in_c_syntax(void **state) {
    (void)state;
    struct gate_file f;
    struct failure why;
    const char *text = "/* mine,\n   in two lines */\n" ROW(
        "a/b") "// another\n"
               "GATE ( \"c\" , FULL,\"slope\", \"ladder rod-gauss ftcs \"\n   \"--dx 1,0.5\" /* , */,\n"
               " 1.9, 2.1e0, 1/1000, \"say \\\"why\\\"\\n\" )";
    if (read_text(text, &f, &why)) fail_msg("%s", why.text);
    assert_int_equal(f.count, 2);
    assert_string_equal(f.gate[0].id, "a/b");
    assert_true(f.gate[0].tier == TIER_QUICK && f.gate[0].lo == 0 && f.gate[0].hi == 1e-3 &&
                isnan(f.gate[0].ceiling));
    assert_string_equal(f.gate[1].command, "ladder rod-gauss ftcs --dx 1,0.5");
    assert_string_equal(f.gate[1].why, "say \"why\"\n");
    assert_true(f.gate[1].tier == TIER_FULL && f.gate[1].hi == 2.1 && f.gate[1].ceiling == 1e-3);
    gate_file_free(&f);
}

static void errors_are_reported_with_their_position(void **state) {
    (void)state;
    static const struct {
        const char *text, *said;
    } bad[] = {
        {"", "rows, line 1, column 1: no row"},
        {" /* only */ ", "no row"},
        {"/* open", "line 1, column 1: this comment has no end"},
        {ROW("a") "gate(1)", "line 2, column 1: expected GATE(...), found gate(1)"},
        {"GATE[", "column 5: expected '(', found ["},
        {"GATE(a", "column 6: expected the id in \"...\", found a"},
        {"GATE(\"a", "column 6: this text has no closing \""},
        {"GATE(\"a\nb\"", "line 1, column 6: this text has no closing \""},
        {"GATE(\"\", QUICK", "the id is empty"},
        {"GATE(\"a\" QUICK", "column 10: expected ',', found QUICK"},
        {"GATE(\"a\", quick,", "column 11: expected QUICK or FULL, found quick,"},
        {"GATE(\"a\\x\", QUICK", "of escapes"},
        {"GATE(\"a\", QUICK, \"error\", \"run\", zero", "expected the lower bound, a number or NAN, found zero"},
        {"GATE(\"a\", QUICK, \"error\", \"run\", 0, 1, NAN, \"w\"", "expected ')', found the end of the line"},
        {"GATE(\"a\", QUICK, \"error\", \"run\", 0, 1, NAN, \"w\"\n,", "line 2, column 1: expected ')', found ,"},
        {"GATE(\"a\", QUICK, \"eror\", \"run\", 0, 1, NAN, \"w\")", "unknown measure 'eror'; did you mean 'error'?"},
        {"GATE(\"a\", QUICK, \"error\", \"run\", 2, 1, NAN, \"w\")", "2 to 1 is no band"},
        {"GATE(\"a\", QUICK, \"slope\", \"ladder\", 1, 2, -1, \"w\")", "the ceiling -1 bounds no error"},
        {ROW("a") ROW("b") ROW("a"), "the row 'a' is there twice"},
        {"GATE(\"a\", QUICK, \"error\", \"run\", 0.0000000000000000000000000000000000000000001, 1, NAN, \"w\")",
         "more than 39 letters"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct gate_file f;
        struct failure why;
        assert_int_equal(read_text(bad[i].text, &f, &why), STATUS_INPUT);
        if (!strstr(why.text, bad[i].said)) fail_msg("\"%s\" does not say \"%s\"", why.text, bad[i].said);
        gate_file_free(&f);
    }
}

/* Any bytes, also truncated anywhere, are either read or refused; a sanitizer detects accesses outside them. */
/* NAN is no ceiling, for an order too. */
static void a_row_needs_no_ceiling(void **state) {
    (void)state;
    struct gate_file f;
    struct failure why;
    const char *text =
        "GATE(\"a\", QUICK, \"slope\", \"ladder rod-gauss ftcs --dx 1,0.5,0.25,0.125\", 1, 3, NAN, \"w\")";
    assert_int_equal(read_text(text, &f, &why), STATUS_OK);
    struct gates g = {0};
    gates_add(&g, &f.gate[0]);
    gates_read(&g);
    gates_run_row(&g, &g.result[0], NULL);
    assert_int_equal(g.result[0].measured.verdict, VERDICT_PASS);
    gates_free(&g);
    gate_file_free(&f);
}

static void any_bytes_are_read_or_refused(void **state) {
    (void)state;
    const char *text = "/**/GATE(\"a\", QUICK, \"error\", \"r\" \"\\\"\", -1, INFINITY, NAN, \"w\") // ";
    for (size_t n = 0; n <= strlen(text); n++) {
        struct gate_file f;
        struct failure why = {0};
        char *part = malloc(n + 1);
        memcpy(part, text, n);
        part[n] = '\1';
        int status = gate_file_read(part, n, "rows", &f, &why);
        assert_true(status == STATUS_INPUT || f.count == 1);
        gate_file_free(&f);
        free(part);
    }
}

static void missing_files_are_refused(void **state) {
    (void)state;
    struct gate_file f;
    struct failure why = {0};
    assert_int_equal(gate_file_open("/nonexistent/rows", &f, &why), STATUS_INPUT);
    assert_has(why.text, "--gates /nonexistent/rows: No such file");
    gate_file_free(&f);
    assert_int_equal(gate_file_open("verification", &f, &why), STATUS_INPUT);
    assert_has(why.text, "Is a directory");
    gate_file_free(&f);
    assert_int_equal(gate_file_open("/dev/null", &f, &why), STATUS_INPUT);
    assert_has(why.text, "no row");
    gate_file_free(&f);
}

static void link_to_a_gate_file_is_followed(void **state) {
    (void)state;
    struct gate_file f;
    struct failure why;
    char here[UNIT_PATH], path[UNIT_PATH + 64], *rows = realpath("verification/unit/corpus/gates/cooling", NULL);
    assert_non_null(scratch_directory(here, "gates-test"));
    snprintf(path, sizeof path, "%s/rows", here);
    assert_int_equal(symlink(rows, path), 0);
    int status = gate_file_open(path, &f, &why);
    unlink(path);
    remove(here);
    if (status) fail_msg("%s", why.text);
    assert_order(f.count, >, 5);
    gate_file_free(&f);
    free(rows);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gate_rows_are_read_in_c_syntax), cmocka_unit_test(errors_are_reported_with_their_position),
        cmocka_unit_test(a_row_needs_no_ceiling),         cmocka_unit_test(any_bytes_are_read_or_refused),
        cmocka_unit_test(missing_files_are_refused),      cmocka_unit_test(link_to_a_gate_file_is_followed),
    };
    return cmocka_run_group_tests_name("gate_file", tests, NULL, NULL);
}
