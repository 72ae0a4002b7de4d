/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table as it is printed. */
#include "verification/text/table.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void expect(struct table *t, const char *printed) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    table_end(t, out);
    fclose(out);
    assert_string_equal(text, printed);
    free(text);
}

static void numbers_are_set_right_and_names_left(void **state) {
    (void)state;
    struct table t = table_headed(1, "scene|dx [m]|E1");
    table_add(&t, "rod-step|%g|%g", 0.05, 1e-3);
    table_add(&t, "plate|%g", 0.0125);
    table_number(&t, "%.3g", NAN, "none");
    expect(&t, "scene     dx [m]     E1\n"
               "rod-step    0.05  0.001\n"
               "plate     0.0125   none\n");
}

/* Sentences of the last column begin below each other, and no blanks follow them; its header does not count as one,
 * and those of another column change nothing. */
static void sentences_are_set_left_at_the_end_alone(void **state) {
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
        cmocka_unit_test(numbers_are_set_right_and_names_left),
        cmocka_unit_test(sentences_are_set_left_at_the_end_alone),
    };
    return cmocka_run_group_tests_name("table", tests, NULL, NULL);
}
