/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_SHAPE_H
#define HEATLADDER_SOLVER_SHAPE_H

#include "solver/problem.h"

/* The shape of a body: interior, distance, nearest wall point, outward normal. */

struct foot {               /* relation of a point to a wall */
    double x[DIM_MAX];      /* m, nearest point of the wall; 0 past dim */
    double normal[DIM_MAX]; /* outward unit normal */
    double depth;           /* m, distance of the point from the wall; negative outside */
};

struct shape {
    const char *name; /* name in the case file */
    struct foot (*foot)(const struct problem *p, enum side s, const double *x);
    /* m^dim, measure of the box from lo to hi inside the body */
    double (*area)(const struct problem *p, const double *lo, const double *hi);
};

extern const struct shape shape_disc, shape_annulus, shape_ball; /* about 0, with p->radius */

/* Makes *p a disc or annulus between these radii (m; 0: no hole), or a ball; lo and hi become its bounding box. */
void shape_round(struct problem *p, double hole, double radius);
void shape_make_ball(struct problem *p, double radius);

/* 1 if side s is a wall: a disc or a ball has one, periodic sides are no walls. */
int shape_has_wall(const struct problem *p, int s);

/* The foot of x (m) on wall s, or on the nearest wall, *s.  Without a wall depth is INFINITY and *s is -1. */
struct foot shape_foot(const struct problem *p, int s, const double *x);
struct foot shape_nearest(const struct problem *p, const double *x, int *s);

/* m: distance from the nearest wall, negative outside the body. */
double shape_depth(const struct problem *p, const double *x);

/* m^dim: volume of the box from lo to hi (m) inside the body, and of the body. */
double shape_clipped(const struct problem *p, const double *lo, const double *hi);
double shape_volume(const struct problem *p);

/* Intersection of the line x = const with the body between lo and hi (m): at most two pieces, from piece[k][0] to
 * piece[k][1].  Returns their number. */
int shape_pieces(const struct problem *p, double x, double lo, double hi, double piece[2][2]);

#endif
