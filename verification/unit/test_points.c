/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points as programs write them, and refusals that name line and column. */
#include "verification/case/points.h"

#include "verification/unit/odd_scenes.h"
#include "verification/unit/points_text.h"

#include <stdlib.h>
#include <string.h>

static void points_are_read_as_programs_write_them(void **state) {
    (void)state;
    struct problem p;
    struct points points;
    struct failure why;
    odd_find("square-step", &p);
    const char *text = "\xEF\xBB\xBF# mesh 7\r\ncell , \"y\",dx, x,T\r\n\r\n1,-0.37,0.02,+4.1e-01,nan\r\n# half\r\n"
                       "2, 1.9000000001 ,0.03,-.5,0\r\n3,-1.8999999999,0.03,0,0\n";
    assert_int_equal(points_text(text, &p, &points, &why), STATUS_OK);
    assert_int_equal(points.n, 3);
    assert_near(points.x[0][0], 0.41, 0);
    assert_near(points.x[0][1], -0.37, 0);
    assert_near(points.x[1][1], 1.9, 0); /* off by 1e-10: on the side */
    assert_near(points.x[2][1], -1.9, 0);
    assert_near(points.cell[0][0], 0.02, 0);
    assert_near(points.cell[1][1], 0.03, 0); /* dy as dx */
    assert_int_equal(points.typed[0][0].length, 8);
    assert_memory_equal(points.typed[0][0].text, "+4.1e-01", 8);
    points_free(&points);
}

/* More points than the first blocks hold, of the text and of the numbers. */
static void many_points_are_all_read(void **state) {
    (void)state;
    enum { N = 9001 };
    struct problem p;
    struct points points;
    struct failure why;
    char *text = malloc(N * 24 + 8), *to = text;
    odd_find("rod-cosine", &p);
    to += sprintf(to, "x\n");
    for (int i = 0; i < N; i++) to += sprintf(to, "%.17g\n", 1.3 * (i + 0.5) / N);
    assert_int_equal(points_text(text, &p, &points, &why), STATUS_OK);
    assert_int_equal(points.n, N);
    for (int i = 0; i < N; i++) assert_near(points.x[i][0], 1.3 * (i + 0.5) / N, 0);
    assert_null(points.cell);
    points_free(&points);
    free(text);
}

static void bad_points_are_refused_by_line_and_column(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {"", "points.csv: empty; must start with the header x,y"},
        {"# x,y\n", "empty"},
        {"x,y\n", "a header without points"},
        {"x,z\n0.1,0.2\n", "line 1: 'x,z' has no column y; the header is x,y"},
        {"0.1,0.2\n", "line 1: '0.1,0.2' has no column x"},
        {"x,y,x\n0.1,0.2,0.3\n", "line 1: two columns are called 'x'"},
        {"x,y\n0.1,0.2\n\n0.1;0.2\n", "line 4: 1 column where the lines above have 2"},
        {"x,y\n0.1,0.2,0.3\n", "line 2: 3 columns where the lines above have 2"},
        {"a,x,y\n7,0.1,0.2\n7,0.1,0x1p-3\n",
         "line 3, column 3 (y): '0x1p-3' is not a decimal number, but a hexadecimal one"},
        {"x,y\n,0.2\n", "line 2, column 1 (x): '' is not a decimal number"},
        {"x,y\nnan,0.2\n", "line 2, column 1 (x): 'nan' is not a finite number"},
        {"x,y\n0.1,0.2\n1.91,0.2\n", "line 3: (1.91,0.2) m: x is outside -1.9 to 1.9 m"},
        {"x,y\n0.1,0.2\n0.15,-2\n", "line 3: (0.15,-2) m: y is outside"},
        {"x,y,dx\n0.1,0.2,-0.01\n", "line 2: (0.1,0.2) m: the extent -0.01 m of a cell is below 0"},
        {"x,y\n0.1,0.2\n0.1,0.", "line 3: ends without a newline"},
    };
    struct problem p;
    odd_find("square-step", &p);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct points points;
        struct failure why;
        int status = *bad[i].text ? points_text(bad[i].text, &p, &points, &why) : STATUS_INPUT;
        if (!*bad[i].text) {
            FILE *in = tmpfile();
            status = points_read(in, "points.csv", &p, &points, &why);
            fclose(in);
        }
        assert_int_equal(status, STATUS_INPUT);
        if (!strstr(why.text, bad[i].says)) fail_msg("\"%s\" lacks \"%s\"", why.text, bad[i].says);
        assert_null(points.x);
    }
    FILE *in = fmemopen((void *)"x,y\n0.1,\0.2\n", 13, "r");
    struct points points;
    struct failure why;
    assert_int_equal(points_read(in, "points.csv", &p, &points, &why), STATUS_INPUT);
    assert_has(why.text, "NUL");
    fclose(in);
}

/* Threads read the lines of many points: the first that is refused is named, not the first that a thread met. */
static void the_first_of_many_bad_lines_is_named(void **state) {
    (void)state;
    enum { N = 4000, FIRST = 1999 };
    struct problem p;
    struct points points;
    struct failure why;
    char *text = malloc(N * 8 + 8), *to = text;
    odd_find("rod-cosine", &p);
    to += sprintf(to, "x\n");
    for (int line = 2; line < N; line++) to += sprintf(to, line < FIRST ? "0.1\n" : "y%d\n", line);
    assert_int_equal(points_text(text, &p, &points, &why), STATUS_INPUT);
    assert_has(why.text, "line 1999, column 1 (x): 'y1999' is not a decimal number");
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_read_as_programs_write_them),
        cmocka_unit_test(many_points_are_all_read),
        cmocka_unit_test(the_first_of_many_bad_lines_is_named),
        cmocka_unit_test(bad_points_are_refused_by_line_and_column),
    };
    return cmocka_run_group_tests_name("points", tests, NULL, NULL);
}
