/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_OUTLINE_H
#define HEATLADDER_SOLVER_OUTLINE_H

/* What a run would store and do, as its method predicts it without running. */

#include "solver/field.h"

enum outline_phase { OUTLINE_SET_UP, OUTLINE_STEPS, OUTLINE_ERRORS, OUTLINE_PHASES };

struct outline_array {
    const char *what;
    size_t bytes;
    enum outline_phase from, to; /* held from the one to the other */
};

enum { OUTLINE_ARRAYS = 12 };

struct outline {
    struct field run;    /* as solve would fill it, but for its arrays, the data and the clock */
    int answer;          /* numbers that solve gives back of each point: place, temperature, weight */
    const char *weights; /* one line: how neighbours' weights are stored, and why */
    int rows;            /* 1: a row for each point; 0: one stencil for all */
    int on_lattice;      /* 1: the field has a shape */
    double neighbours;   /* mean number of a point */
    double stand_in;     /* m: spacing of the coarser rows that were counted; 0: these rows themselves */
    int count;
    struct outline_array array[OUTLINE_ARRAYS]; /* but for O(1), and O(n) of an n x n lattice */
    size_t bytes[OUTLINE_PHASES];               /* their sum in each phase */
};

/* Adds an array; none of 0 bytes.  Past OUTLINE_ARRAYS of them the bytes count, the name is left out. */
void outline_hold(struct outline *o, const char *what, size_t bytes, enum outline_phase from, enum outline_phase to);

/* The unit of field.work is one multiplication and addition in a stream of vectors.  What is done number by number
 * takes OUTLINE_SCALAR of them for each operation: a vector of 512 bits holds 8 doubles. */
enum {
    OUTLINE_SCALAR = 8,
    OUTLINE_FUNCTION = 20,                  /* operations of an exp or a sqrt: a polynomial of degree 13 or so */
    OUTLINE_PLACE = 20,                     /* of a point's place, heat and range: five passes of some four */
    OUTLINE_SAMPLE = 16 + OUTLINE_FUNCTION, /* of a sample of the data: four comparisons on each of four sides */
    OUTLINE_GHOST = 2                       /* of a ghost in each application: a load and a store */
};

#endif
