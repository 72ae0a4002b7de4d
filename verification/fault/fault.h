/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FAULT_H
#define HEATLADDER_VERIFICATION_FAULT_FAULT_H

/* Faults of heat conduction codes: the rows of fault.def. */

#include "verification/fault/faulty.h"

enum fault_unit {
    UNIT_PART,   /* a fraction, in % */
    UNIT_TIME,   /* s, also in steps or dx^2/kappa */
    UNIT_LENGTH, /* m, in cells */
    UNIT_KELVIN, /* K */
    UNIT_DIGITS,
    UNIT_WHOLE /* present (size 1) or absent */
};

/* Properties of a row. */
enum {
    FAULT_BENDS = 1, /* the response is proportional only to small sizes: it is taken again at the size found */
    FAULT_JOINS = 2, /* at different places of different rows it is one fault */
    FAULT_RARE = 4,  /* a size that differs from row to row; another fault often has one size for all */
    FAULT_SIGN = 8,  /* a size near -2 is a wrong sign; others below `least` are impossible */
    FAULT_CELL = 16, /* the size is a length, known to be `cells` cells; the response is taken there */
    FAULT_HALF = 64, /* the size is a whole number of half cells */
    FAULT_RUNG = 32  /* the response is taken on the cells of each rung */
};

/* Faults with one effect where T depends on k t/rho c alone.  Sources, given fluxes and Robin walls tell k from the
 * others, and data that change in time tell the end time from rho c. */
enum { PACE_CONDUCTIVITY = 1, PACE_CAPACITY = 2, PACE_END = 4 };

/* Places of a fault in a problem, such as its axes: `count` numbers from 0, each with a name. */
struct fault_places {
    int count;
    const char *const *name;
    const char *any; /* the name where rows differ */
};

struct fault_row {
    const char *name;
    const struct fault_places *places;               /* NULL: one place */
    int (*applies)(const struct problem *p, int at); /* NULL: every problem can have it */
    void (*change)(struct faulty *f); /* changes the problem; NULL: the diagnosis has a test of its own */
    enum fault_unit unit;
    unsigned is;
    double probe; /* size at which the response is taken, in fault_scale; 0: 1/100, of lengths 1/200 */
    double far;   /* size at which it is taken too if a small one explains too little; 0: none */
    double least; /* least possible size, in fault_scale; 0: any */
    double cells; /* size of FAULT_CELL */
    const char *text, *below, *above; /* the sentence, see wording.h */
    struct {
        const char *unit; /* NULL: any */
        double from, to;  /* sizes for which another sentence is better */
        const char *text;
    } other[4];
};

extern const struct fault_row fault_rows[FAULT_KINDS];

/* Places. */
enum { FAULT_BOTH_AXES = DIM_MAX, FAULT_ALL_AXES, FAULT_ALL_SIDES = SIDES, FAULT_ANY = -1 };
/* FAULT_LAW: k of the initial temperature, of k_ref, of a side; harmonic means. */
enum { LAW_START, LAW_REF, LAW_SIDE, LAW_HARMONIC = LAW_SIDE + 4, LAWS };

/* FAULT_PHASES, of k and then of rho c: each other's, those of the solid, those of the liquid; each other's of both.
 */
enum { PHASES_SWAPPED, PHASES_SOLID, PHASES_LIQUID, PHASES_RHO_C, PHASES_BOTH = 2 * PHASES_RHO_C };
/* FAULT_FRONT: without latent heat; in its first cell; see enum front. */
enum { AT_FRONT_LOST, AT_FRONT_KEPT, AT_FRONT_LOCKED, AT_FRONT_LOOSE };

/* FAULT_WHOLE_STEPS */
enum { STEPS_LATE, STEPS_EARLY };

/* FAULT_CUT */
enum { CUT_BELOW, CUT_ABOVE };

/* FAULT_BESIDE: of one corner of a plane, 2 y + x with 1 for the upper end; of all corners, on the sides across x or
 * y.
 */
enum { BESIDE_ALL = 4 };

/* FAULT_FIELD */
enum { FIELD_TURNED, FIELD_LOST, FIELD_ALL, FIELD_SWAPPED, FIELDS };

/* Number of places of a kind. */
int fault_places(enum fault_kind kind);

/* 1 if *p can have the fault. */
int fault_applies(const struct problem *p, struct fault fault);

/* 1 if a fault can have that size: conductivities are positive, a run cannot stop before its start. */
int fault_can_be(const struct problem *p, struct fault fault, double size);

/* The unit of probe and least: t_end, the extent along the fault's axis, or 1. */
double fault_scale(const struct problem *p, struct fault fault);
/* The size of 100 %: t_end, s, the difference of two walls, K, or 1. */
double fault_whole(const struct problem *p, struct fault fault);
/* The size at which the response is evaluated. */
double fault_probe(const struct problem *p, struct fault fault);

/* 1 if nothing but conduction changes T between steady walls: T depends on k t/rho c alone. */
int fault_is_pace(const struct problem *p);

/* 1 << enum side_kind of each side of *p to which the fault applies; 0 if it applies to none. */
unsigned fault_sides(const struct problem *p, struct fault fault);

#endif
