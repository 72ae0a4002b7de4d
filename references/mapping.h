/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_MAPPING_H
#define HEATLADDER_REFERENCES_MAPPING_H

#include "solver/problem.h"

/* Maps a scene to a case with other axes and another temperature scale.
 *
 * The equation has no preferred axis and is linear, so a method that solves a scene also solves its image:
 *
 *     each axis of the case is an axis of the scene, in the same or the opposite direction;
 *     T_case = scale T + offset,  scale > 0
 *
 * Each k follows its axis, k_xy both of its axes.  rho_c and Robin's b do not change.  Fluxes and sources are
 * multiplied by scale; wall and air temperatures are mapped like T.  Solvers, references and norms use the scene.
 * The case file, the points of the oracle and the output of external programs use the axes and the temperature of
 * the case. */

/* All zero: the identity.  Otherwise a signed permutation of the axes: 2 of a rod, 8 of a rectangle, 48 of a box. */
struct mapping {
    int axes;             /* number of axes given to --map, 1 to 3; 0: no map */
    int from[DIM_MAX];    /* by axis of the case, if axes > 0: the scene's axis */
    int against[DIM_MAX]; /* by axis of the case: 1 if it runs opposite to the scene's axis */
    double scale;         /* 0: not given, equivalent to 1 */
    double offset;        /* K */
};

enum { MAPPING_WORDS = 12 };

/* 1 if no map is given. */
int mapping_is_none(const struct mapping *m);
int mapping_same(const struct mapping *m, const struct mapping *n);

/* Reads the axes from one word for each axis of the scene, such as "-x", "y,-x" or "z,x,-y": the axes of the case in
 * terms of the scene.  Returns 0, or -1 if the text is invalid. */
int mapping_read(const char *text, struct mapping *m);
/* Writes the same words, "" if no axes are given, to text[MAPPING_WORDS]. */
void mapping_print(const struct mapping *m, char *text);

/* The scene's axis for an axis of the case, and back. */
int mapping_axis(const struct mapping *m, int axis);
int mapping_axis_back(const struct mapping *m, int axis);
/* The scene's side for a side of the case. */
enum side mapping_side(const struct mapping *m, enum side s);

/* Coordinates of the scene from those of the case (m), and back; 0 past dim.  x and to must not overlap. */
void mapping_to_scene(const struct mapping *m, int dim, const double *x, double to[DIM_MAX]);
void mapping_to_case(const struct mapping *m, int dim, const double *x, double to[DIM_MAX]);

double mapping_scale(const struct mapping *m);
double mapping_temperature(const struct mapping *m, double T); /* scene to case */
/* K: error bound of mapping_temperature(m, T) for a T with that bound, with the rounding of scale and offset. */
double mapping_bound(const struct mapping *m, double T, double bound);
double mapping_temperature_back(const struct mapping *m, double T); /* case to scene */

struct image {
    struct problem problem;   /* the case: data and functions in its own axes and temperature scale */
    const struct problem *of; /* the scene */
    struct mapping map;
    int interface_axis; /* axis of the case that crosses the interface of two materials */
};

/* Fills *image with the image of *p.  Neither may move while the image is in use.  Solvers accept an image with two
 * materials only if interface_axis is 0. */
void mapping_image(const struct mapping *m, const struct problem *p, struct image *image);

#endif
