/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_DIAGNOSIS_FAULT_H
#define HEATLADDER_VERIFICATION_DIAGNOSIS_FAULT_H

/* Faults that codes of heat conduction have, most of them as changes of the problem that is solved. */

#include "solver/problem.h"

enum fault_kind {
    FAULT_CLOCK,        /* s: the end time */
    FAULT_CONDUCTIVITY, /* relative: k of every material and axis */
    FAULT_SWAP,         /* 1: k_x and k_y in each other's place */
    FAULT_ISOTROPIC,    /* 1: along this axis the conductivity of the other */
    FAULT_TRANSPOSED,   /* 1: x and y of the answer in each other's place, on a square */
    FAULT_SOURCE,       /* relative: the source; -1: lost */
    FAULT_SOURCE_TIME,  /* s: the source, which changes, is that of so much later */
    FAULT_FROZEN,       /* 1: the source, which changes, stays as it is at the start */
    FAULT_CAPACITY,     /* 1: rho c of the second material is the first one's */
    FAULT_DIFFUSIVITY,  /* 1: the flux between two materials is that of their diffusivities, each side with its rho c
                         */
    FAULT_AXIS,         /* relative: k of every material along one axis alone */
    FAULT_RHO_C,        /* relative: rho c of one of two materials */
    FAULT_COEFFICIENT,  /* relative: b of a cooled side, or of all */
    FAULT_NEAR_WALL,    /* m: cooled sides exchange heat with the temperature so far inside (half a cell) */
    FAULT_WALL,         /* relative: what a side holds, temperature or flux; -1: zero */
    FAULT_CORNER,       /* m: for a corner's cell of that size, sides of given temperature there are at zero */
    FAULT_EXTENT,       /* m: both sides across an axis are displaced outwards by this */
    FAULT_START_SHIFT,  /* m: the initial data are displaced by this along an axis */
    FAULT_START_WIDTH,  /* m: either jump of the initial data is so far out along an axis */
    FAULT_SAMPLES,   /* 1: either jump is midway between the points next to it along an axis, as from values there */
    FAULT_INTERFACE, /* m: the interface of two materials */
    FAULT_MEAN,      /* m: the arithmetic mean of two conductivities over a length (a cell) across their contact */
    FAULT_AMPLITUDE, /* relative: all temperatures */
    FAULT_OFFSET,    /* K: all temperatures */
    /* These are no changes of a problem, and fault_make makes none. */
    FAULT_SOME_STEPS, /* steps: at some spacings the end time */
    FAULT_NOISE,      /* K: answers differ from run to run */
    FAULT_DIGITS,     /* temperatures are rounded to so many digits */
    FAULT_UNSTABLE    /* K: temperatures that an unstable run reaches */
};

struct fault {
    enum fault_kind kind;
    int axis; /* 0 or 1; of FAULT_EXTENT also both; of FAULT_WALL and FAULT_COEFFICIENT the side, or all of
               * given flux and all that are cooled; of FAULT_RHO_C the material; of FAULT_CORNER 2 y + x, 1 for the
               * upper end; FAULT_ANY of rows that differ in it */
};

enum { FAULT_BOTH_AXES = 2, FAULT_ALL_SIDES = 4, FAULT_ANY = -1 };

/* A problem with a fault of one size.  `problem` points to the rest: it is not to be copied apart from it. */
struct faulty {
    struct problem problem;
    const struct problem *right;
    struct fault fault;
    double size;
    double stretch[2], centre[2]; /* the problem's x is centre + (x - centre)/stretch of the right one's */
};

/* 1 where that fault can be made in *p; then *f has it, of that size. */
int fault_make(const struct problem *p, struct fault fault, double size, struct faulty *f);

/* 1 where the response is not proportional to the size: it is there in full (size 1) or not at all. */
int fault_is_whole(enum fault_kind kind);

/* 1 where the response is proportional to no size but a small one: a coefficient, whose size may be large. */
int fault_bends(enum fault_kind kind);

/* 1 where a fault of that kind can have that size: nothing conducts less than nothing, no run stops before its start,
 * a flux or a source of the wrong sign has its own size. */
int fault_can_be(const struct problem *p, enum fault_kind kind, double size);

/* The size at which the response is taken, small where it is proportional; of lengths a part of the extent. */
double fault_probe(const struct problem *p, struct fault fault);

#endif
