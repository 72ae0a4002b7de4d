/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What programs leave as an answer: tables and VTK of many kinds read alike, and what is no answer refused with line,
 * column and what would be right. */
#include "verification/foreign/field_file.h"

#include "references/scene.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "verification/foreign/samples.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[UNIT_PATH];

static void put(const char *text, size_t size) {
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, size, out), size);
    fclose(out);
}

static int read_as(const char *text, int dim, const char *map, struct samples *s, struct failure *why) {
    struct column_map c = {0};
    if (map && samples_columns_read(map, &c, why)) return why->status;
    put(text, strlen(text));
    return field_file_samples(path, path, dim, &c, s, why);
}

/* Two points, (-2.5, 0.75) and (1.25, 0.5) where there is a y, at 3.5e-12 K and 7 K. */
static void reads(const char *text, int dim, const char *map) {
    struct samples s;
    struct failure why;
    if (read_as(text, dim, map, &s, &why)) fail_msg("%s: %s", text, why.text);
    assert_int_equal(s.n, 2);
    assert_near(s.value[COLUMN_X][0], -2.5, 0);
    assert_near(s.value[COLUMN_X][1], 1.25, 0);
    if (dim == 2) assert_near(s.value[COLUMN_Y][0], 0.75, 0);
    if (dim == 2) assert_near(s.value[COLUMN_Y][1], 0.5, 0);
    assert_near(s.value[COLUMN_T][0], 3.5e-12, 1e-27);
    assert_near(s.value[COLUMN_T][1], 7, 0);
    samples_free(&s);
}

static void refuses(const char *text, int dim, const char *map, const char *because) {
    struct samples s;
    struct failure why = {0};
    if (!read_as(text, dim, map, &s, &why)) fail_msg("was read: %s", text);
    if (!strstr(why.text, because)) fail_msg("%s: %s", text, why.text);
}

static void tables_of_all_kinds(void **state) {
    (void)state;
    reads("x,T\n-2.5,3.5e-12\n1.25,7\n", 1, NULL);
    reads("T,x\n3.5e-12,-2.5\n7,1.25\n", 1, NULL);
    reads("x,y,T\n-2.5,0.75,3.5e-12\n1.25,0.5,7\n", 2, NULL);
    reads("\xEF\xBB\xBFx;T\r\n-2.5;3.5e-12\r\n1.25;7\r\n", 1, NULL);
    reads("  x \t T\n  -2.5   3.5D-12\n\n   1.25 .7d+01  \n", 1, NULL);
    reads("# made by hand\n# x T\n-2.5 3.5-12\n1.25 0.7+1\n", 1, NULL);
    reads("\"Points:0\",\"Points:1\",\"a, b\",'T [K]'\n-2.5,9,1,3.5e-12\n1.25,9,2,7\n", 1, "x=Points:0,T=T [K]");
    reads("\"\",\"x\",\"T\"\n\"1\",-2.5,3.5e-12\n\"2\",1.25,7\n", 1, NULL); /* R's row names have none */
    reads("-2.5 8 3.5e-12\n1.25 8 7\n", 1, "x=1,T=3");
    reads("# made by hand, today\n-2.5 8 3.5e-12\n1.25 8 7\n", 1, "x=1,T=3");
    reads("# x;T;w\n-2.5 3.5e-12 8\n1.25 7 8\n", 1, NULL);
    reads("x,z,temp,y\n-2.5,4,3.5e-12,0.75\n1.25,4,7,0.5\n", 2, "T=temp");
}

static void weights_and_what_it_took(void **state) {
    (void)state;
    struct samples s;
    struct failure why;
    assert_int_equal(read_as("# seconds = 0.75\n# steps = 12\nx,T,w\n1.5,2,0.25\n", 1, NULL, &s, &why), 0);
    assert_near(s.value[COLUMN_W][0], 0.25, 0);
    assert_near(s.seconds, 0.75, 0);
    assert_near(s.steps, 12, 0);
    samples_free(&s);
    assert_int_equal(read_as("# seconds = inf\n# steps = -3\n# updates = 0x10\nx,T\n1.5,2\n", 1, NULL, &s, &why), 0);
    assert_nan(s.seconds);
    assert_nan(s.steps);
    assert_nan(s.updates);
    samples_free(&s);
    assert_int_equal(read_as("x,T,vol\n1.5,2,0.25\n", 1, "w=vol", &s, &why), 0);
    assert_near(s.value[COLUMN_W][0], 0.25, 0);
    samples_free(&s);
}

static void vtk_of_several_kinds(void **state) {
    (void)state;
    reads("# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 double\n-2.5 0.75 0 1.25 "
          "0.5 0\n"
          "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\nPOINT_DATA 2\nSCALARS rank int 1\nLOOKUP_TABLE default\n4 5\n"
          "SCALARS T double\nLOOKUP_TABLE default\n3.5e-12\n7\n",
          2, NULL);
    reads("# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n-2.5 0.75 0\n1.25 0.5 "
          "0\nPOINT_DATA 2\n"
          "FIELD attributes 2\nU 3 2 float\n1 2 3 4 5 6\ntemp 1 2 float\n3.5e-12 7\n",
          1, "T=temp");
}

#define HEAD "# vtk DataFile Version 3.0\nt\nASCII\n"
#define TWO "POINTS 2 float\n-2.5 0.75 0 1.25 0.5 0\n"

/* Weights, arrays of vectors, of components that are said, and of cells and points in any order. */
static void vtk_with_more_in_it(void **state) {
    (void)state;
    static const char *const text[] = {
        HEAD TWO "CELL_DATA 1\nSCALARS T float 1\nLOOKUP_TABLE default\n9\nPOINT_DATA 2\nSCALARS v float 2\n"
                 "LOOKUP_TABLE default\n1 2 3 4\nSCALARS T float 1\nLOOKUP_TABLE default\n3.5e-12 7\n"
                 "SCALARS w float\nLOOKUP_TABLE default\n0.25 0.75\n",
        HEAD "POINT_DATA 2\nFIELD f 3\nT 2 2 float\n9 9 9 9\nw 1 2 float\n0.25 0.75\nT 1 2 float\n3.5e-12\n7\n" TWO};
    for (int k = 0; k < 2; k++) {
        struct samples s;
        struct failure why;
        reads(text[k], 2, NULL);
        if (read_as(text[k], 2, "w=w", &s, &why)) fail_msg("%s", why.text);
        assert_near(s.value[COLUMN_W][0], 0.25, 0);
        assert_near(s.value[COLUMN_W][1], 0.75, 0);
        samples_free(&s);
    }
}

static void vtk_that_is_none(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {HEAD "POINTS two float\n", "line 4: a count is missing or is no whole number"},
        {HEAD "POINTS\n", "line 5: a count is missing"},
        {HEAD TWO "POINT_DATA 2\nSCALARS T\n", "line 8: SCALARS needs a name and a type"},
        {HEAD TWO "POINT_DATA 2\nSCALARS T float\n", "line 8: SCALARS without values"},
        {HEAD TWO "POINT_DATA 2\nSCALARS T float\n\nb\n", "line 9: a count is missing"},
        {HEAD TWO "POINT_DATA 2\nFIELD f\n", "line 8: FIELD needs a name and a count"},
        {HEAD TWO "POINT_DATA 2\nFIELD f 2\nT 1 2 float 1 2\n", "line 9: the file ends within FIELD"},
        {HEAD TWO "POINT_DATA 2\nFIELD f 1\nT 1 b float 1 2\n", "line 8: a count is missing"},
        {HEAD TWO "POINT_DATA 2\nFIELD f 1\nT 1 2 float 1\n", "line 9: the file ends within an array"},
        {HEAD TWO "POINT_DATA 2\nSCALARS T float\nLOOKUP_TABLE t\n1\nwarm\n",
         "line 10, column 1: T = 'warm' is not a decimal number"},
        {HEAD TWO "POINT_DATA 3\nSCALARS T float\nLOOKUP_TABLE t\n1 2 3\n", "3 values of T at 2 points"},
        {HEAD TWO "POINT_DATA 1\nSCALARS T float\nLOOKUP_TABLE t\n1\n", "1 values of T at 2 points"},
        {HEAD "POINT_DATA 1\nSCALARS T float\nLOOKUP_TABLE t\n1\n", "no POINTS"},
        {HEAD TWO, "no point data 'T' (there are: none); --columns T=NAME names them"},
        {HEAD TWO "POINT_DATA 2\nSCALARS a float\nLOOKUP_TABLE t\n1 2\nFIELD f 1\nb 1 2 float\n1 2\n",
         "no point data 'T' (there are: a, b)"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) refuses(bad[i].text, 1, NULL, bad[i].says);
    put(HEAD "T\0\n", sizeof HEAD + 2);
    struct samples s;
    struct failure why;
    assert_int_equal(field_file_samples(path, path, 1, &(struct column_map){0}, &s, &why), STATUS_INPUT);
    assert_has(why.text, "holds a NUL byte: not ascii");
    refuses("# vtk DataFile", 1, NULL, "ends without a newline");
}

static void what_is_no_answer(void **state) {
    (void)state;
    refuses("# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n-2.5 0.75 0\nPOINT_DATA 1\n"
            "SCALARS T double\nLOOKUP_TABLE default\n0.8",
            1, NULL, "ends without a newline");
    refuses("x,T\n1,2\n3,warm\n", 1, NULL, "line 3, column 2: T = 'warm' is not a decimal number");
    refuses("x,T\n1,2\n3,\n", 1, NULL, "line 3, column 2: T = ''");
    refuses("x,T\n1,0x1p3\n", 1, NULL, "not a hexadecimal");
    refuses("x,T\n1,*****\n", 1, NULL, "Fortran prints asterisks");
    refuses("x;T\n1;2,5\n", 1, NULL, "a number with a decimal point");
    refuses("x,T\n1,-Infinity\n", 1, NULL, "line 2, column 2: T = -Infinity is not finite");
    refuses("x,T\n1,2,3\n", 1, NULL, "line 2: 3 columns where the lines above have 2");
    refuses("x,T\n1,2\n3,0.8", 1, NULL, "line 3: ends without a newline");
    refuses("x,y\n1,2\n", 1, NULL, "line 1: 'x,y' should be the header x,T");
    refuses("x,T,T\n1,2,3\n", 1, NULL, "two columns are called 'T'");
    refuses("1,2\n", 1, NULL, "line 1: '1,2' should be the header x,T");
    refuses("x,T\n", 1, NULL, "a header and no point");
    refuses("# nothing\n", 1, NULL, "comments and no point");
    refuses("", 1, NULL, "empty");
    refuses("x,T\n1,2\n", 1, "t=T", "--columns 't=T'");
    refuses("x,T\n1,2\n", 1, "T=a,T=b", "T is given twice");
    refuses("# vtk DataFile Version 3.0\nt\nBINARY\n", 1, NULL, "line 3: ASCII is wanted");
    refuses("# vtk DataFile Version 3.0\nt\nASCII\nPOINTS 2 float\n1 2 3 4\n", 1, NULL, "ends within an array");
    refuses("# vtk DataFile Version 3.0\nt\nASCII\nPOINTS 1 float\n1 2 3\nCELL_DATA 1\nSCALARS T float\n1\n", 1, NULL,
            "cell data are not at points");
    refuses("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n", 1, NULL, "write legacy ASCII VTK, CSV");
    refuses("\n<VTKFile><Points><DataArray format=\"ascii\"/></Points>", 1, NULL, "a VTU file is not read");
    put("x,T\n1,2\0,5\n", 11);
    struct samples s;
    struct failure why;
    assert_int_equal(field_file_samples(path, path, 1, &(struct column_map){0}, &s, &why), STATUS_INPUT);
    assert_has(why.text, "line 2: a NUL byte");
}

/* The square [-2, 2]^2 of square-step, or the rod of rod-step, with n by n points that the caller moves. */
struct cloud {
    struct problem p;
    int n;
    double first, step; /* of a coordinate, in spacings 4/n from the low wall */
};

static int judge(const struct cloud *c, int skip, struct field *f, struct failure *why) {
    FILE *out = fopen(path, "w");
    double dx = 4.0 / c->n;
    fprintf(out, c->p.dim == 2 ? "x,y,T\n" : "x,T\n");
    for (int j = 0; j < (c->p.dim == 2 ? c->n : 1); j++)
        for (int i = 0; i < c->n; i++) {
            if (i < skip) continue;
            fprintf(out, "%.17g,", -2 + dx * (c->first + c->step * i));
            if (c->p.dim == 2) fprintf(out, "%.17g,", -2 + dx * (c->first + c->step * j));
            fprintf(out, "3.5\n");
        }
    fclose(out);
    return field_file_read(path, path, &(struct column_map){0}, &c->p, (double[2]){dx, dx}, f, why);
}

static struct cloud cloud(const char *scene, int n, double first, double step) {
    struct cloud c = {.n = n, .first = first, .step = step};
    struct failure why;
    scene_defaults(scene_find(scene), &c.p);
    assert_int_equal(scene_find(scene)->setup(&c.p, &why), 0);
    return c;
}

static void the_usual_arrangements_cover(void **state) {
    (void)state;
    static const char *const scene[] = {"rod-step", "square-step"};
    for (int s = 0; s < 2; s++)
        for (int n = 4; n < 80; n = n * 3 / 2) {
            struct cloud usual[] = {cloud(scene[s], n, 0.5, 1),                /* cell centres */
                                    cloud(scene[s], n, 0, n / (n - 1.0)),      /* nodes, the walls' too */
                                    cloud(scene[s], n, 0, 1),                  /* nodes between the walls */
                                    cloud(scene[s], n, 0.211, 1 - 0.422 / n)}; /* off the walls, not symmetric */
            for (int k = 0; k < 4; k++) {
                struct field f;
                struct failure why;
                if (judge(&usual[k], k == 2, &f, &why)) fail_msg("%s, n %d, %d: %s", scene[s], n, k, why.text);
                field_free(&f);
            }
        }
}

static void parts_of_the_domain_do_not(void **state) {
    (void)state;
    static const char *const scene[] = {"rod-step", "square-step"};
    for (int s = 0; s < 2; s++)
        for (int n = 8; n < 80; n = n * 3 / 2) {
            struct field f;
            struct failure why;
            struct cloud half = cloud(scene[s], n, 0.25, 0.5), few = cloud(scene[s], n, 0.5, 1);
            assert_int_equal(judge(&half, 0, &f, &why), STATUS_INPUT);
            if (!strstr(why.text, "must cover the whole domain")) fail_msg("%s", why.text);
            assert_int_equal(judge(&few, n / 2, &f, &why), STATUS_INPUT);
            if (!strstr(why.text, "at least")) fail_msg("%s", why.text);
            struct cloud outside = cloud(scene[s], n, 1.5, 1), same = cloud(scene[s], n, 0.5, 1);
            assert_int_equal(judge(&outside, 0, &f, &why), STATUS_INPUT);
            if (!strstr(why.text, "is outside -2 to 2 m")) fail_msg("%s", why.text);
            same.step = (n - 1.0) / n;
            assert_int_equal(judge(&same, 0, &f, &why), 0);
            field_free(&f);
        }
}

/* Twelve by twelve points in four by four boxes, of which one is empty. */
static void the_gap_is_said(void **state) {
    (void)state;
    struct cloud c = cloud("square-step", 12, 0, 0);
    struct field f;
    struct failure why;
    FILE *out = fopen(path, "w");
    fprintf(out, "x,y,T\n");
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 12; i++)
            if (i / 3 != 2 || j / 3 != 3) fprintf(out, "%.17g,%.17g,1\n", -2 + (i + 0.5) / 3, -2 + (j + 0.5) / 3);
    fclose(out);
    assert_int_equal(
        field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){1 / 3.0, 1 / 3.0}, &f, &why),
        STATUS_INPUT);
    assert_has(why.text, "no point in 0 <= x <= 1 m, 1 <= y <= 2 m:");
}

/* 160 x 160 points, enough for threads, of which two are outside: the first of them is named.  In the square it
 * is the first along x, as axes are looked at in turn; in the disc those in its corners. */
static void of_many_points_the_first_is_named(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        int first[2];
        const char *says;
    } cases[] = {{"square-step", {25000, 9000}, "line 9002: x = -7 m is outside -2 to 2 m"},
                 {"square-step", {9000, 25000}, "line 9002: x = -7 m is outside"},
                 {"disc-mode", {-1, -1}, "line 2: (-"}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct cloud c = cloud(cases[k].scene, 160, 0, 0);
        double dx = (c.p.hi[0] - c.p.lo[0]) / 160;
        struct field f;
        struct failure why;
        FILE *out = fopen(path, "w");
        fprintf(out, "x,y,T\n");
        for (int i = 0; i < 160 * 160; i++) {
            int is_out = i == cases[k].first[0] || i == cases[k].first[1];
            fprintf(out, "%.17g,%.17g,1\n", is_out ? -7 : c.p.lo[0] + dx * (i % 160 + 0.5),
                    c.p.lo[1] + dx * (i / 160 + 0.5));
        }
        fclose(out);
        assert_int_equal(field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){dx, dx}, &f, &why),
                         STATUS_INPUT);
        assert_has(why.text, cases[k].says);
    }
}

static void a_point_counts_once(void **state) {
    (void)state;
    struct cloud c = cloud("rod-step", 8, 0, 0);
    struct field f;
    struct failure why;
    static const char *const text[] = {
        "x,T\n-1.75,1\n-1.25,2\n-0.75,1\n-0.25,2\n0.25,1\n0.25000000001,2\n0.75,1\n1.25,2\n1.75,1\n",
        "x,T\n0.25,1\n-1.75,1\n-1.25,2\n-0.75,1\n-0.25,2\n0.25000000001,2\n0.75,1\n1.25,2\n1.75,1\n"};
    static const char *const says[] = {"line 7: the same point as in line 6", "line 7: the same point as in line 2"};
    for (int i = 0; i < 2; i++) { /* in order, and not */
        put(text[i], strlen(text[i]));
        assert_int_equal(field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){0.5, 0.5}, &f, &why),
                         STATUS_INPUT);
        assert_has(why.text, says[i]);
    }
}

/* 0.1 m is a wall of the plate, and so is 0.0999999999999 m, wherever the plate lies. */
static void rounded_coordinates_lie_on_the_walls(void **state) {
    (void)state;
    struct cloud c = cloud("plate", 11, 0, 1);
    struct field f;
    struct failure why;
    FILE *out = fopen(path, "w");
    fprintf(out, "x,y,T,w\n");
    for (int j = 0; j <= 10; j++)
        for (int i = 0; i <= 10; i++)
            fprintf(out, "%.17g,%.17g,%d,%d\n", 0.0099999999999 * i, 1e-13 + 0.01 * j, i + 20 * j, 1 + i);
    fclose(out);
    assert_int_equal(field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){0.01, 0.01}, &f, &why),
                     0);
    assert_int_equal(f.n, 121);
    assert_near(f.x[10], 0.1, 0);
    assert_near(f.y[120], 0.1, 0);
    assert_near(f.y[5], 0, 0);
    assert_near(f.T[21], 30, 0);
    assert_near(f.weight[21], 11, 0);
    field_free(&f);
    c.p.lo[0] -= 0.1, c.p.hi[0] -= 0.1;
    out = fopen(path, "w");
    fprintf(out, "x,y,T\n");
    for (int j = 0; j <= 10; j++)
        for (int i = 0; i <= 10; i++) fprintf(out, "%.17g,%.17g,1\n", -1e-13 - 0.01 * (10 - i), 0.01 * j);
    fclose(out);
    assert_int_equal(field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){0.01, 0.01}, &f, &why),
                     0);
    assert_near(f.x[0], -0.1, 0);
    assert_near(f.x[10], 0, 0);
    field_free(&f);
}

/* A rod of two cells, which the one node between its walls stands for. */
static void one_point_covers_two_cells(void **state) {
    (void)state;
    struct cloud c = cloud("rod-step", 2, 1, 1);
    struct field f;
    struct failure why;
    put("x,T\n0,3\n", 8);
    if (field_file_read(path, path, &(struct column_map){0}, &c.p, (double[2]){2, 2}, &f, &why))
        fail_msg("%s", why.text);
    assert_int_equal(f.n, 1);
    field_free(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_of_all_kinds),
        cmocka_unit_test(weights_and_what_it_took),
        cmocka_unit_test(vtk_of_several_kinds),
        cmocka_unit_test(vtk_with_more_in_it),
        cmocka_unit_test(vtk_that_is_none),
        cmocka_unit_test(what_is_no_answer),
        cmocka_unit_test(the_usual_arrangements_cover),
        cmocka_unit_test(parts_of_the_domain_do_not),
        cmocka_unit_test(the_gap_is_said),
        cmocka_unit_test(of_many_points_the_first_is_named),
        cmocka_unit_test(a_point_counts_once),
        cmocka_unit_test(rounded_coordinates_lie_on_the_walls),
        cmocka_unit_test(one_point_covers_two_cells),
    };
    int file = scratch_file(path, "field-file-test");
    if (file < 0 || close(file)) return 1;
    int failed = cmocka_run_group_tests_name("field_file", tests, NULL, NULL);
    unlink(path);
    return failed;
}
