/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Without an exact solution: orders, limits and fields on points that no two grids share. */
#include "verification/judge/gci.h"

#include "solver/status.h"
#include "verification/case/samples.h"
#include "verification/text/json.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static char dir[UNIT_PATH];

static FILE *answer(const char *sub, double h) {
    char path[UNIT_PATH + 200];
    snprintf(path, sizeof path, "%s/%s", dir, sub);
    mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/%s/%.17g", dir, sub, h);
    mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/%s/%.17g/out.csv", dir, sub, h);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    return out;
}

static int read_sub(const char *sub, const struct numbers *at, struct gci *g, struct failure *why) {
    char path[UNIT_PATH + 200];
    snprintf(path, sizeof path, "%s/%s", dir, sub);
    return gci_read(path, &(struct column_map){0}, at, g, why);
}

/* Errors 0.7 h^p of one sign, or of alternating signs, on 2.385 at h = 0.1, 0.1 r21 and 0.1 r21 r32.  Rounded to
 * doubles they leave the changes known to 2 eps f each, so ln(e32/e21) to 2 eps f (1/|e21| + 1/|e32|), and the order
 * to that over (ln g)' = (v/(1 - s e^-v) - s u/(e^u - s))/p, u = p ln r21, v = p ln r32. */
static void check_order(double p, double r21, double r32, int s) {
    double f[3], u = p * log(r21), v = p * log(r32), steep = (v / (1 - s * exp(-v)) - s * u / (exp(u) - s)) / p;
    int oscillates;
    for (int l = 0; l < 3; l++)
        f[l] = 2.385 + (l == 1 ? s : 1) * 0.7 * pow(l == 0 ? 0.1 : l == 1 ? 0.1 * r21 : 0.1 * r21 * r32, p);
    double e21 = f[1] - f[0], e32 = f[2] - f[1];
    double known = 2 * DBL_EPSILON * fmax(f[0], f[2]) * (1 / fabs(e21) + 1 / fabs(e32)) / steep;
    assert_near(gci_order(e21, e32, r21, r32, &oscillates), p, known);
    assert_int_equal(oscillates, s < 0);
}

static void the_order_is_found_for_any_ratios(void **state) {
    (void)state;
    static const double order[] = {1, 2, 4}, ratio[] = {1.05, 1.1, 1.2, 1.25, 1.5, 2, 3, 4};
    enum { RATIOS = sizeof ratio / sizeof *ratio };
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RATIOS * RATIOS; i++) {
            check_order(order[k], ratio[i / RATIOS], ratio[i % RATIOS], 1);
            check_order(order[k], ratio[i / RATIOS], ratio[i % RATIOS], -1);
        }
}

/* Changes as of an order of 0, ln r32/ln r21, and just above; of alternating errors 1. */
static void nonmonotone_changes_have_no_order(void **state) {
    (void)state;
    int oscillates;
    double least = log(2) / log(1.3);
    assert_nan(gci_order(1, least * (1 - 1e-9), 1.3, 2, &oscillates));
    assert_nan(gci_order(1, 0.3, 1.3, 2, &oscillates));
    assert_in_range(1e12 * gci_order(1, least * (1 + 1e-9), 1.3, 2, &oscillates), 1, 10000);
    assert_nan(gci_order(1, -0.999, 1.3, 2, &oscillates));
    assert_int_equal(oscillates, 1);
    assert_in_range(1e6 * gci_order(1, -1.001, 1.3, 2, &oscillates), 1000, 10000);
    assert_nan(gci_order(0, 1, 1.3, 2, &oscillates));
    assert_nan(gci_order(1, 0, 1.3, 2, &oscillates));
    assert_nan(gci_order(1, NAN, 1.3, 2, &oscillates));
    assert_true(isfinite(gci_order(1, 1e300, 1.3, 1.01, &oscillates))); /* an order of 69000: no power overflows */
}

static void json_of(const struct gci *g, char *text, size_t size) {
    FILE *out = fmemopen(text, size, "w");
    struct json j = json_on(out);
    gci_json(g, &j);
    json_end(&j);
    fclose(out);
}

/* n = 10, 20, 24, 40 of exact second order: both orders, and the index from the three finest, r = 40/24; the order
 * from rounded changes as above. */
static void gci_with_unequal_ratios(void **state) {
    (void)state;
    static const int n[] = {10, 20, 24, 40};
    struct gci g;
    struct failure why;
    for (int i = 0; i < 4; i++) {
        FILE *out = answer("unequal", 1.0 / n[i]);
        fprintf(out, "flux\n%.17g\n", 3.25 + 0.9 / n[i] / n[i]);
        fclose(out);
    }
    if (read_sub("unequal", &(struct numbers){0}, &g, &why)) fail_msg("%s", why.text);
    assert_near(g.row[0].orders[0], 2, 1e-10);
    assert_near(g.row[0].orders[1], 2, 1e-10);
    assert_near(g.row[0].order, 2, 1e-10);
    assert_near(g.row[0].extrapolated, 3.25, 1e-12);
    assert_near(g.row[0].index, 1.25 * 0.9 / 1600 / (3.25 + 0.9 / 1600), 1e-12);
    char text[4096], *used;
    json_of(&g, text, sizeof text);
    used = strstr(text, "\"used\"");
    assert_non_null(used);
    for (int i = 1; i < 4; i++) {
        used = strpbrk(used, i == 1 ? "[" : ",") + 1;
        assert_near(strtod(used, NULL), 1.0 / n[i], 0);
    }
}

static void gci_of_quantities(void **state) {
    (void)state;
    static const double h[] = {0.4, 0.2, 0.1};
    struct gci g;
    struct failure why;
    for (int i = 0; i < 3; i++) {
        FILE *out = answer("values", h[i]);
        fprintf(out, i == 1 ? " \"flux\", \"heat\"\n %.17g, %.17g\n" : "flux,heat\n%.17g,%.17g\n",
                3.25 + 0.9 * h[i] * h[i], 5.5 - 0.3 * h[i]);
        fclose(out);
    }
    if (read_sub("values", &(struct numbers){0}, &g, &why)) fail_msg("%s", why.text);
    assert_int_equal(g.rows, 2);
    assert_string_equal(g.row[1].name, "heat");
    assert_near(g.row[0].order, 2, 1e-9);
    assert_near(g.row[0].extrapolated, 3.25, 1e-12);
    assert_near(g.row[0].index, 1.25 * 0.9 * 0.03 / (3.25 + 0.9 * 0.01) / 3, 1e-12);
    assert_near(g.row[1].order, 1, 1e-9);
    assert_near(g.row[1].extrapolated, 5.5, 1e-12);
    char text[4096];
    json_of(&g, text, sizeof text);
    const char *orders = strstr(text, "\"orders\""); /* one for three grids */
    assert_non_null(orders);
    assert_order(strcspn(orders, "]"), <, strcspn(orders, ","));
}

static double smooth(double x, double y, double h) {
    return exp(0.3 * x) * cos(0.7 * y + 0.2) + 0.35 * h * h * sin(x + 0.4 * y + 1.1);
}

/* T + h^2 u at the centres of cells, which no two of the grids share. */
static void fields_on_different_points(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    for (int dim = 1; dim <= 2; dim++) {
        for (int n = 10; n <= 80; n *= 2) {
            FILE *out = answer(dim == 1 ? "rod" : "square", 4.0 / n);
            fprintf(out, dim == 1 ? "x,T\n" : "x,y,T\n");
            for (int j = 0; j < (dim == 1 ? 1 : n); j++)
                for (int i = 0; i < n; i++) {
                    double h = 4.0 / n, x = -2 + h * (i + 0.5), y = dim == 1 ? 0 : -1 + h * (j + 0.5);
                    fprintf(out, "%.17g,", x);
                    if (dim == 2) fprintf(out, "%.17g,", y);
                    fprintf(out, "%.17g\n", smooth(x, y, h));
                }
            fclose(out);
        }
        struct numbers at = {.count = dim, .value = {0.213, 0.377}};
        if (read_sub(dim == 1 ? "rod" : "square", &at, &g, &why)) fail_msg("%s", why.text);
        assert_int_equal(g.rows, 2);
        assert_near(g.row[0].order, 2, 0.01);
        assert_near(g.row[1].order, 2, 0.01);
        assert_near(g.row[1].extrapolated, smooth(0.213, dim == 1 ? 0 : 0.377, 0), 1e-5);
    }
}

static double product_of_cosines(int dim, const double *x, double waves) {
    double T = 1;
    for (int a = 0; a < dim; a++) T *= cos(M_PI * (a ? waves : 1) * x[a]);
    return T;
}

/* Cell centres of a unit square or cube with 10, 20 and 40 cells along each axis; T has the relative error 0.3 h^2.
 * shift: of every second point, in cells. */
static void write_cells(const char *sub, int dim, double waves, double shift, int with_weights) {
    for (int n = 10; n <= 40; n *= 2) {
        double h = 1.0 / n;
        FILE *out = answer(sub, h);
        fprintf(out, "x,y%s,T%s\n", dim == 3 ? ",z" : "", with_weights ? ",w" : "");
        for (int c = 0; c < (dim == 3 ? n * n * n : n * n); c++) {
            const double x[] = {h * (c % n + 0.5 + (c % 3 == 1 ? shift : 0)), h * (c / n % n + 0.5),
                                h * (c / n / n + 0.5)};
            for (int a = 0; a < dim; a++) fprintf(out, "%.17g,", x[a]);
            fprintf(out, "%.17g%s\n", (0.7 + product_of_cosines(dim, x, waves)) * (1 + 0.3 * h * h),
                    with_weights ? ",1e300" : "");
        }
        fclose(out);
    }
}

/* Changes off by the share s at most move ln(e32/e21) by 2 s, and p by 2 s/ln 2.  The mean is 0.7, in sums of up to
 * 64,000 terms, which round to 64,000 eps: 1e-11 of a last change of 4e-4. */
static void interpolation_between_cells_leaves_the_order(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    for (int dim = 2; dim <= 3; dim++) {
        write_cells("cells", dim, 1, 0, 1);
        struct numbers at = {.count = dim, .value = {0.43, 0.37, 0.61}};
        if (read_sub("cells", &at, &g, &why)) fail_msg("%s", why.text);
        assert_int_equal(g.rows, 3);
        for (int k = 0; k < 2; k++) {
            assert_order(g.row[k].between, <, 0.01);
            assert_near(g.row[k].order, 2, 2 * g.row[k].between / log(2));
        }
        assert_string_equal(g.row[2].name, "mean of T, weighted by w");
        assert_near(g.row[2].extrapolated, 0.7, 3e-11);
        assert_near(g.row[2].order, 2, 1e-7);
    }
}

/* Waves of three cells a half on the coarsest grid hide 0.3 h^2, and so do points off rows of a plane; without
 * weights nothing is left, and the remedy is named. */
static void interpolation_that_hides_the_order_is_refused(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    struct numbers at = {.count = 2, .value = {0.43, 0.37}};
    for (int scattered = 0; scattered < 2; scattered++) {
        write_cells("short", 2, scattered ? 2 : 4, scattered ? 0.2 : 0, 1);
        if (read_sub("short", &at, &g, &why)) fail_msg("%s", why.text);
        for (int k = 0; k < 2; k++) {
            assert_order(g.row[k].between, >, GCI_BETWEEN);
            assert_nan(g.row[k].order);
            assert_nan(g.row[k].index);
        }
        assert_true(g.row[2].between == 0);
        write_cells("short", 2, scattered ? 2 : 4, scattered ? 0.2 : 0, 0);
        assert_int_equal(read_sub("short", &at, &g, &why), STATUS_INPUT);
        assert_has(why.text,
                   "use finer grids, points that all grids share (nodes), or a column w of volumes for the mean");
    }
}

/* A name longer than is kept is the same name in every file. */
static void long_quantity_names_are_cut(void **state) {
    (void)state;
    static const char *const name = "heat_through_the_wall_between_the_boiler_and_the_room_beside_it";
    struct gci g;
    struct failure why;
    for (int i = 0; i < 3; i++) {
        FILE *out = answer("long", 0.4 / (1 << i));
        fprintf(out, "%s\n%.17g\n", name, 3.25 + 0.9 / (1 << 2 * i));
        fclose(out);
    }
    if (read_sub("long", &(struct numbers){0}, &g, &why)) fail_msg("%s", why.text);
    assert_int_equal(g.rows, 1);
    assert_int_equal(strncmp(g.row[0].name, name, GCI_NAME - 1), 0);
    assert_near(g.row[0].order, 2, 1e-9);
}

/* Points of a plane on one row are those of a rod. */
static void points_on_one_row_are_a_rod(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    for (int n = 10; n <= 40; n *= 2) {
        FILE *out = answer("row", 4.0 / n);
        fputs("x,y,T\n", out);
        for (int i = 0; i < n; i++) {
            double h = 4.0 / n, x = -2 + h * (i + 0.5);
            fprintf(out, "%.17g,0.3,%.17g\n", x, smooth(x, 0.3, h));
        }
        fclose(out);
    }
    if (read_sub("row", &(struct numbers){.count = 1, .value = {0.213}}, &g, &why)) fail_msg("%s", why.text);
    assert_string_equal(g.row[1].name, "T at 0.213");
    assert_near(g.row[1].order, 2, 0.01);
    assert_near(g.row[1].extrapolated, smooth(0.213, 0.3, 0), 1e-4);
}

/* 3.25 + 0.002 h^2 with 6 digits: changes of 24 and 6 units, each off by one.  For ratios of 2 ln g is p ln 2, so
 * that p is open by (1/24 + 1/6)/ln 2.  A third of the h^2 has all digits. */
static void few_digits_leave_the_order_open(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) {
            double h = 0.4 / (1 << i);
            FILE *out = answer(k ? "all" : "six", h);
            fprintf(out, k ? "flux\n%.17g\n" : "flux\n%.6g\n", 3.25 + (k ? 0.002 / 3 : 0.002) * h * h);
            fclose(out);
        }
        if (read_sub(k ? "all" : "six", &(struct numbers){0}, &g, &why)) fail_msg("%s", why.text);
        assert_near(g.row[0].order, 2, 1e-6);
        if (k)
            assert_order(g.row[0].unsure, <, 1e-6);
        else
            assert_near(g.row[0].unsure, (1 / 6.0 + 1 / 24.0) / log(2), 1e-3);
        if (!k) assert_int_equal(g.row[0].digits, 6);
    }
}

static void missing_answers_are_named(void **state) {
    (void)state;
    struct gci g;
    struct failure why;
    fclose(answer("two", 0.5));
    fclose(answer("two", 0.25));
    assert_int_equal(read_sub("two", &(struct numbers){0}, &g, &why), STATUS_INPUT);
    assert_has(why.text, "2 spacings; without an exact solution needs three");
    assert_int_equal(read_sub("none", &(struct numbers){0}, &g, &why), STATUS_INPUT);
    fclose(answer("two", 0.125));
    assert_int_equal(read_sub("two", &(struct numbers){0}, &g, &why), STATUS_INPUT);
    assert_has(why.text, "empty");
    static const char *const values[] = {"flux,heat\n1,2\n", "flux\n1.5\n", "flux,heat\n1.75,3\n"};
    for (int i = 0; i < 3; i++) {
        FILE *out = answer("fewer", 0.5 / (1 << i));
        fputs(values[i], out);
        fclose(out);
    }
    assert_int_equal(read_sub("fewer", &(struct numbers){0}, &g, &why), STATUS_INPUT);
    assert_has(why.text, "/fewer/0.25/out.csv: not a line of 2 names and one of as many numbers, as ");
    FILE *out = answer("fewer", 0.25);
    fputs("flux,cold\n1,2\n", out);
    fclose(out);
    assert_int_equal(read_sub("fewer", &(struct numbers){0}, &g, &why), STATUS_INPUT);
    assert_has(why.text, "/fewer/0.25/out.csv, line 1: column 2 is 'cold', but 'heat' in ");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_order_is_found_for_any_ratios),
        cmocka_unit_test(nonmonotone_changes_have_no_order),
        cmocka_unit_test(gci_with_unequal_ratios),
        cmocka_unit_test(gci_of_quantities),
        cmocka_unit_test(fields_on_different_points),
        cmocka_unit_test(long_quantity_names_are_cut),
        cmocka_unit_test(points_on_one_row_are_a_rod),
        cmocka_unit_test(few_digits_leave_the_order_open),
        cmocka_unit_test(missing_answers_are_named),
        cmocka_unit_test(interpolation_between_cells_leaves_the_order),
        cmocka_unit_test(interpolation_that_hides_the_order_is_refused),
    };
    char command[UNIT_PATH + 32];
    gsl_set_error_handler_off();
    if (!scratch_directory(dir, "gci-test")) return 1;
    int failed = cmocka_run_group_tests_name("gci", tests, NULL, NULL);
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command) || failed;
}
