/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FAULT_H
#define HEATLADDER_VERIFICATION_FAULT_FAULT_H

/* Common faults of heat conduction codes, most of them expressed as changes of the problem that is solved. */

#include "solver/problem.h"

enum fault_kind {
    FAULT_CLOCK,        /* s: the end time */
    FAULT_CONDUCTIVITY, /* relative: k of every material and axis */
    FAULT_SWAP,         /* 1: the conductivities of two axes are exchanged */
    FAULT_ISOTROPIC,    /* 1: along this axis the code uses the conductivity of another */
    FAULT_TRANSPOSED,   /* 1: two axes of the answer are exchanged, which are of one extent */
    FAULT_SOURCE,       /* relative: the source; -1: missing */
    FAULT_SOURCE_TIME,  /* s: a time-dependent source is evaluated this much too late */
    FAULT_FROZEN,       /* 1: a time-dependent source keeps its initial value */
    FAULT_WALL_TIME,    /* s: the data of walls that change, or of one of them, are evaluated this much too late */
    FAULT_WALL_SWING,   /* relative: the change of walls in time, about the middle of their range */
    FAULT_WALL_FROZEN,  /* 1: walls that change keep their initial values */
    FAULT_CAPACITY,     /* 1: the second material has rho c of the first */
    FAULT_DIFFUSIVITY,  /* 1: the flux between two materials is computed with their diffusivities, on each side with
                           its own rho c */
    FAULT_AXIS,         /* relative: k of every material along one axis alone */
    FAULT_RHO_C,        /* relative: rho c of one of two materials */
    FAULT_COEFFICIENT,  /* relative: b of one cooled side or of all */
    FAULT_NEAR_WALL,    /* m: cooled sides exchange heat with the temperature at this distance inside (half a cell) */
    FAULT_WALL,         /* relative: the temperature or flux prescribed on a side; -1: zero */
    FAULT_CORNER, /* m: in the cell of a corner or along an edge, of this size, Dirichlet sides are taken as zero */
    FAULT_EXTENT, /* m: both sides across an axis are displaced outwards by this */
    FAULT_START_SHIFT, /* m: the initial data are displaced by this along an axis */
    FAULT_START_WIDTH, /* m: either jump of the initial data is displaced outwards by this along an axis */
    FAULT_SAMPLES,     /* 1: either jump is midway between the adjacent points along an axis, as if sampled there */
    FAULT_INTERFACE,   /* m: the interface of two materials */
    FAULT_LAW,  /* 1: k(T) is taken at another temperature, or with the mean that locks a front (enum fault_law) */
    FAULT_MEAN, /* m: the arithmetic mean of two conductivities is used over a length (a cell) across their contact */
    FAULT_AMPLITUDE, /* relative: all temperatures */
    FAULT_OFFSET,    /* K: all temperatures */
    /* These are not changes of a problem, and fault_make does not make them. */
    FAULT_SOME_STEPS, /* steps: the end time is wrong at some spacings */
    FAULT_NOISE,      /* K: answers differ from run to run */
    FAULT_DIGITS,     /* temperatures are rounded to this number of digits */
    FAULT_UNSTABLE    /* K: temperatures that an unstable run reaches */
};

struct fault {
    enum fault_kind kind;
    int axis; /* in the case.  FAULT_SWAP, FAULT_TRANSPOSED: fault_pair; FAULT_ISOTROPIC: fault_other; FAULT_EXTENT:
                 also both of a plane or all of a box; FAULT_WALL and FAULT_COEFFICIENT: the side, or all sides of
                 given flux and all cooled sides; FAULT_WALL_TIME: 0 for all, 1 + the side; FAULT_RHO_C: the
                 material; FAULT_CORNER: 2 y + x of a plane, with 1 for the upper end; 4 + 4 z + 2 y + x of a box;
                 12 + 4 c + bits of its edge along axis c; FAULT_ANY: rows that differ in it */
};

/* The axis of FAULT_LAW: k of the initial temperature, of k_ref, of a side, or harmonic means. */
enum fault_law { LAW_START, LAW_REF, LAW_SIDE, LAW_HARMONIC = LAW_SIDE + 4, LAWS };
enum { FAULT_BOTH_AXES = DIM_MAX, FAULT_ALL_AXES, FAULT_ALL_SIDES = SIDES, FAULT_ANY = -1 };
enum { FAULT_PAIRS = 3, FAULT_OTHERS = 6, FAULT_CORNERS = 24 };

/* The two axes of a pair, 0 of a plane, 0 to 2 of a box: x and y, y and z, x and z. */
int fault_pair(int pair, int second);
/* FAULT_ISOTROPIC: the axis that has the conductivity of another, and that one; 0 or 1 in a plane, 0 to 5 in a box.
 */
int fault_other(int axis, int other);

/* 1 if *p can have the fault. */
int fault_applies(const struct problem *p, struct fault fault);
/* The side across axis a that a corner or an edge is on; -1: the edge is along a. */
int fault_side_of_corner(int corner, int a);
/* k in the middle of a side. */
double fault_law_at_side(const struct problem *p, int s);

/* A problem with a fault of one size.  `problem` points into this struct and must not be copied separately. */
struct faulty {
    struct problem problem;
    const struct problem *right;
    struct fault fault;
    double size;
    double stretch[DIM_MAX],
        centre[DIM_MAX]; /* x of the problem is centre + (x - centre)/stretch of the correct one */
};

/* Sets *f to *p with that fault and size.  Returns 1 if *p can have the fault. */
int fault_make(const struct problem *p, struct fault fault, double size, struct faulty *f);

/* 1 if the response is not proportional to the size: the fault is either present (size 1) or absent. */
int fault_is_whole(enum fault_kind kind);

/* 1 if the response is proportional only to a small size: a coefficient, which may change by a large factor. */
int fault_bends(enum fault_kind kind);

/* 1 if a fault of that kind can have that size: conductivities are positive, a run cannot stop before its start, and
 * a flux or source of the wrong sign has a size of its own. */
int fault_can_be(const struct problem *p, enum fault_kind kind, double size);

/* 1 if nothing but conduction changes T between steady walls: a larger conductivity has then the effect of longer
 * steps. */
int fault_is_pace(const struct problem *p);

/* The size at which the response is evaluated: small if the response is proportional, a fraction of the extent for
 * lengths. */
double fault_probe(const struct problem *p, struct fault fault);

#endif
