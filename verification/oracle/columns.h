/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_ORACLE_COLUMNS_H
#define HEATLADDER_VERIFICATION_ORACLE_COLUMNS_H

/* The columns of `reference --points`: quantities of a scene at given points, one value each, more for a wall. */

struct failure;
struct exact;
struct image;

enum { COLUMNS_MAX = 24, COLUMNS_VALUES = 8 * COLUMNS_MAX };

struct columns_row; /* the data of one point */
struct problem;

struct columns_kind {
    const char *name;   /* as in --what */
    const char *header; /* of the columns that it fills */
    int needs_time, needs_cell;
    int plane; /* 1: a rod has none */
    void (*fill)(const struct columns_row *row, double *value);
    int axis;   /* of the derivative or flux, where that matters */
    int values; /* how many it fills */
};

struct columns {
    int count;
    const struct columns_kind *kind[COLUMNS_MAX];
    int needs_time, needs_cell; /* whether one of them does */
};

extern const char columns_help[];

/* Reads a list with commas between.  STATUS_OK, or STATUS_INPUT naming the word and what would be valid. */
int columns_parse(const char *list, int dim, struct columns *c, struct failure *why);

/* ",name" for each column; into text of size COLUMNS_HEADER. */
enum { COLUMNS_HEADER = 1024 };
void columns_header(const struct columns *c, char *text);

/* The values at x, m, and `time`, s, in the order of the header; how many.  All is in the axes and temperatures of
 * the image but `exact`: of the scene there and then, or NULL where no column needs the time.  `cell`: extents of the
 * cell around x, m, or NULL. */
int columns_values(const struct columns *c, const struct image *image, double time, const double x[2],
                   const double cell[2], const struct exact *exact, double *value);

/* K: the mean of the start over the part of the box from lo to hi (m) inside a round body; that part is not empty. */
double clipped_mean(const struct problem *p, const double lo[2], const double hi[2]);

#endif
