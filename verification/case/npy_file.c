/* SPDX-License-Identifier: GPL-3.0-or-later */
/* NumPy's array files: magic, version, length of the header, a header in Python's syntax, then the rows in binary
 * (NEP 1, versions 1.0 to 3.0). */
#include "verification/case/npy_file.h"

#include "solver/status.h"
#include "verification/case/samples.h"
#include "verification/text/number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAGIC = 6, HEADER = 4096 };
static const size_t MOST = 1000000000; /* numbers: their sizes do not overflow */

struct layout {
    size_t rows, stride, size;   /* bytes from row to row, and of all rows */
    size_t offset[COLUMN_COUNT]; /* in the data, to its first row */
    int bytes[COLUMN_COUNT];     /* 8 or 4; 0 for an absent column */
};

int npy_file_is(const char *start, size_t size) {
    return size >= MAGIC && memcmp(start, "\x93NUMPY", MAGIC) == 0;
}

static int wrong(const struct samples *s, struct failure *why, const char *what) {
    return refuse(why, STATUS_INPUT, "%.150s: %s", s->path, what);
}

static int read_header(FILE *in, char text[HEADER], const struct samples *s, struct failure *why) {
    unsigned char start[MAGIC + 6] = {0}; /* versions above 1 store the length in four bytes */
    if (fread(start, 1, MAGIC + 4, in) != MAGIC + 4 || (start[6] > 1 && fread(start + MAGIC + 4, 1, 2, in) != 2))
        return wrong(s, why, "cut off in its header");
    size_t length = start[8] + 256u * start[9] + 65536u * start[10] + 16777216u * start[11];
    if (length >= HEADER) return wrong(s, why, "a header of more than 4 kB: not an array of points");
    if (fread(text, 1, length, in) != length) return wrong(s, why, "cut off in its header");
    text[length] = '\0';
    return STATUS_OK;
}

/* Size in bytes of a quoted '<f8' or '<f4'; 0 for any other type. */
static int bytes_of(const char *type) {
    return strncmp(type, "'<f8'", 5) == 0 ? 8 : strncmp(type, "'<f4'", 5) == 0 ? 4 : 0;
}

/* Reads the sequence of ('NAME', '<f8') up to the closing bracket. */
static int read_fields(const char *at, const struct column_map *c, const struct samples *s, struct layout *l,
                       struct failure *why) {
    char name[COLUMN_NAME], type[8];
    for (at += strspn(at, " "); *at != ']'; at += strspn(at, ", ")) {
        int n = 0, two = sscanf(at, "( '%63[^']' , %7[^,)] )%n", name, type, &n) == 2,
            bytes = two ? bytes_of(type) : 0;
        if (n == 0 || bytes == 0) return wrong(s, why, "a field is not one number of 8 or 4 bytes ('<f8', '<f4')");
        for (int k = 0; k < COLUMN_COUNT; k++)
            if (strcmp(samples_column_name(c, k), name) == 0) l->offset[k] = l->stride, l->bytes[k] = bytes;
        l->stride += (size_t)bytes;
        at += n;
    }
    return STATUS_OK;
}

/* The columns are the coordinates, T and w in this order, or as --columns places them.  One more than the coordinates
 * of a rod or plane and T is ambiguous: w, or another coordinate. */
static int check_columns(size_t columns, const struct samples *s, struct failure *why) {
    static const char *const coordinates[] = {"", "x", "x, y", "x, y, z"};
    size_t least = (size_t)s->dim + 1;
    if (columns == 3 && s->dim == 1)
        return wrong(s, why, "3 columns for a rod: x, T, w or x, y, T? --columns x=1,T=2,w=3 names their places");
    if (columns == 4 && s->dim == 2)
        return wrong(
            s, why, "4 columns in the plane: x, y, T, w or x, y, z, T? --columns x=1,y=2,T=3,w=4 names their places");
    if (columns == least || columns == least + 1) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.150s: %zu columns; it needs %s, T and, for weighted points, w", s->path,
                  columns, coordinates[s->dim]);
}

/* In Fortran's order a column follows the other, else a row. */
static int read_columns(size_t columns, int bytes, int fortran, const struct column_map *c, const struct samples *s,
                        struct layout *l, struct failure *why) {
    size_t next = 0, size = (size_t)bytes;
    if (!c->text && check_columns(columns, s, why)) return why->status;
    for (int k = 0; k < COLUMN_COUNT; k++) {
        long place = 0;
        int needed = samples_needs(c, s->dim, k);
        if (c->text) {
            if (number_read_whole(c->name[k], (long)columns, &place)) place = 0;
        } else if (needed || k == COLUMN_W) {
            place = (long)++next <= (long)columns ? (long)next : 0;
        }
        if (needed && place < 1)
            return refuse(
                why, STATUS_INPUT,
                "%.120s: no column '%s': --columns gives the places of an array of %zu columns, %s=1 to %zu", s->path,
                samples_column_name(c, k), columns, samples_column_name(&(struct column_map){0}, k), columns);
        if (place < 1) continue;
        l->offset[k] = (size_t)(place - 1) * size * (fortran ? l->rows : 1), l->bytes[k] = bytes;
    }
    l->stride = fortran ? size : columns * size;
    l->size = l->rows * columns * size;
    return STATUS_OK;
}

static int read_layout(const char *header, const struct column_map *c, const struct samples *s, struct layout *l,
                       struct failure *why) {
    const char *descr = strstr(header, "'descr':"), *shape = strstr(header, "'shape':");
    int fortran = strstr(header, "'fortran_order': True") != NULL, status = STATUS_OK;
    size_t columns = 0;
    if (!descr || !shape) return wrong(s, why, "a header without descr and shape: not an array of NumPy");
    int sizes = sscanf(shape + 8, " ( %zu , %zu", &l->rows, &columns);
    descr += 8 + strspn(descr + 8, " ");
    if (*descr == '[' && sizes == 1 && l->rows < MOST)
        status = read_fields(descr + 1, c, s, l, why), l->size = l->rows * l->stride;
    else if (bytes_of(descr) && sizes == 2 && l->rows < MOST && columns < MOST / (l->rows + 1))
        status = read_columns(columns, bytes_of(descr), fortran, c, s, l, why);
    else
        status = wrong(s, why, "not n rows of two or more columns '<f8' or '<f4', nor of named fields");
    for (int k = 0; !status && k < COLUMN_COUNT; k++)
        if (samples_needs(c, s->dim, k) && !l->bytes[k])
            status = refuse(why, STATUS_INPUT, "%.150s: no field '%s'", s->path, samples_column_name(c, k));
    if (s->dim == 1) l->bytes[COLUMN_Y] = l->bytes[COLUMN_Z] = 0;
    return status;
}

static double value_at(const char *at, int bytes) {
    double value;
    float single;
    if (bytes == 8) return memcpy(&value, at, sizeof value), value;
    return memcpy(&single, at, sizeof single), single;
}

/* Checks that the rest of the file holds the rows that its header announces. */
static int check_size(FILE *in, const struct layout *l, const struct samples *s, struct failure *why) {
    long here = ftell(in);
    if (here < 0 || fseek(in, 0, SEEK_END)) return wrong(s, why, "its size cannot be found");
    size_t left = (size_t)(ftell(in) - here);
    if (fseek(in, here, SEEK_SET)) return wrong(s, why, "cannot be read from its first row on");
    if (l->rows == 0) return wrong(s, why, "no points");
    if (left > l->size) return wrong(s, why, "goes on after its last row");
    if (left == l->size) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "%.150s: cut off after %zu of %zu bytes", s->path, left, l->size);
}

static int read_rows(const char *data, const struct layout *l, struct samples *s, struct failure *why) {
    for (int k = 0; k < COLUMN_COUNT; k++)
        if (l->bytes[k]) s->value[k] = xcalloc(l->rows, sizeof *s->value[k]);
    for (s->n = 0; s->n < l->rows; s->n++)
        for (int k = 0; k < COLUMN_COUNT; k++) {
            if (!l->bytes[k]) continue;
            double value = s->value[k][s->n] = value_at(data + l->offset[k] + s->n * l->stride, l->bytes[k]);
            if (!isfinite(value))
                return refuse(why, STATUS_NUMERICAL, "%.150s, row %zu: %s is not finite", s->path, s->n + 1,
                              samples_column_name(&(struct column_map){0}, k));
        }
    return STATUS_OK;
}

int npy_file_read(FILE *in, const struct column_map *c, struct samples *s, struct failure *why) {
    char header[HEADER];
    struct layout l = {0};
    if (read_header(in, header, s, why) || read_layout(header, c, s, &l, why)) return why->status;
    if (check_size(in, &l, s, why)) return why->status;
    char *data = xcalloc(l.size, 1);
    int status = fread(data, 1, l.size, in) == l.size ? read_rows(data, &l, s, why)
                                                      : wrong(s, why, "could not be read to its end");
    free(data);
    return status;
}
