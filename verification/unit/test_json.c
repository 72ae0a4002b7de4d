/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON, character by character. */
#include "verification/text/json.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

static void everything_once(void **state) {
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

/* What is no letter of UTF-8 is U+FFFD, a control character its number. */
static void bytes_that_are_no_letters(void **state) {
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

static void members_of_one_call(void **state) {
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

static void numbers_read_back_to_the_same_bits(void **state) {
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_once),
        cmocka_unit_test(bytes_that_are_no_letters),
        cmocka_unit_test(members_of_one_call),
        cmocka_unit_test(numbers_read_back_to_the_same_bits),
    };
    return cmocka_run_group_tests_name("json", tests, NULL, NULL);
}
