/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers of programs: tables and NumPy arrays of many kinds give the same field; anything else is refused with its
 * line, its column and a remedy. */
#include "verification/solve/field_file.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/field.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/case/samples.h"

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

static int read_file(int dim, const char *map, struct samples *s, struct failure *why) {
    struct column_map c = {0};
    if (map && samples_columns_read(map, &c, why)) return why->status;
    return samples_read(path, path, dim, &c, s, why);
}

static int read_as(const char *text, int dim, const char *map, struct samples *s, struct failure *why) {
    put(text, strlen(text));
    return read_file(dim, map, s, why);
}

/* Each row is two points, (-2.5, 0.75) and (1.25, 0.5) where there is a y, at 3.5e-12 K and 7 K. */
static void table_dialects_read_the_same(void **state) {
    (void)state;
    static const struct {
        int dim;
        const char *map, *text;
    } row[] = {
        {1, NULL, "x,T\n-2.5,3.5e-12\n1.25,7\n"},
        {1, NULL, "T,x\n3.5e-12,-2.5\n7,1.25\n"},
        {2, NULL, "x,y,T\n-2.5,0.75,3.5e-12\n1.25,0.5,7\n"},
        {1, NULL, "\xEF\xBB\xBFx;T\r\n-2.5;3.5e-12\r\n1.25;7\r\n"},
        {1, NULL, "  x \t T\n  -2.5   3.5D-12\n\n   1.25 .7d+01  \n"},
        {1, NULL, "# made by hand\n# x T\n-2.5 3.5-12\n1.25 0.7+1\n"},
        {1, NULL, "# x T\n# made by hand\n-2.5 3.5e-12\n1.25 7\n"},
        {1, NULL, "# T against x at\n# x T\n# seconds = 3\n-2.5 3.5e-12\n1.25 7\n"},
        {1, NULL, "# x;T;w\n-2.5 3.5e-12 8\n1.25 7 8\n"},
        {1, "x=Points:0,T=T [K]", "\"Points:0\",\"Points:1\",\"a, b\",'T [K]'\n-2.5,9,1,3.5e-12\n1.25,9,2,7\n"},
        {1, NULL, "\"\",\"x\",\"T\"\n\"1\",-2.5,3.5e-12\n\"2\",1.25,7\n"}, /* row names of R */
        {1, "x=1,T=3", "-2.5 8 3.5e-12\n1.25 8 7\n"},
        {1, "x=1,T=3", "# made by hand, today\n-2.5 8 3.5e-12\n1.25 8 7\n"},
        {2, "T=temp", "x,z,temp,y\n-2.5,4,3.5e-12,0.75\n1.25,4,7,0.5\n"},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct samples s;
        struct failure why;
        if (read_as(row[i].text, row[i].dim, row[i].map, &s, &why)) fail_msg("%s: %s", row[i].text, why.text);
        assert_int_equal(s.n, 2);
        assert_true(s.value[COLUMN_X][0] == -2.5 && s.value[COLUMN_X][1] == 1.25 && s.value[COLUMN_T][1] == 7);
        assert_near(s.value[COLUMN_T][0], 3.5e-12, 1e-27);
        if (row[i].dim == 2) assert_true(s.value[COLUMN_Y][0] == 0.75 && s.value[COLUMN_Y][1] == 0.5);
        samples_free(&s);
    }
}

static void tables_may_give_weights_and_cost(void **state) {
    (void)state;
    struct samples s;
    struct failure why;
    assert_int_equal(read_as("# seconds = 0.75\n# steps = 12\nx,T,w\n1.5,2,0.25\n", 1, NULL, &s, &why), 0);
    assert_true(s.value[COLUMN_W][0] == 0.25 && s.seconds == 0.75 && s.steps == 12);
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

static void invalid_tables_name_line_and_column(void **state) {
    (void)state;
    static const struct {
        const char *text, *says, *map;
        int status, size; /* STATUS_INPUT and the whole text where 0 */
    } row[] = {
        {"x,T\n1,2\n3,warm\n", "line 3, column 2 (T): 'warm' is not a decimal number", NULL, 0, 0},
        {"x,T\n1,2\n3,\n", "line 3, column 2 (T): ''", NULL, 0, 0},
        {"x,T\n1,0x1p3\n", "not a decimal number, but a hexadecimal one", NULL, 0, 0},
        {"x,T\n1,*****\n", "Fortran prints asterisks", NULL, 0, 0},
        {"x;T\n1;2,5\n", "a number with a decimal point", NULL, 0, 0},
        {"x,T\n1,-Infinity\n", "line 2, column 2 (T): '-Infinity' is not a finite number", NULL, STATUS_NUMERICAL, 0},
        {"x,T\n1,-1.#IND\n", "line 2, column 2 (T): '-1.#IND' is not a finite number", NULL, STATUS_NUMERICAL, 0},
        {"x,T\n1,1.#INF00\n", "'1.#INF00' is not a finite number", NULL, STATUS_NUMERICAL, 0},
        {"x,T\n1,2,3\n", "line 2: 3 columns where the lines above have 2", NULL, 0, 0},
        {"x,T\n1,2\n3,0.8", "line 3: ends without a newline", NULL, 0, 0},
        {"x,T\n1,2\r3,4\n5,6\n", "line 2: a carriage return", NULL, 0, 0},
        {"x,T\r1,2\r", "line 1: a carriage return", NULL, 0, 0},
        {"x,y\n1,2\n", "line 1: 'x,y' should be the header x,T", NULL, 0, 0},
        {"# x,T,w\n1,2\n", "line 2: '1,2' should be the header x,T", NULL, 0, 0},
        {"x,T,T\n1,2,3\n", "two columns are called 'T'", NULL, 0, 0},
        {"1,2\n", "line 1: '1,2' should be the header x,T", NULL, 0, 0},
        {"x,T\n", "a header and no point", NULL, 0, 0},
        {"# nothing\n", "comments and no point", NULL, 0, 0},
        {"", "empty", NULL, 0, 0},
        {"x,T\n1,2\n", "--columns 't=T'", "t=T", 0, 0},
        {"x,T\n1,2\n", "T is given twice", "T=a,T=b", 0, 0},
        {"x,T\n1,2\0,5\n", "line 2: a NUL byte", NULL, 0, 11},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct samples s;
        struct failure why = {0};
        put(row[i].text, row[i].size ? (size_t)row[i].size : strlen(row[i].text));
        assert_int_equal(read_file(1, row[i].map, &s, &why), row[i].status ? row[i].status : STATUS_INPUT);
        assert_has(why.text, row[i].says);
    }
}

/* Columns in any order and by any name.  In the plane several layers are refused; in space a plane is. */
static void tables_in_space_have_three_coordinates(void **state) {
    (void)state;
    struct samples s;
    struct failure why;
    static const char *const text[] = {"x,y,z,T\n1,2,3,4\n5,6,7,8\n", "T;z;w;x;y\n4;3;9;1;2\n8;7;9;5;6\n",
                                       "# T y c b x\n4 2 9 3 1\n8 6 9 7 5\n"};
    for (int i = 0; i < 3; i++) {
        if (read_as(text[i], 3, i == 2 ? "z=b" : NULL, &s, &why)) fail_msg("%s", why.text);
        for (int k = COLUMN_X; k <= COLUMN_T; k++) assert_true(s.value[k][0] == k + 1 && s.value[k][1] == k + 5);
        samples_free(&s);
    }
    assert_int_equal(read_as("x,y,T\n1,2,4\n", 3, NULL, &s, &why), STATUS_INPUT);
    assert_has(why.text, "line 1: 'x,y,T' should be the header x,y,z,T");
    assert_int_equal(read_as("x,y,T\n1,2,4\n", 3, "z=Z", &s, &why), STATUS_INPUT);
    assert_has(why.text, "should be the header x,y,Z,T");
    assert_int_equal(read_as("x,y,z,T\n1,2,3,4\n5,6,7,8\n", 2, NULL, &s, &why), STATUS_INPUT);
    assert_has(why.text, "line 3: z = 7 m, but 3 m above: the case is in the plane; answer x,y,T with one layer");
    for (int dim = 1; dim <= 2; dim++) {
        assert_int_equal(read_as("x,y,z,T\n1,2,3,4\n5,6,3,8\n", dim, "x=x,y=y,z=z", &s, &why), 0);
        assert_true(s.value[COLUMN_T][1] == 8);
        samples_free(&s);
    }
}

/* ---- NumPy ---- */

/* A header of `length` bytes, padded, then n bytes of data.  Version 2 has four bytes of length. */
static void put_npy(int version, const char *header, size_t length, const void *data, size_t n) {
    FILE *out = fopen(path, "w");
    fprintf(out, "\x93NUMPY%c%c%c%c", version, 0, (int)(length & 255), (int)(length >> 8 & 255));
    if (version > 1) fprintf(out, "%c%c", (int)(length >> 16), 0);
    fprintf(out, "%-*s", (int)length, header);
    if (n) assert_int_equal(fwrite(data, 1, n, out), n);
    fclose(out);
}

#define FORTRAN(type, shape) "{'descr': " type ", 'fortran_order': True, 'shape': " shape ", }"
#define ARRAY(type, shape) "{'descr': " type ", 'fortran_order': False, 'shape': " shape ", }"

/* Eight numbers, 0.5 to 7.5: each row names where the last point's x, y, z, T and w are among them; -1: nowhere. */
static void numpy_columns_and_fields_are_read(void **state) {
    (void)state;
    static const struct {
        const char *header, *map;
        int dim, n, at[COLUMN_COUNT];
    } row[] = {
        {ARRAY("'<f8'", "(4, 2)"), NULL, 1, 4, {6, -1, -1, 7, -1}},
        {ARRAY("'<f8'", "(2, 4)"), "x=1,y=2,T=3,w=4", 2, 2, {4, 5, -1, 6, 7}},
        {FORTRAN("'<f8'", "(2, 4)"), NULL, 3, 2, {1, 3, 5, 7, -1}},
        {FORTRAN("'<f8'", "(4, 2)"), "T=1,x=2", 1, 4, {7, -1, -1, 3, -1}},
        {ARRAY("'<f8'", "(2, 4)"), NULL, 3, 2, {4, 5, 6, 7, -1}},
        {ARRAY("'<f8'", "(1, 8)"), "x=1,y=2,z=3,T=4,w=5", 3, 1, {0, 1, 2, 3, 4}},
        {ARRAY("'<f8'", "(2, 4)"), "z=1,x=2,T=3,y=4", 3, 2, {5, 7, 4, 6, -1}},
        {ARRAY("'<f8'", "(2, 4)"), "x=4,T=2", 1, 2, {7, -1, -1, 5, -1}},
        {ARRAY("'<f8'", "(2, 4)"), "x=4,y=1,z=3,T=2", 1, 2, {7, -1, -1, 5, -1}},
        {ARRAY("'<f8'", "(2, 4)"), "x=1,T=2,w=3", 1, 2, {4, -1, -1, 5, 6}},
        {ARRAY("[('T', '<f8'), ('p', '<f8'), ('y', '<f8'), ('x', '<f8')]", "(2,)"), NULL, 2, 2, {7, 6, -1, 4, -1}},
        {ARRAY("[('T', '<f8'), ('p', '<f8'), ('y', '<f8'), ('x', '<f8')]", "(2,)"), "w=p", 1, 2, {7, -1, -1, 4, 5}},
        {ARRAY("[('T', '<f8'), ('p', '<f8'), ('y', '<f8'), ('x', '<f8')]", "(2,)"), "z=p", 3, 2, {7, 6, 5, 4, -1}},
        {ARRAY("[('temp', '<f8'), ('x', '<f8')]", "(4,)"), "T=temp", 1, 4, {7, -1, -1, 6, -1}},
    };
    double number[8];
    float single[8];
    for (int i = 0; i < 8; i++) number[i] = i + 0.5, single[i] = (float)number[i];
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (int bytes = 4; bytes <= 8; bytes += 4) {
            char header[200];
            struct samples s;
            struct failure why = {0};
            snprintf(header, sizeof header, "%s", row[i].header);
            for (char *f8 = header; bytes == 4 && (f8 = strstr(f8, "<f8"));) f8[2] = '4';
            put_npy(1, header, strlen(header), bytes == 8 ? (const void *)number : single, (size_t)bytes * 8);
            if (read_file(row[i].dim, row[i].map, &s, &why)) fail_msg("%s: %s", header, why.text);
            assert_int_equal(s.n, row[i].n);
            for (int k = 0; k < COLUMN_COUNT; k++) {
                assert_int_equal(s.value[k] != NULL, row[i].at[k] >= 0);
                if (s.value[k]) assert_near(s.value[k][s.n - 1], number[row[i].at[k]], 0);
            }
            samples_free(&s);
        }
}

static void long_numpy_files_are_read(void **state) {
    (void)state;
    enum { ROWS = 9000 };
    static double value[2 * ROWS];
    struct samples s;
    struct failure why;
    for (int i = 0; i < 2 * ROWS; i++) value[i] = 0.5 * i;
    put_npy(2, ARRAY("'<f8'", "(9000, 2)"), 4095, value, sizeof value);
    assert_int_equal(read_file(1, NULL, &s, &why), 0);
    assert_int_equal(s.n, ROWS);
    for (int i = 0; i < ROWS; i++) assert_true(s.value[COLUMN_X][i] == i && s.value[COLUMN_T][i] == i + 0.5);
    samples_free(&s);
}

static void other_numpy_arrays_are_refused(void **state) {
    (void)state;
    static const double data[] = {0.1, 3, 0.2, NAN, 1, 2, 3, 4};
    static const struct {
        const char *header;
        int size, dim;
        const char *map, *says;
    } row[] = {
        {ARRAY("'<f8'", "(2, 2)"), 32, 1, NULL, "row 2: T is not finite"},
        {ARRAY("'<f8'", "(2, 2)"), 24, 1, NULL, "cut off after 24 of 32 bytes"},
        {ARRAY("'<f8'", "(1, 2)"), 24, 1, NULL, "goes on after its last row"},
        {ARRAY("'<f8'", "(1, 5)"), 40, 1, NULL, "5 columns; it needs x, T"},
        {ARRAY("'<f8'", "(1, 1)"), 8, 1, NULL, "1 columns; it needs x, T"},
        {ARRAY("'<f8'", "(1, 3)"), 24, 1, NULL, "3 columns for a rod: x, T, w or x, y, T?"},
        {ARRAY("'<f8'", "(1, 4)"), 32, 2, NULL, "4 columns in the plane: x, y, T, w or x, y, z, T?"},
        {ARRAY("'<f8'", "(1, 3)"), 24, 3, NULL, "3 columns; it needs x, y, z, T"},
        {ARRAY("'<f8'", "(2, 4)"), 64, 2, "x=1,y=2,z=4,T=3", "row 1: z is not finite"},
        {ARRAY("'<f8'", "(4, 2)"), 64, 3, "x=1,y=2,z=3,T=2", "no column '3'"},
        {ARRAY("'<f8'", "(1, 2)"), 16, 2, NULL, "2 columns; it needs x, y, T"},
        {ARRAY("'<f8'", "(1, 2)"), 16, 1, "T=temp",
         "no column 'x': --columns gives the places of an array of 2 columns, x=1 to 2"},
        {ARRAY("'<f8'", "(1, 2)"), 16, 1, "x=1,T=3", "no column '3'"},
        {ARRAY("'<f8'", "(1, 2)"), 16, 1, "x=1,T=0", "no column '0'"},
        {ARRAY("'<f8'", "(4,)"), 32, 1, NULL, "not n rows of two or more columns"},
        {ARRAY("'<f8'", "(0, 2)"), 0, 1, NULL, "no points"},
        {ARRAY("'|O'", "(2, 2)"), 32, 1, NULL, "'<f8' or '<f4'"},
        {ARRAY("'<f8'", "(2, 4)"), 64, 3, "x=2,y=3,T=4", "no column 'z'"},
        {"{'descr': '<f8', }", 32, 1, NULL, "a header without descr and shape"},
        {ARRAY("[('x', '<i8')]", "(2,)"), 16, 1, NULL, "a field is not one number of 8 or 4 bytes"},
        {ARRAY("[('pos', '<f8', (3,)), ('T', '<f8')]", "(1,)"), 32, 1, NULL, "a field is not one number"},
        {ARRAY("[('x', '<f8'", "(1,)"), 8, 1, NULL, "a field is not one number"},
        {ARRAY("[('x', '<f8'), ", "(1,)"), 8, 1, NULL, "a field is not one number"},
        {ARRAY("[]", "(1,)"), 8, 1, NULL, "no field 'x'"},
        {ARRAY("[('T', '<f8'), ('x', '<f8')]", "(2,)"), 32, 2, NULL, "no field 'y'"},
    };
    static const struct {
        int version;
        size_t header, cut;
        const char *says;
    } cut[] = {{2, 4096, 0, "a header of more than 4 kB"},
               {2, 65536 + 300, 0, "a header of more than 4 kB"}, /* 300 without its third byte */
               {1, 300, 200, "cut off in its header"},
               {2, 300, 11, "cut off in its header"}};
    struct samples s;
    struct failure why;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        put_npy(1, row[i].header, strlen(row[i].header), data, (size_t)row[i].size);
        assert_int_not_equal(read_file(row[i].dim, row[i].map, &s, &why), 0);
        assert_has(why.text, row[i].says);
    }
    for (size_t i = 0; i < sizeof cut / sizeof *cut; i++) {
        put_npy(cut[i].version, ARRAY("'<f8'", "(1, 2)"), cut[i].header, data, 16);
        if (cut[i].cut) assert_int_equal(truncate(path, (off_t)cut[i].cut), 0);
        assert_int_equal(read_file(1, NULL, &s, &why), STATUS_INPUT);
        assert_has(why.text, cut[i].says);
    }
}

/* 0.1 m is a wall of the plate, and so is 0.0999999999999 m, wherever the plate is. */
static void rounded_coordinates_snap_to_walls(void **state) {
    (void)state;
    for (int moved = 0; moved < 2; moved++) {
        struct problem p;
        struct field f;
        struct failure why;
        scene_defaults(scene_find("plate"), &p);
        assert_int_equal(scene_find("plate")->setup(&p, &why), 0);
        if (moved) p.lo[0] -= 0.1, p.hi[0] -= 0.1;
        FILE *out = fopen(path, "w");
        fprintf(out, "x,y,T,w\n");
        for (int j = 0; j <= 10; j++)
            for (int i = 0; i <= 10; i++)
                fprintf(out, "%.17g,%.17g,%d,%d\n", moved ? -1e-13 - 0.01 * (10 - i) : 0.0099999999999 * i,
                        1e-13 + 0.01 * j, i + 20 * j, 1 + i);
        fclose(out);
        if (field_file_read(path, path, &(struct column_map){0}, &(struct image){.problem = p},
                            (double[2]){0.01, 0.01}, &f, &why))
            fail_msg("%s", why.text);
        assert_int_equal(f.n, 121);
        assert_true(f.x[0][0] == p.lo[0] && f.x[0][10] == p.hi[0] && f.x[1][120] == p.hi[1] && f.x[1][5] == p.lo[1]);
        assert_true(f.T[21] == 30 && f.weight[21] == 11 / 8.0);
        field_free(&f);
    }
}

/* rod-gauss with weights of any size: the same errors but for rounding, or a line that is refused. */
static void weights_of_any_size_are_scaled(void **state) {
    (void)state;
    static const struct {
        double w[2]; /* all points but one; that one */
        const char *says;
    } row[] = {{{1e306, 1e306}, NULL},
               {{1e-320, 2e-320}, NULL},
               {{1e300, 1e-5}, NULL},
               {{0, 0}, "all weights w are 0"},
               {{1e300, 1e-10}, "line 9: w = 1e-10 beside a largest of 1e+300"},
               {{1, -1e-300}, "line 9: w = -1e-300; a weight must be 0 or more"}};
    struct problem p;
    struct failure why;
    scene_defaults(scene_find("rod-gauss"), &p);
    assert_int_equal(scene_find("rod-gauss")->setup(&p, &why), 0);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct field f;
        FILE *out = fopen(path, "w");
        fprintf(out, "x,T,w\n");
        for (int k = 0; k < 30; k++)
            fprintf(out, "%.17g,1.5,%.17g\n", p.lo[0] + (k + 0.5) / 30 * (p.hi[0] - p.lo[0]), row[i].w[k == 7]);
        fclose(out);
        const double dx = (p.hi[0] - p.lo[0]) / 30;
        int status =
            field_file_read(path, "out", &(struct column_map){0}, &(struct image){.problem = p}, &dx, &f, &why);
        assert_int_equal(status, row[i].says ? STATUS_INPUT : STATUS_OK);
        if (row[i].says) assert_has(why.text, row[i].says);
        if (row[i].says) continue;
        assert_near(f.weight[7] / f.weight[8], row[i].w[1] / row[i].w[0], 1e-15);
        assert_true(fmax(f.weight[7], f.weight[8]) >= 1 && fmax(f.weight[7], f.weight[8]) < 2);
        field_free(&f);
    }
}

/* Start and walls of rod-gauss are within 0 to 1 K or so: 1e11 K is an error, 1e30 K an overflow. */
static void overflow_is_named(void **state) {
    (void)state;
    struct problem p;
    struct failure why;
    scene_defaults(scene_find("rod-gauss"), &p);
    assert_int_equal(scene_find("rod-gauss")->setup(&p, &why), 0);
    for (int large = 0; large < 2; large++) {
        struct field f;
        const double dx = (p.hi[0] - p.lo[0]) / 30;
        FILE *out = fopen(path, "w");
        fprintf(out, "x,T\n");
        for (int k = 0; k < 30; k++) fprintf(out, "%.17g,%g\n", p.lo[0] + (k + 0.5) * dx, large ? -1e30 : 1e11);
        fclose(out);
        int status =
            field_file_read(path, "out", &(struct column_map){0}, &(struct image){.problem = p}, &dx, &f, &why);
        assert_int_equal(status, large ? STATUS_UNSTABLE : STATUS_OK);
        if (large) assert_has(why.text, "out, line 2: T = -1e+30 K at x = -14.5 m");
        if (large) assert_has(why.text, "overflow");
        if (!large) field_free(&f);
    }
}

static void points_have_their_coordinates(void **state) {
    (void)state;
    double x = 0.3, y = -0.7, z = 1.9, at[DIM_MAX];
    struct samples s = {.dim = 3, .value = {&x, &y, &z}};
    samples_point(&s, 0, at);
    assert_true(at[0] == x && at[1] == y && at[2] == z);
    s.dim = 2;
    samples_point(&s, 0, at);
    assert_true(at[1] == y && at[2] == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_have_their_coordinates),
        cmocka_unit_test(weights_of_any_size_are_scaled),
        cmocka_unit_test(overflow_is_named),
        cmocka_unit_test(table_dialects_read_the_same),
        cmocka_unit_test(tables_may_give_weights_and_cost),
        cmocka_unit_test(invalid_tables_name_line_and_column),
        cmocka_unit_test(numpy_columns_and_fields_are_read),
        cmocka_unit_test(long_numpy_files_are_read),
        cmocka_unit_test(other_numpy_arrays_are_refused),
        cmocka_unit_test(rounded_coordinates_snap_to_walls),
        cmocka_unit_test(tables_in_space_have_three_coordinates),
    };
    int file = scratch_file(path, "field-file-test");
    if (file < 0 || close(file)) return 1;
    int failed = cmocka_run_group_tests_name("field_file", tests, NULL, NULL);
    unlink(path);
    return failed;
}
