/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strict numbers. */
#include "verification/text/number.h"

#include "verification/unit/near.h"

#include <string.h>

static void decimals_and_fractions_are_read(void **state) {
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

static void invalid_numbers_are_refused(void **state) {
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

static void lists_are_read_whole(void **state) {
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

static void whole_numbers_have_a_range(void **state) {
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

static void numbers_of_other_programs_are_read(void **state) {
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
        {"-1.#IND", 1, 0},
        {"1.#INF00", 1, 0},
        {"1.#QNAN", 1, 0},
        {"1.#", -1, 0},
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

/* 1/3 within a part in 100 is 3.3e-1 and a hundredth of it, 0.0033, away; 1/8 has three digits. */
static void fewest_digits_read_back(void **state) {
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

static void numbers_sort_from_the_largest(void **state) {
    (void)state;
    double x[] = {0.2, -1, 7, 0.2, 3};
    number_sort_falling(x, 4);
    const double sorted[] = {7, 0.2, 0.2, -1, 3};
    for (int i = 0; i < 5; i++) assert_near(x[i], sorted[i], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimals_and_fractions_are_read),
        cmocka_unit_test(invalid_numbers_are_refused),
        cmocka_unit_test(lists_are_read_whole),
        cmocka_unit_test(whole_numbers_have_a_range),
        cmocka_unit_test(numbers_of_other_programs_are_read),
        cmocka_unit_test(fewest_digits_read_back),
        cmocka_unit_test(numbers_sort_from_the_largest),
    };
    return cmocka_run_group_tests_name("number", tests, NULL, NULL);
}
