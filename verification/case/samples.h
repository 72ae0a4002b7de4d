/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_SAMPLES_H
#define HEATLADDER_VERIFICATION_CASE_SAMPLES_H

/* Points, temperatures and weights as read from a file, and the names of their columns. */

#include <stddef.h>
#include <stdio.h>

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

/* 1 for a column that points with that many coordinates have: T and their coordinates. */
int samples_needs(int dim, int column);

/* Their names, separated by commas. */
enum { SAMPLES_HEADER = 4 * COLUMN_NAME + 8 };
void samples_header(const struct column_map *c, int dim, char text[SAMPLES_HEADER]);

struct samples {      /* arrays are owned; release with samples_free */
    const char *path; /* name of the file in messages */
    int dim;
    int has[COLUMN_COUNT]; /* 1 for an existing column; set it before the first samples_grow or samples_reserve */
    size_t n, room;
    double *value[COLUMN_COUNT];    /* n values per column; NULL if the column is missing */
    long *line;                     /* line in the file, from 1; NULL if it equals the number of the point */
    double seconds, steps, updates; /* cost reported by the program; NaN if not reported */
};

void samples_free(struct samples *s);
void samples_grow(struct samples *s);                 /* doubles the capacity */
void samples_reserve(struct samples *s, size_t room); /* for an empty *s with one point per line */
/* The coordinates of point i, 0 past dim; returns x. */
const double *samples_point(const struct samples *s, size_t i, double x[3]);
long samples_line(const struct samples *s, size_t i); /* line of point i in the file, from 1 */

/* Stores the value of one cell, or refuses it with path, line and column. */
int samples_put(struct samples *s, int column, const char *text, size_t length, long line, int place,
                struct failure *why);

/* 1 if the text of that length equals the word. */
int samples_is(const char *text, size_t length, const char *word);

/* A text for a message: printable, at most 40 characters, with a mark if truncated. */
const char *samples_quote(const char *text, size_t length, char quoted[48]);

/* Opens a regular file, not a link; NULL with *why if it is not one. */
FILE *samples_open(const char *path, const char *name, struct failure *why);

#endif
