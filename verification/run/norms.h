/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_NORMS_H
#define HEATLADDER_VERIFICATION_RUN_NORMS_H

/* Norms of a field's error, its range, variation, checkerboard and heat.  Sums are sum(w |e|^p) with w the volume
 * that a point stands for. */

#include <math.h>
#include <stddef.h>

struct failure;
struct field;
struct problem;
struct scene;

/* Stands for the exact temperature at a point where the solution has none (scene.h); such points count in no norm. */
#define NORMS_NO_VALUE INFINITY

/* The exact solution at the points of *f at time f->time: T[f->n], K, or NORMS_NO_VALUE.  Returns sum(w bound) /
 * sum(w |T|), the part of E1 that the reference's own error bound can make up. */
double norms_exact(const struct scene *s, const struct problem *p, const struct field *f, double *T);

/* STATUS_INPUT where the exact solution is zero or without a value at every point of *f: no error is relative to
 * that. */
int norms_check(const struct field *f, const double *exact, struct failure *why);

struct norms_error {
    double l1;       /* sum w|T - Te| / sum w|Te|  (Song 2018, eq. 46) */
    double l2;       /* sqrt(sum w(T - Te)^2 / sum w Te^2) */
    double linf;     /* K: max |T - Te|, absolute */
    size_t n;        /* points that counted */
    size_t left_out; /* points of the field where the solution has no value */
};

enum { NORMS_MANY = 20000 }; /* points: more than threads cost to start */

enum norms_part { NORMS_ALL, NORMS_INTERIOR, NORMS_BOUNDARY };

/* Over the points whose distance to the nearest wall is at least (interior) or below (boundary) `distance`, m.
 * A NaN in the field makes every norm NaN; a part without points too. */
struct norms_error norms_error(const struct problem *p, const struct field *f, const double *exact,
                               enum norms_part part, double distance);

struct norms_shape {
    double min, max;              /* K, of the field */
    double overshoot, undershoot; /* K, past the range of start, held walls and air beyond cooled ones; 0 within */
    double variation;             /* K (K m for a rectangle): sum of |difference| along the axes; NaN off a lattice */
    double checkerboard;          /* K: see checkerboard_amplitude */
};

/* exact: T of norms_exact, K. */
struct norms_shape norms_shape(const struct problem *p, const struct field *f, const double *exact);

/* (heat at the end - heat at the start) / |heat at the start| */
double norms_heat_drift(const struct field *f);

/* The largest amplitude, K, among the modes of the error T - exact that have 2 to 4 points to a wavelength along some
 * axis; a pure mode of amplitude c gives c.  NaN where the field is on no lattice. */
double checkerboard_amplitude(const struct problem *p, const struct field *f, const double *exact);

#endif
