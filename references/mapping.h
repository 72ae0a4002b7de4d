/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_MAPPING_H
#define HEATLADDER_REFERENCES_MAPPING_H

#include "solver/problem.h"

/* A scene in other axes and another scale of temperature: its image, the case.
 *
 * The equation has no preferred axis and is linear, so that what solves a scene solves its image too:
 *
 *     an axis of the case is one of the scene's, along it or against it;  T_case = scale T + offset,  scale > 0
 *
 * Then k goes with its axis, rho_c and Robin's b stay, fluxes and sources are multiplied by scale, temperatures of
 * walls and air are mapped as T is.  Solvers, references and norms see the scene; the case file, the points of the
 * oracle and the answers of programs are in the axes and the temperature of the case.
 *
 * A program in three dimensions solves a plane as a slab, along the third axis of which nothing changes: x and y of
 * the case are then along two of its x, y and z. */

/* All zero: the scene as it is. */
struct mapping {
    int axes;       /* of --map: 1 or 2; 0 where it is not given */
    int swap;       /* 1: the case's x is the scene's y */
    int against[2]; /* by axis of the case: 1 where it runs against the scene's */
    double scale;   /* 0 where it is not given: 1 */
    double offset;  /* K */
    int plane;      /* of mapping_planes: the program's axes that x and y of the case are along */
};

extern const char *const mapping_planes[]; /* "x,y", "x,z", "y,z", NULL */

enum { MAPPING_WORDS = 8 };

/* 1 where nothing is given. */
int mapping_is_none(const struct mapping *m);
int mapping_same(const struct mapping *m, const struct mapping *n);

/* The axes from "x", "-x", or one of each axis such as "y,-x": the case's x and y in terms of the scene's.  0, or -1
 * for anything else. */
int mapping_read(const char *text, struct mapping *m);
/* The same words, "" where none are given; into text of MAPPING_WORDS letters. */
void mapping_print(const struct mapping *m, char *text);

/* The scene's axis of the case's, and the other way: it is the same. */
int mapping_axis(const struct mapping *m, int axis);
/* The scene's side of the case's. */
enum side mapping_side(const struct mapping *m, enum side s);

/* The coordinates of the scene at x of the case, m, and the other way; they may not overlap. */
void mapping_to_scene(const struct mapping *m, int dim, const double x[2], double to[2]);
void mapping_to_case(const struct mapping *m, int dim, const double x[2], double to[2]);

double mapping_scale(const struct mapping *m);
double mapping_temperature(const struct mapping *m, double T);      /* of the case, from the scene's */
double mapping_temperature_back(const struct mapping *m, double T); /* of the scene, from the case's */

struct image {
    struct problem problem;   /* the case: data and functions in its axes and temperatures */
    const struct problem *of; /* the scene's */
    struct mapping map;
    int interface_axis; /* of the case: two materials meet across it, in the order in which they lie along it */
};

/* Makes *image that of *p; neither may move while it is used.  Solvers take one of two materials only where
 * interface_axis is 0. */
void mapping_image(const struct mapping *m, const struct problem *p, struct image *image);

#endif
