/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_FAULTY_H
#define HEATLADDER_VERIFICATION_FAULT_FAULTY_H

/* A problem as a faulty code solves it. */

#include "solver/options.h"
#include "solver/problem.h"

enum fault_kind {
#define FAULT(NAME, ...) FAULT_##NAME,
#include "verification/fault/fault.def"
#undef FAULT
    FAULT_KINDS
};

struct fault {
    enum fault_kind kind;
    int at; /* the place: an axis, a side, a pair of axes; 0 if the kind has one place */
};

/* A cell at the melting point: held there, not held, or passing no heat. */
enum front { FRONT_HELD, FRONT_LOOSE, FRONT_LOCKED };

/* Changes by a fault, besides the coefficients of `problem`.  The problem points into this struct and
 * must not be copied separately. */
struct faulty {
    struct problem problem;
    const struct problem *right;
    struct fault fault;
    double size;
    double stretch[DIM_MAX], centre[DIM_MAX]; /* x of the problem is centre + (x - centre)/stretch of the right one */
    int from[DIM_MAX];                        /* by axis: the axis of the right problem that is in its place */
    double moved[DIM_MAX];                    /* m: points of the answer are this much too far up */
    int mirrored[DIM_MAX];                    /* 1: points of the answer are in reverse order */
    double start[DIM_MAX];                    /* m: the initial data are displaced */
    double initial;                           /* their factor */
    double width[DIM_MAX];                    /* m: their jumps are displaced outwards */
    double factor, offset;                    /* all temperatures; K */
    double wall[SIDES], late[SIDES];          /* factor of a side's data; s: they are those of a later time */
    double along[DIM_MAX];                    /* m: they are those of a point further up this axis */
    int frozen, source_frozen;                /* 1: data that change keep their first values */
    double source, source_late;               /* factor; s */
    int corner;                               /* the corners that lose what sides hold, see faulty_corner; -1: none */
    int left_out;       /* the faces beside corners of a plane that conduct no heat, see FAULT_BESIDE; -1: none */
    int across;         /* the axis across which the materials meet, at the same part of its extent */
    int kept;           /* the layer beside this side keeps its first values; -1: none */
    int by_steps;       /* 1: a change of the equation, which response.c solves by itself */
    int opposite;       /* 1: b of a field has the opposite component along y */
    int swapped;        /* 1: b of a field is that of the place with x and y exchanged */
    double turn;        /* rad: b of a field is turned by it, anticlockwise */
    int laplacian;      /* 1: k lap T stands for div(k grad T) */
    int twice[DIM_MAX]; /* 1: the faces at which periodic sides meet count twice */
    enum mean mean;     /* the mean of two conductivities */
    enum front front;   /* a melting cell */
    double range[2];    /* K: latent heat is taken from that far below the melting point to that far above */
};

/* Sets *f to *p with that fault and size.  Returns 1 if *p can have the fault. */
int faulty_make(const struct problem *p, struct fault fault, double size, struct faulty *f);

/* The side across axis a that a corner or an edge is on; -1: the edge is along a.  Corners: 2 y + x of a plane, with
 * 1 for the upper end; 4 + 4 z + 2 y + x of a box; 12 + 4 c + bits of its edge along axis c. */
int faulty_side(int corner, int a);

/* Corner or edge i of a place: itself (below 24), the four edges along an axis, all corners of a plane, all edges of
 * a box; -1: there are no more. */
int faulty_corner(int place, int i);

/* The side in the place of s, where axes are exchanged. */
enum side faulty_from(const struct faulty *f, int s);

#endif
