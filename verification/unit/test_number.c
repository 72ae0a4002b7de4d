/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strict numbers. */
#include "verification/text/number.h"

#include "verification/unit/near.h"

#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void decimals_and_fractions(void **state) {
    (void)state;
    double x = 0;
    assert_int_equal(number_read("0.385", &x), 0);
    assert_near(x, 0.385, 0);
    assert_int_equal(number_read("-2.5e-3", &x), 0);
    assert_near(x, -0.0025, 0);
    assert_int_equal(number_read("4/42", &x), 0);
    assert_near(x, 4.0 / 42, 0);
    assert_int_equal(number_read("-0.3/7", &x), 0);
    assert_near(x, -0.3 / 7, 0);
}

static void anything_else_is_refused(void **state) {
    (void)state;
    const char *const bad[] = {"",    " 1", "1 ", "0x10",  "nan", "inf", "-inf", "1e999", "1m",    "1,2",
                               "4/0", "/4", "4/", "4/5/6", "--1", "1e",  ".",    "e5",    "1/nan", "٣"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        double x;
        if (number_read(bad[i], &x) == 0) fail_msg("'%s' was read as %g", bad[i], x);
    }
    char digits[65] = ""; /* one more than a number may have */
    double x;
    memset(digits, '1', sizeof digits - 1);
    assert_int_equal(number_read(digits, &x), -1);
    digits[63] = '\0';
    assert_int_equal(number_read(digits, &x), 0);
}

static void lists(void **state) {
    (void)state;
    double x[3];
    assert_int_equal(number_read_list("0.1,4/42,7", x, 3), 3);
    assert_near(x[1], 4.0 / 42, 0);
    assert_int_equal(number_read_list("0.1", x, 3), 1);
    assert_int_equal(number_read_list("", x, 3), -1);
    assert_int_equal(number_read_list("1,", x, 3), -1);
    assert_int_equal(number_read_list(",1", x, 3), -1);
    assert_int_equal(number_read_list("1,,2", x, 3), -1);
    assert_int_equal(number_read_list("1,2,3,4", x, 3), -1);
}

static void whole_numbers(void **state) {
    (void)state;
    long n;
    assert_int_equal(number_read_whole("4294967295", 4294967295, &n), 0);
    assert_true(n == 4294967295);
    assert_int_equal(number_read_whole("4294967296", 4294967295, &n), -1);
    assert_int_equal(number_read_whole("99999999999999999999999", 4294967295, &n), -1);
    assert_int_equal(number_read_whole("-1", 10, &n), -1);
    assert_int_equal(number_read_whole("2.5", 10, &n), -1);
    assert_int_equal(number_read_whole("", 10, &n), -1);
}

static void numbers_as_programs_print_them(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int status;
        double value;
    } row[] = {
        {"2.385", 0, 2.385},
        {"-1.5e-3", 0, -1.5e-3},
        {"1.2345D-110", 0, 1.2345e-110},
        {"1.2345-110", 0, 1.2345e-110},
        {"+.7d+01", 0, 7},
        {"7.", 0, 7},
        {"3.5+2", 0, 350},
        {"nan", 1, 0},
        {"-Inf", 1, 0},
        {"NaN(0x1)", 1, 0},
        {"-nan(1)", 1, 0},
        {"+nan()", 1, 0},
        {"+INFINITY", 1, 0},
        {"infinity", 1, 0},
        {"+nan", 1, 0},
        {"nan(", -1, 0},
        {"--inf", -1, 0},
        {"1E2", 0, 100},
        {"1d-2", 0, 0.01},
        {"12", 0, 12},
        {"-12345678901234567", 0, -12345678901234567.0},
        {"1e999", 1, 0},
        {"", -1, 0},
        {"0x1p3", -1, 0},
        {"1,5", -1, 0},
        {"1e", -1, 0},
        {"1-", -1, 0},
        {"-", -1, 0},
        {"1e-", -1, 0},
        {"1.5.5", -1, 0},
        {"inform", -1, 0},
        {"1e+-3", -1, 0},
        {"+++++++++++++++++++++++++++++++++++++++++++++++++++++++++2", -1, 0}}; /* an e goes before each sign */
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        double value;
        int status = number_read_printed(row[i].text, strlen(row[i].text), &value);
        if (status != row[i].status) fail_msg("'%s': %d", row[i].text, status);
        if (!status) assert_near(value, row[i].value, 1e-15 * fabs(row[i].value));
    }
}

/* To the last bit as strtod, which is slower: any number of digits, the point anywhere, either sign. */
static void decimals_round_as_those_of_the_library(void **state) {
    (void)state;
    uint64_t draw = 1;
    for (int i = 0; i < 20000; i++) {
        char text[40];
        int length = 0, digits = 1 + i % 19, point = i / 19 % (digits + 1);
        if (i % 3) text[length++] = "-+"[i % 2];
        for (int k = 0; k <= digits; k++) {
            draw = draw * 6364136223846793005u + 1442695040888963407u;
            text[length++] = (char)(k == point ? '.' : '0' + (draw >> 60) % 10);
        }
        text[length] = '\0';
        double value, wanted = strtod(text, NULL);
        assert_int_equal(number_read_printed(text, (size_t)length, &value), 0);
        if (memcmp(&value, &wanted, sizeof value) != 0) fail_msg("%s: %.17g, not %.17g", text, value, wanted);
    }
    static const char *const none[] = {".", "-.", "..", ".5.", "1.x", "1./", "1.:", "+"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        double value;
        if (number_read_printed(none[i], strlen(none[i]), &value) != -1) fail_msg("'%s' is taken", none[i]);
    }
}

/* As printf does, which is slower for whole numbers. */
static void numbers_are_printed_with_all_their_digits(void **state) {
    (void)state;
    static const double value[] = {0,        -0.0,      1,     -7,      10,   3600000, 999999999999999.0,
                                   1e15,     -1e15,     1e300, 0.1 + 2, 52.5, -1e-310, NAN,
                                   INFINITY, -INFINITY, 1e17,  1e18,    -20,  1e5,     DBL_MAX};
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        char text[NUMBER_PRINTED], wanted[400];
        int length = snprintf(wanted, sizeof wanted, "%.17g", value[i]);
        assert_int_equal(number_print(value[i], text), length);
        assert_string_equal(text, wanted);
    }
}

/* 1/3 within a part in 100 is 3.3e-1 and a hundredth of it, 0.0033, away; 1/8 has three digits. */
static void the_fewest_digits_that_say_a_number(void **state) {
    (void)state;
    char text[NUMBER_PRINTED];
    assert_int_equal(number_digits(0.125, 0, 9, text), 3);
    assert_string_equal(text, "1.25e-01");
    assert_int_equal(number_digits(-0.125, 0.041, 9, text), 2);
    assert_string_equal(text, "-1.2e-01");
    assert_int_equal(number_digits(-0.125, 0.039, 9, text), 3);
    assert_int_equal(number_digits(1.0 / 3, 0.0101, 9, text), 2);
    assert_int_equal(number_digits(1.0 / 3, 1e-9, 3, text), 4);
    assert_string_equal(text, "3.33e-01");
    assert_int_equal(number_digits(2, 0, 1, text), 1);
}

static void sorted_from_the_largest(void **state) {
    (void)state;
    double x[] = {0.2, -1, 7, 0.2, 3};
    number_sort_falling(x, 4);
    const double sorted[] = {7, 0.2, 0.2, -1, 3};
    for (int i = 0; i < 5; i++) assert_near(x[i], sorted[i], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimals_and_fractions),
        cmocka_unit_test(anything_else_is_refused),
        cmocka_unit_test(lists),
        cmocka_unit_test(whole_numbers),
        cmocka_unit_test(numbers_as_programs_print_them),
        cmocka_unit_test(decimals_round_as_those_of_the_library),
        cmocka_unit_test(the_fewest_digits_that_say_a_number),
        cmocka_unit_test(sorted_from_the_largest),
        cmocka_unit_test(numbers_are_printed_with_all_their_digits),
    };
    return cmocka_run_group_tests_name("number", tests, NULL, NULL);
}
