/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_SAMPLES_H
#define HEATLADDER_VERIFICATION_CASE_SAMPLES_H

/* Points, temperatures and weights as read from a file, and the names of their columns. */

#include <stddef.h>

struct failure;

enum { COLUMN_X, COLUMN_Y, COLUMN_Z, COLUMN_T, COLUMN_W, COLUMN_COUNT, COLUMN_NAME = 64 };

/* Names of x, y, z, T and w in the file; "" for the name itself. */
struct column_map {
    char name[COLUMN_COUNT][COLUMN_NAME];
    const char *text; /* as typed; NULL if not given */
};

/* Parses 'x=X,y=Y,z=Z,T=temp,w=volume', each at most once; a number is the position of a column, from 1. */
int samples_columns_read(const char *map, struct column_map *c, struct failure *why);
const char *samples_column_name(const struct column_map *c, int column);

/* 1 for a column that points with that many coordinates must have: T, their coordinates, and w where it was named. */
int samples_needs(const struct column_map *c, int dim, int column);

struct samples {      /* arrays are owned; release with samples_free */
    const char *path; /* name of the file in messages */
    int dim;
    size_t n;
    double *value[COLUMN_COUNT];    /* n values per column; NULL if the column is missing */
    long *line;                     /* line in the file, from 1; NULL if it equals the number of the point */
    double seconds, steps, updates; /* cost reported by the program; NaN if not reported */
};

/* Reads the points of a file, with that many coordinates; messages call it `name`.  Returns STATUS_OK, or *why states
 * the error with its line and column: STATUS_NUMERICAL where a number is not finite, else STATUS_INPUT.
 *
 * A table is a header of names, then one point per line (rows.h).  Comments may report costs (`# seconds = S`; also
 * steps and updates); a comment of names above the first point is a header too.  Unused columns are skipped.  NumPy's
 * .npy is read as well (npy_file.h). */
int samples_read(const char *path, const char *name, int dim, const struct column_map *c, struct samples *s,
                 struct failure *why);
void samples_free(struct samples *s);

/* The coordinates of point i, 0 past dim; returns x. */
const double *samples_point(const struct samples *s, size_t i, double x[3]);
long samples_line(const struct samples *s, size_t i); /* line of point i in the file, from 1 */

/* Divides the weights by a power of 2 near the largest, which is exact, so that sums with them do not overflow.
 * Refuses negative weights, weights that are all 0, and a range beyond double's. */
int samples_scale_weights(struct samples *s, struct failure *why);

/* "x = 0.1, y = 0.2", for messages; returns it. */
enum { SAMPLES_PLACE = 80 };
const char *samples_place(const struct samples *s, size_t i, char text[SAMPLES_PLACE]);

#endif
