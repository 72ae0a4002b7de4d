/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Letters of UTF-8: what is one, and what is none of those that a terminal, a page and XML can take. */
#include "verification/text/letter.h"

#include "verification/unit/near.h"

#include <string.h>

static void lengths(void **state) {
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
        if (letter_length(row[i].text) != row[i].length)
            fail_msg("row %zu: %zu bytes, %zu are due", i, letter_length(row[i].text), row[i].length);
}

static void what_is_no_letter_is_a_question_mark(void **state) {
    (void)state;
    char text[] = "z\xE9ro \xC3\xA9\x1B[2J \xC2\x9B\xE2\x9C";
    letter_clean(text);
    assert_string_equal(text, "z?ro \xC3\xA9?[2J ????");
}

static void a_cut_leaves_whole_letters(void **state) {
    (void)state;
    static const char text[] = "a\xC3\xA9\xE2\x9C\x93\xF0\x9F\x94\xA5";
    static const size_t whole[] = {0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10};
    for (size_t n = 0; n < sizeof text; n++) assert_int_equal(letter_whole(text, n), whole[n]);
    assert_int_equal(letter_whole("\xA9\xA9\xA9\xA9\xA9", 5), 5);
    assert_int_equal(letter_whole("\xF0\x9F\x94", 3), 0);
    assert_int_equal(letter_whole("a\xE0", 2), 1);
    assert_int_equal(letter_whole("a\xDF\xBF", 3), 3);
    assert_int_equal(letter_whole("a\xE0\xA0", 3), 1);
    assert_int_equal(letter_whole("a\xEF\xBF\xBD", 4), 4);
    assert_int_equal(letter_whole("a\xF0\x90", 3), 1);
    assert_int_equal(letter_whole("a\xC1", 2), 2); /* begins nothing */
    assert_int_equal(letter_whole("a\xC2", 2), 1); /* the first byte of U+0080 to U+00BF */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths),
        cmocka_unit_test(what_is_no_letter_is_a_question_mark),
        cmocka_unit_test(a_cut_leaves_whole_letters),
    };
    return cmocka_run_group_tests_name("letter", tests, NULL, NULL);
}
