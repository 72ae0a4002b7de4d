/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_NORMS_H
#define HEATLADDER_VERIFICATION_JUDGE_NORMS_H

/* Norms of the error of a field; its range, variation, checkerboard and heat.  Sums are sum(w |e|^p) with the volume
 * weight w of each point. */

#include "verification/case/norm.h"

#include <math.h>
#include <stddef.h>

struct failure;
struct field;
struct mapping;
struct problem;
struct scene;

/* Marks points without an exact temperature (scene.h); they are excluded from all norms. */
#define NORMS_NO_VALUE INFINITY

/* Sets T[f->n], K, to the exact solution at the points of *f and the time f->time, or NORMS_NO_VALUE.  Returns
 * sum(w bound) / sum(w |T|), the possible contribution of the reference's own error to E1. */
double norms_exact(const struct scene *s, const struct problem *p, const struct field *f, double *T);

/* Refuses if the exact solution is zero or has no value at every point of *f, since no relative error exists. */
int norms_check(const struct field *f, const double *exact, struct failure *why);

enum { NORMS_MANY = 20000 }; /* points above which threads pay off */

/* 1 for each point whose distance to the nearest wall is below `distance`, m.  The caller frees the array. */
unsigned char *norms_near(const struct problem *p, const struct field *f, double distance);

/* One function per row of norms.def: the norm of the error T - exact.  near: marks of norms_near; NULL where they are
 * not known, which leaves a norm of a part without a value.  NaN if the field has a NaN or the part has no points. */
#define NORM(NAME, word, title, column, key, of)                                                                     \
    double norms_##of(const struct field *f, const double *exact, const unsigned char *near);
#include "verification/case/norms.def"
#undef NORM

/* All of them, in the order of the rows. */
void norms_all(const struct field *f, const double *exact, const unsigned char *near, double error[NORM_QUANTITY]);

/* The number of points without an exact value. */
size_t norms_left_out(const struct field *f, const double *exact);

struct norms_shape {
    double min, max;              /* K, of the field */
    double overshoot, undershoot; /* K, beyond initial data, Dirichlet walls and air at Robin walls; 0 within */
    double variation;             /* K m^(dim-1): sum of |difference| along the axes; NaN off a lattice */
    double checkerboard;          /* K, see norms_checkerboard */
};

/* exact: T from norms_exact, K; overwritten by norms_checkerboard. */
struct norms_shape norms_shape(const struct problem *p, const struct field *f, double *exact);

/* (final heat - initial heat) / |initial heat| */
double norms_heat_drift(const struct field *f);

/* Mean relative rounding error of the printed T in terms of E1 (at most half of its maximum), and the number of
 * digits. *f is of the scene, *map from there to the case, whose temperatures a program printed. */
double norms_digits(const struct field *f, const struct mapping *map, int *digits);

/* The largest amplitude, K, among the modes of the error T - exact with 2 to 4 points per wavelength along some
 * axis; a pure mode of amplitude c gives c.  NaN if the field is not on a lattice.  Overwrites `exact` (T from
 * norms_exact, K) with the transform of the error. */
double norms_checkerboard(const struct problem *p, const struct field *f, double *exact);

#endif
