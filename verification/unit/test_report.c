/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report: isotherms, and tables as printed. */
#include "reports/figure/figure.h"
#include "reports/figure/published.h"

#include "solver/method.h"
#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 37, NY = 29 };

static double bowl(double x, double y) {
    return 2.385 + pow((x - 0.31) / 1.3, 2) + pow((y + 0.17) / 0.9, 2);
}

static double saddle(double x, double y) {
    return (x - 0.013) * (y + 0.021);
}

static double ramp(double x, double y) {
    return 0.7 * x + 1.9 * y;
}

static struct isotherm_grid grid_of(double (*T)(double, double), double *store) {
    struct isotherm_grid g = {{NX, NY}, {-1.4, -1.1}, {0.083, 0.077}, store};
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) store[j * NX + i] = T(g.lo[0] + i * g.d[0], g.lo[1] + j * g.d[1]);
    return g;
}

/* Lines traced; every point of theirs has the level within `tolerance`. */
static int lines_at(const struct isotherm_grid *g, double (*T)(double, double), double level, double tolerance,
                    double middle[2], int *points) {
    char *text = NULL, *at;
    size_t size = 0;
    double x, y, l;
    int lines, used;
    FILE *out = open_memstream(&text, &size);
    lines = isotherm_trace(g, level, 0.5, out, middle);
    fclose(out);
    *points = 0;
    for (at = text; sscanf(at, " %lf,%lf,%lf%n", &x, &y, &l, &used) == 3; at += used) {
        assert_near(l, level, 1e-5);
        assert_near(T(x, y), level, tolerance);
        ++*points;
    }
    free(text);
    return lines;
}

static void a_closed_isotherm_is_one_line(void **state) {
    (void)state;
    double store[NX * NY], middle[2];
    int points;
    struct isotherm_grid g = grid_of(bowl, store);
    assert_int_equal(lines_at(&g, bowl, 2.385 + 0.37, 3e-3, middle, &points), 1);
    assert_order(points, >, 40);
    assert_near(bowl(middle[0], middle[1]), 2.385 + 0.37, 3e-3);
    assert_int_equal(lines_at(&g, bowl, 2.3, 0, middle, &points), 0);
}

static void a_saddle_is_two_lines(void **state) {
    (void)state;
    double store[NX * NY], middle[2];
    int points;
    struct isotherm_grid g = grid_of(saddle, store);
    assert_int_equal(lines_at(&g, saddle, 0.11, 2e-3, middle, &points), 2);
    assert_int_equal(lines_at(&g, saddle, -0.07, 2e-3, middle, &points), 2);
}

/* Where the line from the lower side of a cell ends, in x: 1, at the right side, or 0, at the left. */
static double other_end(double (*T)[4]) {
    char *text = NULL;
    size_t size = 0;
    double x[2], y[2], middle[2];
    struct isotherm_grid cell = {{2, 2}, {0, 0}, {1, 1}, *T};
    FILE *out = open_memstream(&text, &size);
    assert_int_equal(isotherm_trace(&cell, 0, 0.5, out, middle), 2);
    fclose(out);
    assert_int_equal(sscanf(text, "%lf,%lf,0 %lf,%lf,0", &x[0], &y[0], &x[1], &y[1]), 4);
    free(text);
    assert_near(y[0], 0, 0);
    return x[1];
}

/* Two opposite corners above the level and two below: the pair that has the sign of the mean is joined. */
static void the_mean_decides_a_cell(void **state) {
    (void)state;
    double T[4][4] = {{1, -1.2, -0.2, 1}, {1, -1.2, -1, 0.2}, {-1, 1.2, 0.2, -1}, {-0.2, 1.2, 1, -1}};
    assert_near(other_end(&T[0]), 1, 0); /* at (0, 0), (1, 0), (0, 1), (1, 1); the mean is above: (1, 0) is cut off */
    assert_near(other_end(&T[1]), 0, 0);
    assert_near(other_end(&T[2]), 1, 0);
    assert_near(other_end(&T[3]), 0, 0);
}

static void the_middle_is_halfway(void **state) {
    (void)state;
    double store[NX * NY], middle[2];
    int points;
    struct isotherm_grid g = grid_of(ramp, store);
    assert_int_equal(lines_at(&g, ramp, 0.2, 1e-5, middle, &points), 1);
    assert_near(middle[0], g.lo[0] + (NX - 1) * g.d[0] / 2, 2 * g.d[0]); /* from side to side */
}

static void refining_keeps_the_values(void **state) {
    (void)state;
    double store[NX * NY];
    struct isotherm_grid g = grid_of(bowl, store), fine = isotherm_refine(&g, 3);
    assert_int_equal(fine.n[0], 3 * (NX - 1) + 1);
    assert_int_equal(fine.n[1], 3 * (NY - 1) + 1);
    for (int j = 0; j < fine.n[1]; j++)
        for (int i = 0; i < fine.n[0]; i++)
            assert_near(fine.T[j * fine.n[0] + i], bowl(g.lo[0] + i * fine.d[0], g.lo[1] + j * fine.d[1]), 3e-3);
    assert_near(fine.T[3 * 5 * fine.n[0] + 3 * 7], store[5 * NX + 7], 1e-13);
    free(fine.T);
}

static void units_of_the_last_digit(void **state) {
    (void)state;
    assert_near(published_units("0.0089", 0.0088837), 0, 0);
    assert_near(published_units("0.3381", 0.33698), -11, 0);
    assert_near(published_units("5.0103e-5", 4.9183e-5), -920, 0);
    assert_near(published_units("2.7827", 2.785), 23, 0);
    assert_near(published_units("27", 31), 4, 0);
    assert_near(published_units("3e-2", 0.05), 2, 0);
}

static void tables_as_printed(void **state) {
    (void)state;
    struct published t;
    struct failure why;
    assert_int_equal(published_read(&t, "song_table1", &why), STATUS_OK);
    assert_int_equal(t.rows, 2);
    assert_int_equal(t.columns, 6);
    assert_string_equal(t.method[1], "so_ssph");
    assert_string_equal(t.where[3], "0.10");
    assert_string_equal(t.cell[1][0], "5.0103e-5");
    assert_near(t.value[0][5], 0.3381, 0);
    assert_int_equal(published_read(&t, "song_table9", &why), STATUS_INPUT);
    assert_has(why.text, "reports/published/song_table9.csv");
    assert_int_equal(published_row(&t, "so_ssph"), -1);
    assert_int_equal(published_read(&t, "pamplona_table1", &why), STATUS_OK);
    assert_int_equal(published_row(&t, "ftcs"), 1);
    assert_int_equal(published_row(&t, "so_ssph"), -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_isotherm_is_one_line),
        cmocka_unit_test(a_saddle_is_two_lines),
        cmocka_unit_test(the_mean_decides_a_cell),
        cmocka_unit_test(the_middle_is_halfway),
        cmocka_unit_test(refining_keeps_the_values),
        cmocka_unit_test(units_of_the_last_digit),
        cmocka_unit_test(tables_as_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
