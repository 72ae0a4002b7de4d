/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text in and out: words of the command line, characters of UTF-8, JSON, tables. */
#include "verification/text/json.h"
#include "verification/text/table.h"
#include "verification/text/utf8.h"
#include "verification/text/shell.h"

#include "solver/status.h"
#include "solver/words.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const animals[] = {"ox", "so_ssph", "fo_ssph", "wombat", NULL};

static void index_is_exact(void **state) {
    (void)state;
    assert_int_equal(words_index(animals, "wombat"), 3);
    assert_int_equal(words_index(animals, "womba"), -1);
    assert_int_equal(words_index(animals, ""), -1);
}

static void nearest_word_takes_the_fewest_edits(void **state) {
    (void)state;
    assert_string_equal(words_nearest(animals, "so_shp"), "so_ssph");
    assert_string_equal(words_nearest(animals, "of_ssph"), "fo_ssph"); /* a swap is one edit */
    assert_string_equal(words_nearest(animals, "wmobta"), "wombat");
    assert_string_equal(words_nearest(animals, "o"), "ox");
    assert_null(words_nearest((const char *const[]){NULL}, "ox"));
}

/* Less than half of the letters, rounded up, plus one edit are near; of several as near, the first. */
static void nearest_word_shares_half_of_the_letters(void **state) {
    (void)state;
    static const char *const ox[] = {"ox", NULL}, *const abq[] = {"abq", NULL};
    static const char *const ends[] = {"ab1", "ab2", NULL};
    assert_string_equal(words_nearest(ox, "oxyz"), "ox");
    assert_null(words_nearest(ox, "oqyz"));
    assert_string_equal(words_nearest(ox, "oxyzz"), "ox");
    assert_null(words_nearest(ox, "oqyzz"));
    assert_null(words_nearest(ox, ""));
    assert_null(words_nearest(abq, "bxyq")); /* a letter in the other's place is no swap */
    assert_null(words_nearest(abq, "xyqab"));
    assert_string_equal(words_nearest(ends, "ab3"), "ab1");
}

static void long_words_are_compared_in_part(void **state) {
    (void)state;
    char word[500];
    memset(word, 'w', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    assert_non_null(words_nearest(animals, word));
}

static void lists_are_searched_for_whole_words(void **state) {
    (void)state;
    assert_true(words_among("stepper h order", "h"));
    assert_true(words_among("h", "h"));
    assert_true(words_among("threads h", "h"));
    assert_false(words_among("threads order", "h"));
    assert_false(words_among("t-end", "end"));
    assert_false(words_among("stepper", ""));
    assert_false(words_among("", "h"));
}

/* A backslash takes the special meaning from the next character. */
static void globs_match_one_by_one(void **state) {
    (void)state;
    assert_true(shell_match("a*", "a/b"));
    assert_true(shell_match("x,a?b", "a/b"));
    assert_false(shell_match("x,y", "a"));
    assert_false(shell_match(NULL, "a"));
    assert_true(shell_match("a\\,b,c", "a,b"));
    assert_true(shell_match("a\\,b,c", "c"));
    assert_false(shell_match("a\\,b,c", "b"));
    assert_true(shell_match("a\\\\,c", "a\\"));
    char glob[5];
    const char *next = shell_glob("abc\\,d,e", glob, sizeof glob);
    assert_string_equal(glob, "abc\\");
    assert_string_equal(next, "e");
    assert_null(shell_glob("abcde", glob, sizeof glob));
    assert_string_equal(glob, "abcd");
}

static void literal_pattern_matches_its_word_alone(void **state) {
    (void)state;
    static const char *const words[] = {"a*b", "a?b", "[ab]", "a,b", "a\\b", "a]b"};
    char pattern[40];
    assert_string_equal(shell_literal("a*?[,\\]z", pattern, sizeof pattern), "a\\*\\?\\[\\,\\\\]z");
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 6; k++)
            assert_int_equal(shell_match(shell_literal(words[i], pattern, sizeof pattern), words[k]), i == k);
    assert_string_equal(shell_literal("abc*", pattern, 5), "abc");
    assert_string_equal(shell_literal("abc*", pattern, 6), "abc\\*");
}

static void unknown_word_lists_the_valid_ones(void **state) {
    (void)state;
    struct failure why = {0};
    assert_int_equal(words_unknown((const char *const[]){NULL}, "gate", "x", &why), STATUS_INPUT);
    assert_string_equal(why.text, "unknown gate 'x'; there is none");
    assert_int_equal(words_unknown(animals, "gate", "xyzzyx", &why), STATUS_INPUT);
    assert_string_equal(why.text, "unknown gate 'xyzzyx' (valid: ox, so_ssph, fo_ssph, wombat)");
}

static void unknown_word_names_the_nearest(void **state) {
    (void)state;
    struct failure why = {0};
    assert_int_equal(words_unknown(animals, "method", "so_shp", &why), STATUS_INPUT);
    assert_string_equal(why.text,
                        "unknown method 'so_shp'; did you mean 'so_ssph'? (valid: ox, so_ssph, fo_ssph, wombat)");
}

static void lines_are_quoted_for_a_shell(void **state) {
    (void)state;
    const char *const words[] = {"verify", "--solver", "it's {case} \"$x\"", "--dx=0.1,1e-2", "", "a*"};
    char *line = shell_line(6, words);
    assert_string_equal(line, "verify --solver 'it'\\''s {case} \"$x\"' --dx=0.1,1e-2 '' 'a*'");
    free(line);
    line = shell_line(0, words);
    assert_string_equal(line, "");
    free(line);
}

static void appended_words_are_cut_to_size(void **state) {
    (void)state;
    char text[9] = "so", joined[9];
    assert_int_equal(words_add(text, sizeof text, "_%s", "ssph"), 0);
    assert_int_equal(words_add(text, sizeof text, "%d", 1), 0); /* the last place */
    assert_int_equal(words_add(text, sizeof text, "2"), -1);
    assert_string_equal(text, "so_ssph1");
    words_join(animals, joined, sizeof joined);
    assert_string_equal(joined, "ox, so_s");
}

/* ---- UTF-8 ---- */

static void characters_of_utf8_have_their_length(void **state) {
    (void)state;
    static const struct {
        const char *text;
        size_t length;
    } row[] = {
        {"a", 1},
        {" ", 1},
        {"~", 1},
        {"", 0},
        {"\n", 0},
        {"\x7F", 0},
        {"\xC3\xA9", 2},
        {"\xC2\xA0", 2},
        {"\xC2\x9B", 0},
        {"\xC1\xBF", 0},
        {"\xC3", 0},
        {"\xC3"
         "a",
         0},
        {"\x80", 0},
        {"\x9B", 0},
        {"\xE9", 0},
        {"\xFF", 0},
        {"\xE2\x9C\x93", 3},
        {"\xE0\x80\xAF", 0}, /* too long for '/' */
        {"\xED\xA0\x80", 0}, /* half of a pair of UTF-16 */
        {"\xEF\xBF\xBE", 0}, /* U+FFFE */
        {"\xEF\xBF\xBD", 3},
        {"\xF0\x9F\x94\xA5", 4},
        {"\xF0\x80\x80\x80", 0},
        {"\xF4\x90\x80\x80", 0}, /* past U+10FFFF */
        {"\xF0\x9F\x94", 0},
        /* The first and the last letters of each range */
        {"\x1F", 0},
        {"\x7E", 1},
        {"\xC2\x9F", 0},
        {"\xC3\x80", 2},
        {"\xDF\xBF", 2},
        {"\xE0\x9F\xBF", 0},
        {"\xE0\xA0\x80", 3},
        {"\xED\x9F\xBF", 3},
        {"\xED\xBF\xBF", 0},
        {"\xEE\x80\x80", 3},
        {"\xEF\xBF\xBF", 0},
        {"\xF0\x8F\xBF\xBF", 0},
        {"\xF0\x90\x80\x80", 4},
        {"\xF1\x80\x80\x80", 4},
        {"\xF3\xBF\xBF\xBF", 4},
        {"\xF4\x8F\xBF\xBF", 4},
        {"\xF5\x80\x80\x80", 0},
        {"\xE2\x9Cz", 0},
        {"\xF0\x9F\x94z", 0},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (utf8_length(row[i].text) != row[i].length)
            fail_msg("row %zu: %zu bytes, %zu are due", i, utf8_length(row[i].text), row[i].length);
}

static void invalid_utf8_is_a_question_mark(void **state) {
    (void)state;
    char text[] = "z\xE9ro \xC3\xA9\x1B[2J \xC2\x9B\xE2\x9C";
    utf8_clean(text);
    assert_string_equal(text, "z?ro \xC3\xA9?[2J ????");
}

/* ---- JSON ---- */

static void json_writes_every_kind_of_value(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_number(&j, "third", 1.0 / 3);
    json_number(&j, "nan", NAN);
    json_number(&j, "inf", -INFINITY);
    json_whole(&j, "many", 9007199254740993LL);
    json_text(&j, "text", "a \"quote\", a \\, a\ttab, 20 °C");
    json_text(&j, "none", NULL);
    json_array(&j, "empty");
    json_end(&j);
    json_array(&j, "list");
    json_number(&j, NULL, 1);
    json_object(&j, NULL);
    json_end(&j);
    json_end(&j);
    json_end(&j);
    fclose(out);
    assert_string_equal(text, "{\n  \"third\": 0.33333333333333331,\n  \"nan\": null,\n  \"inf\": null,\n"
                              "  \"many\": 9007199254740993,\n"
                              "  \"text\": \"a \\\"quote\\\", a \\\\, a\\u0009tab, 20 °C\",\n  \"none\": null,\n"
                              "  \"empty\": [],\n  \"list\": [\n    1,\n    {}\n  ]\n}\n");
    free(text);
}

/* Bytes that are no characters become U+FFFD, control characters their number. */
static void json_escapes_bytes_that_are_no_characters(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_text(&j, "k\n", "\x01\x7F \x80\xE9\xFFz");
    json_end(&j);
    fclose(out);
    assert_string_equal(text, "{\n  \"k\\u000a\": \"\\u0001\\u007f \\ufffd\\ufffd\\ufffdz\"\n}\n");
    free(text);
}

static void json_adds_members_by_a_format(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_add(&j, "a b %s|c %g|d %d|e %zu|f %lld|g %g", "x|y", 0.5, -7, (size_t)4294967296, -9007199254740993LL, NAN);
    json_numbers(&j, "h", (const double[]){1, INFINITY, 3}, 2);
    json_end(&j);
    fclose(out);
    assert_string_equal(text, "{\n  \"a b\": \"x|y\",\n  \"c\": 0.5,\n  \"d\": -7,\n  \"e\": 4294967296,\n"
                              "  \"f\": -9007199254740993,\n  \"g\": null,\n  \"h\": [\n    1,\n    null\n  ]\n}\n");
    free(text);
}

static void json_numbers_read_back_to_the_same_bits(void **state) {
    (void)state;
    const double values[] = {0.1, 1e-300, 5e-324, 1.7976931348623157e308, -0.0, 2.0 / 3};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        struct json j = json_on(out);
        json_number(&j, "v", values[i]);
        fclose(out);
        double back = strtod(strchr(text, ':') + 1, NULL);
        assert_memory_equal(&back, &values[i], sizeof back);
        free(text);
    }
}

/* A row is an object of the second level; a member of its own, an array and a null in the second row. */
static void json_calls_write_a_table(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_table(out, 3);
    json_text(&j, "title", "no part of a row");
    json_array(&j, "rows");
    for (int row = 0; row < 2; row++) {
        json_object(&j, NULL);
        json_text(&j, "name", row ? "null" : "a \"b\", c\n");
        if (row) json_whole(&j, "new", 7);
        json_numbers(&j, "x [m]", (const double[]){1.0 / 3, row ? NAN : 2}, 2);
        json_array(&j, "inner");
        json_object(&j, NULL);
        json_number(&j, "deeper", 1);
        json_end(&j);
        json_end(&j);
        json_text(&j, "last", row ? NULL : "z");
        json_end(&j);
    }
    json_end(&j);
    json_end(&j);
    fclose(out);
    assert_string_equal(text, "name,new,x_1 [m],x_2 [m],last\n\"a \"\"b\"\", c?\",,0.33333333333333331,2,z\n"
                              "null,7,0.33333333333333331,,\n");
    free(text);
}

/* A unit is no part of the name. */
static void json_omits_units(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_add(&j, "dx [m] %g|n %d", 0.5, 2);
    json_end(&j);
    fclose(out);
    assert_string_equal(text, "{\n  \"dx\": 0.5,\n  \"n\": 2\n}\n");
    free(text);
}

/* ---- Tables ---- */

static void expect(struct table *t, const char *printed) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    table_end(t, out);
    fclose(out);
    assert_string_equal(text, printed);
    free(text);
}

static void tables_align_numbers_right_and_names_left(void **state) {
    (void)state;
    struct table t = table_headed(1, "scene|dx [m]|E1");
    table_add(&t, "rod-step|%g|%g", 0.05, 1e-3);
    table_add(&t, "plate|%g", 0.0125);
    table_number(&t, "%.3g", NAN, "none");
    expect(&t, "scene     dx [m]     E1\n"
               "rod-step    0.05  0.001\n"
               "plate     0.0125   none\n");
}

/* Sentences in another column, or in the header, change nothing; no blanks follow. */
static void tables_align_a_last_column_of_sentences_left(void **state) {
    (void)state;
    static const struct {
        const char *header, *cell[6], *printed;
    } tables[] = {
        {"row|in words",
         {"a", "too far", "bb", "too late by one"},
         "row  in words\n"
         "a    too far\n"
         "bb   too late by one\n"},
        {"row|in words",
         {"a", "1"},
         "row  in words\n"
         "a           1\n"},
        {"row|why|n",
         {"a", "too far", "1", "b", "late", "20"},
         "row      why   n\n"
         "a    too far   1\n"
         "b       late  20\n"},
    };
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        struct table t = table_headed(1, tables[i].header);
        for (int k = 0; k < 6 && tables[i].cell[k]; k++) table_add(&t, "%s", tables[i].cell[k]);
        expect(&t, tables[i].printed);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(index_is_exact),
        cmocka_unit_test(nearest_word_takes_the_fewest_edits),
        cmocka_unit_test(nearest_word_shares_half_of_the_letters),
        cmocka_unit_test(long_words_are_compared_in_part),
        cmocka_unit_test(lists_are_searched_for_whole_words),
        cmocka_unit_test(globs_match_one_by_one),
        cmocka_unit_test(literal_pattern_matches_its_word_alone),
        cmocka_unit_test(unknown_word_lists_the_valid_ones),
        cmocka_unit_test(unknown_word_names_the_nearest),
        cmocka_unit_test(lines_are_quoted_for_a_shell),
        cmocka_unit_test(appended_words_are_cut_to_size),
        cmocka_unit_test(characters_of_utf8_have_their_length),
        cmocka_unit_test(invalid_utf8_is_a_question_mark),
        cmocka_unit_test(json_writes_every_kind_of_value),
        cmocka_unit_test(json_escapes_bytes_that_are_no_characters),
        cmocka_unit_test(json_adds_members_by_a_format),
        cmocka_unit_test(json_numbers_read_back_to_the_same_bits),
        cmocka_unit_test(json_calls_write_a_table),
        cmocka_unit_test(json_omits_units),
        cmocka_unit_test(tables_align_numbers_right_and_names_left),
        cmocka_unit_test(tables_align_a_last_column_of_sentences_left),
    };
    return cmocka_run_group_tests_name("text", tests, NULL, NULL);
}
