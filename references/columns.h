/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_COLUMNS_H
#define HEATLADDER_REFERENCES_COLUMNS_H

#include "solver/problem.h"

#include <stddef.h>

/* Quantities of a scene at points, by name: exact solution, initial data, source, coefficients, walls.  Most have one
 * value a point, a wall has three. */

struct failure;
struct image;
struct snapshot;
struct columns_row; /* the data of one point */

struct columns_kind {
    const char *name;
    const char *header; /* names of its values, separated by commas */
    int needs_time, needs_cell;
    int axes; /* least number of axes of a scene that has it */
    void (*fill)(const struct columns_row *row, double *value);
    int axis;            /* axis of the derivative or flux, if any */
    int values;          /* number of values, one for each name of the header */
    const char *space;   /* header in space, with two more values, if it differs; else NULL */
    const char *renamed; /* its name from now on; NULL if this is it */
};

enum { COLUMNS_MAX = 24, COLUMNS_VALUES = 10 * COLUMNS_MAX, COLUMNS_HEADER = 1024 };

struct columns {
    int dim, count;
    const struct columns_kind *kind[COLUMNS_MAX];
    int needs_time, needs_cell; /* 1 if one of the columns does */
    int values;                 /* how many one point has */
};

/* Reads a comma-separated list of names.  Returns STATUS_OK, or STATUS_INPUT with the unknown word and the valid
 * ones. */
int columns_parse(const char *list, int dim, struct columns *c, struct failure *why);

/* Checks that the columns have the times (s) and cells that they need. */
int columns_check(const struct columns *c, const struct problem *p, int times, const double *time, int has_cell,
                  struct failure *why);

/* Writes "name,name,..." of all values to text, of size COLUMNS_HEADER. */
void columns_header(const struct columns *c, char *text);

/* Sets value[i * c->values], ... at the n points x[i], m, and the time of the snapshot, in the order of the header.
 * Points and values are in the axes and temperatures of the image, the snapshot in the scene's.  cell[i]: extents of
 * the cell around the point, m; NULL if no column needs it. */
void columns_at_points(const struct columns *c, const struct image *image, const struct snapshot *now, size_t n,
                       double (*x)[DIM_MAX], double (*cell)[DIM_MAX], double *value);

#endif
