/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nearest valid word. */
#include "verification/text/words.h"

#include "solver/method.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

static const char *const animals[] = {"ox", "so_ssph", "fo_ssph", "wombat", NULL};

static void index_is_exact(void **state) {
    (void)state;
    assert_int_equal(words_index(animals, "wombat"), 3);
    assert_int_equal(words_index(animals, "womba"), -1);
    assert_int_equal(words_index(animals, ""), -1);
}

static void nearest_takes_the_fewest_edits(void **state) {
    (void)state;
    assert_string_equal(words_nearest(animals, "so_shp"), "so_ssph");
    assert_string_equal(words_nearest(animals, "of_ssph"), "fo_ssph"); /* a swap is one edit */
    assert_string_equal(words_nearest(animals, "wmobta"), "wombat");
    assert_string_equal(words_nearest(animals, "o"), "ox");
    assert_null(words_nearest((const char *const[]){NULL}, "ox"));
}

/* Less than half of the letters, rounded up, and one edit more are near; of several as near the first. */
static void what_is_too_far_is_not_near(void **state) {
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

static void a_word_longer_than_any_is_compared_in_part(void **state) {
    (void)state;
    char word[500];
    memset(word, 'w', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    assert_non_null(words_nearest(animals, word));
}

static void among_wants_whole_words(void **state) {
    (void)state;
    assert_true(words_among("stepper h order", "h"));
    assert_true(words_among("h", "h"));
    assert_true(words_among("threads h", "h"));
    assert_false(words_among("threads order", "h"));
    assert_false(words_among("t-end", "end"));
    assert_false(words_among("stepper", ""));
    assert_false(words_among("", "h"));
}

static void join_is_cut_to_size(void **state) {
    (void)state;
    char text[9];
    words_join(animals, text, sizeof text);
    assert_string_equal(text, "ox, so_s");
}

static void a_word_that_is_cut_is_told(void **state) {
    (void)state;
    char text[9] = "so";
    assert_int_equal(words_add(text, sizeof text, "_%s", "ssph"), 0);
    assert_int_equal(words_add(text, sizeof text, "%d", 1), 0); /* room for this one alone */
    assert_string_equal(text, "so_ssph1");
    assert_int_equal(words_add(text, sizeof text, "2"), -1);
    assert_string_equal(text, "so_ssph1");
}

/* Whether one of the globs, with commas between, matches; a backslash takes the meaning of what follows. */
static void globs_are_matched_one_by_one(void **state) {
    (void)state;
    assert_true(words_match("a*", "a/b"));
    assert_true(words_match("x,a?b", "a/b"));
    assert_false(words_match("x,y", "a"));
    assert_false(words_match(NULL, "a"));
    assert_true(words_match("a\\,b,c", "a,b"));
    assert_true(words_match("a\\,b,c", "c"));
    assert_false(words_match("a\\,b,c", "b"));
    assert_true(words_match("a\\\\,c", "a\\"));
    char glob[5];
    const char *next = words_glob("abc\\,d,e", glob, sizeof glob);
    assert_string_equal(glob, "abc\\");
    assert_string_equal(next, "e");
    assert_null(words_glob("abcde", glob, sizeof glob));
    assert_string_equal(glob, "abcd");
}

static void a_literal_matches_its_word_alone(void **state) {
    (void)state;
    static const char *const words[] = {"a*b", "a?b", "[ab]", "a,b", "a\\b", "a]b"};
    char pattern[40];
    assert_string_equal(words_literal("a*?[,\\]z", pattern, sizeof pattern), "a\\*\\?\\[\\,\\\\]z");
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 6; k++)
            assert_int_equal(words_match(words_literal(words[i], pattern, sizeof pattern), words[k]), i == k);
    assert_string_equal(words_literal("abc*", pattern, 5), "abc");
    assert_string_equal(words_literal("abc*", pattern, 6), "abc\\*");
}

static void where_nothing_is_valid_nothing_is_named(void **state) {
    (void)state;
    struct failure why = {0};
    assert_int_equal(words_unknown((const char *const[]){NULL}, "gate", "x", &why), STATUS_INPUT);
    assert_string_equal(why.text, "unknown gate 'x'; there is none");
    assert_int_equal(words_unknown(animals, "gate", "xyzzyx", &why), STATUS_INPUT);
    assert_string_equal(why.text, "unknown gate 'xyzzyx' (valid: ox, so_ssph, fo_ssph, wombat)");
}

static void unknown_names_the_nearest_and_the_valid(void **state) {
    (void)state;
    struct failure why = {0};
    assert_int_equal(words_unknown(animals, "method", "so_shp", &why), STATUS_INPUT);
    assert_string_equal(why.text,
                        "unknown method 'so_shp'; did you mean 'so_ssph'? (valid: ox, so_ssph, fo_ssph, wombat)");
}

static void a_line_is_quoted_for_a_shell(void **state) {
    (void)state;
    const char *const words[] = {"verify", "--solver", "it's {case} \"$x\"", "--dx=0.1,1e-2", "", "a*"};
    char *line = words_line(6, words);
    assert_string_equal(line, "verify --solver 'it'\\''s {case} \"$x\"' --dx=0.1,1e-2 '' 'a*'");
    free(line);
    line = words_line(0, words);
    assert_string_equal(line, "");
    free(line);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(index_is_exact),
        cmocka_unit_test(nearest_takes_the_fewest_edits),
        cmocka_unit_test(what_is_too_far_is_not_near),
        cmocka_unit_test(a_word_that_is_cut_is_told),
        cmocka_unit_test(globs_are_matched_one_by_one),
        cmocka_unit_test(a_literal_matches_its_word_alone),
        cmocka_unit_test(where_nothing_is_valid_nothing_is_named),
        cmocka_unit_test(a_word_longer_than_any_is_compared_in_part),
        cmocka_unit_test(among_wants_whole_words),
        cmocka_unit_test(join_is_cut_to_size),
        cmocka_unit_test(unknown_names_the_nearest_and_the_valid),
        cmocka_unit_test(a_line_is_quoted_for_a_shell),
    };
    return cmocka_run_group_tests_name("words", tests, NULL, NULL);
}
