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
        cmocka_unit_test(a_word_longer_than_any_is_compared_in_part),
        cmocka_unit_test(among_wants_whole_words),
        cmocka_unit_test(join_is_cut_to_size),
        cmocka_unit_test(unknown_names_the_nearest_and_the_valid),
        cmocka_unit_test(a_line_is_quoted_for_a_shell),
    };
    return cmocka_run_group_tests_name("words", tests, NULL, NULL);
}
