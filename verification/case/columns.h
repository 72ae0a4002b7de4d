/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_COLUMNS_H
#define HEATLADDER_VERIFICATION_CASE_COLUMNS_H

/* The columns of `reference --points`: quantities of a scene at given points, one value each, several for a wall. */

struct failure;
struct exact;
struct image;

enum { COLUMNS_MAX = 24, COLUMNS_VALUES = 10 * COLUMNS_MAX };

struct columns_row; /* the data of one point */
struct problem;

struct columns_kind {
    const char *name;   /* name for --what */
    const char *header; /* header of its columns */
    int needs_time, needs_cell;
    int axes; /* least number of axes of a scene that has it */
    void (*fill)(const struct columns_row *row, double *value);
    int axis;          /* axis of the derivative or flux, if any */
    int values;        /* number of values, one for each name of the header */
    const char *space; /* header in space, with two more values, if it differs; else NULL */
};

struct columns {
    int dim, count;
    const struct columns_kind *kind[COLUMNS_MAX];
    int needs_time, needs_cell; /* 1 if one of the columns does */
};

extern const char columns_help[];

/* Reads a comma-separated list.  Returns STATUS_OK, or STATUS_INPUT with the unknown word and the valid ones. */
int columns_parse(const char *list, int dim, struct columns *c, struct failure *why);

/* Number of values of a column for that many axes. */
int columns_count(const struct columns_kind *kind, int dim);

/* Writes ",name" for each column to text, of size COLUMNS_HEADER. */
enum { COLUMNS_HEADER = 1024 };
void columns_header(const struct columns *c, char *text);

/* Sets the values at x, m, and `time`, s, in the order of the header; returns their number.  All arguments are in
 * the axes and temperatures of the image except `exact`, the scene's solution at that point and time, NULL if no
 * column depends on time.  `cell`: extents of the cell around x, m, or NULL. */
int columns_values(const struct columns *c, const struct image *image, double time, const double *x,
                   const double *cell, const struct exact *exact, double *value);

/* K: average of the initial data over the part of the box from lo to hi (m) inside a round body; that part is not
 * empty. */
double clipped_mean(const struct problem *p, const double *lo, const double *hi);

#endif
