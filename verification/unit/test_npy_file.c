/* SPDX-License-Identifier: GPL-3.0-or-later */
/* NumPy's arrays: columns, fields, and what is none. */
#include "verification/foreign/formats.h"

#include "verification/foreign/samples.h"

#include "solver/status.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct samples s;
static struct failure why;

static int read_bytes(const char *header, const void *data, size_t size, int dim, const char *map) {
    char file[600];
    size_t length = strlen(header);
    struct column_map c = {0};
    memcpy(file, "\x93NUMPY\1\0", 8);
    file[8] = (char)length, file[9] = 0;
    memcpy(file + 10, header, length);
    memcpy(file + 10 + length, data, size);
    if (map) assert_int_equal(samples_columns_read(map, &c, &why), 0);
    s = (struct samples){.path = "file", .dim = dim};
    FILE *in = fmemopen(file, 10 + length + size, "r");
    assert_true(npy_file_is(file, 10));
    int status = npy_file_read(in, &c, &s, &why);
    fclose(in);
    return status;
}

static void columns_are_read(void **state) {
    (void)state;
    const double rod[] = {0.1, 3, 0.2, 4, 0.3, 5}, plane[] = {1, 2, 3, 0.5, 4, 5, 6, 0.25};
    assert_int_equal(
        read_bytes("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }\n", rod, sizeof rod, 1, NULL), 0);
    assert_int_equal(s.n, 3);
    assert_int_equal(samples_line(&s, 2), 3); /* a row is a line */
    assert_true(s.value[COLUMN_X][2] == 0.3 && s.value[COLUMN_T][1] == 4 && !s.value[COLUMN_W]);
    samples_free(&s);
    assert_int_equal(
        read_bytes("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 4), }\n", plane, sizeof plane, 2, NULL), 0);
    assert_true(s.value[COLUMN_Y][1] == 5 && s.value[COLUMN_T][0] == 3 && s.value[COLUMN_W][1] == 0.25);
    samples_free(&s);
}

static void fields_go_by_their_names(void **state) {
    (void)state;
    char data[32];
    const double temp[] = {7, 8};
    const float x[] = {0.5f, 1.5f};
    for (int i = 0; i < 2; i++) {
        memcpy(data + 12 * i, &temp[i], 8);
        memcpy(data + 12 * i + 8, &x[i], 4);
    }
    const char *header = "{'descr': [('temp', '<f8'), ('x', '<f4')], 'fortran_order': False, 'shape': (2,), }\n";
    assert_int_equal(read_bytes(header, data, 24, 1, "T=temp"), 0);
    assert_true(s.n == 2 && s.value[COLUMN_X][1] == 1.5 && s.value[COLUMN_T][0] == 7);
    samples_free(&s);
    assert_int_equal(read_bytes(header, data, 24, 1, NULL), STATUS_INPUT);
    assert_string_equal(why.text, "file: no field 'T'");
    samples_free(&s);
}

/* Single precision, x, T and w of a rod; fields in another order than they are wanted, with one between that is not,
 * and y, which a rod has none of. */
static void singles_and_fields_between_are_read(void **state) {
    (void)state;
    const float rod[] = {0.5f, 3, 0.25f, 1.5f, 4, 0.75f};
    assert_int_equal(
        read_bytes("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }\n", rod, sizeof rod, 1, NULL), 0);
    assert_true(s.value[COLUMN_X][1] == 1.5 && s.value[COLUMN_T][0] == 3 && s.value[COLUMN_W][1] == 0.75);
    assert_true(s.n == 2 && !s.has[COLUMN_Y]);
    samples_free(&s);
    const double plane[] = {7, 8, 9, 10, 11, 12, 13, 14};
    const char *header =
        "{'descr': [('T', '<f8'), ('p', '<f8'), ('y', '<f8'), ('x', '<f8')], 'fortran_order': False, "
        "'shape': (2,), }\n";
    assert_int_equal(read_bytes(header, plane, sizeof plane, 2, NULL), 0);
    assert_true(s.value[COLUMN_X][1] == 14 && s.value[COLUMN_Y][0] == 9 && s.value[COLUMN_T][1] == 11);
    samples_free(&s);
    assert_int_equal(read_bytes(header, plane, sizeof plane, 1, NULL), 0);
    assert_true(s.value[COLUMN_X][0] == 10 && !s.value[COLUMN_Y]);
    samples_free(&s);
    assert_int_equal(read_bytes(header, plane, sizeof plane, 2, "w=q"), STATUS_INPUT);
    assert_string_equal(why.text, "file: no field 'q'");
    samples_free(&s);
    header = "{'descr': [('T', '<f8'), ('x', '<f8')], 'fortran_order': False, 'shape': (4,), }\n";
    assert_int_equal(read_bytes(header, plane, sizeof plane, 2, NULL), STATUS_INPUT);
    assert_string_equal(why.text, "file: no field 'y'");
    samples_free(&s);
}

/* Of version 2, whose header has four bytes of length, and more rows than are read at a time. */
static int read_long(unsigned header, size_t cut, size_t rows) {
    static char file[400000];
    int length = sprintf(file + 12, "{'descr': '<f8', 'fortran_order': False, 'shape': (%zu, 2), }", rows);
    memcpy(file, "\x93NUMPY\2\0", 8);
    memset(file + 12 + length, ' ', header - (unsigned)length);
    for (int i = 0; i < 4; i++) file[8 + i] = (char)(header >> 8 * i & 255);
    size_t size = 12 + header;
    for (size_t i = 0; i < 2 * rows; i++, size += 8) memcpy(file + size, &(double){0.5 * (double)i}, 8);
    s = (struct samples){.path = "file", .dim = 1};
    FILE *in = fmemopen(file, cut ? cut : size, "r");
    int status = npy_file_read(in, &(struct column_map){0}, &s, &why);
    fclose(in);
    return status;
}

static void long_headers_and_many_rows_are_read(void **state) {
    (void)state;
    enum { ROWS = 9000 };
    assert_int_equal(read_long(4095, 0, ROWS), 0);
    assert_int_equal(s.n, ROWS);
    for (int i = 0; i < ROWS; i++) assert_true(s.value[COLUMN_X][i] == i && s.value[COLUMN_T][i] == i + 0.5);
    samples_free(&s);
    assert_int_equal(read_long(4096, 0, 1), STATUS_INPUT);
    assert_has(why.text, "file: a header of more than 4 kB");
    assert_int_equal(read_long(65536 + 300, 0, 1), STATUS_INPUT); /* 300 but for its third byte */
    assert_has(why.text, "more than 4 kB");
    assert_int_equal(read_long(300, 200, 1), STATUS_INPUT);
    assert_has(why.text, "file: cut off in its header");
    assert_int_equal(read_long(300, 11, 1), STATUS_INPUT);
    assert_has(why.text, "file: cut off in its header");
    assert_false(npy_file_is("\x93NUMP", 5));
    assert_true(npy_file_is("\x93NUMPY", 6));
}

static void refused(const char *header, size_t size, int status, const char *because) {
    const double data[] = {0.1, 3, 0.2, NAN};
    assert_int_equal(read_bytes(header, data, size, 1, NULL), status);
    if (!strstr(why.text, because)) fail_msg("%s", why.text);
    samples_free(&s);
}

static void what_is_none_is_refused(void **state) {
    (void)state;
#define F8 "{'descr': '<f8', 'fortran_order': False, 'shape': "
    refused(F8 "(2, 2), }", 32, STATUS_NUMERICAL, "row 2: T is not finite");
    refused(F8 "(2, 2), }", 24, STATUS_INPUT, "cut off at row 2 of 2");
    refused(F8 "(1, 2), }", 24, STATUS_INPUT, "goes on after its last row");
    refused(F8 "(1, 5), }", 24, STATUS_INPUT, "5 columns; x, T");
    refused(F8 "(1, 1), }", 8, STATUS_INPUT, "1 columns; x, T and");
    refused(F8 "(1, 4), }", 32, STATUS_INPUT, "4 columns; x, T and");
    refused(F8 "(4,), }", 32, STATUS_INPUT, "two to four columns");
    refused(F8 "(0, 2), }", 0, STATUS_INPUT, "no points");
    refused("{'descr': '|O', 'fortran_order': False, 'shape': (2, 2), }", 32, STATUS_INPUT, "'<f8' or '<f4'");
    refused("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 2), }", 32, STATUS_INPUT, "ascontiguousarray");
    refused("{'descr': [('x', '<i8')], 'fortran_order': False, 'shape': (2,), }", 32, STATUS_INPUT, "no number");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_read),
        cmocka_unit_test(fields_go_by_their_names),
        cmocka_unit_test(singles_and_fields_between_are_read),
        cmocka_unit_test(long_headers_and_many_rows_are_read),
        cmocka_unit_test(what_is_none_is_refused),
    };
    return cmocka_run_group_tests_name("npy_file", tests, NULL, NULL);
}
