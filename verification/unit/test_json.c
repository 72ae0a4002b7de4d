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
        cmocka_unit_test(numbers_read_back_to_the_same_bits),
    };
    return cmocka_run_group_tests_name("json", tests, NULL, NULL);
}
