/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SCENE_H
#define HEATLADDER_REFERENCES_SCENE_H

#include "solver/problem.h"

#include <stddef.h>

/* A scene: a problem from the literature with its exact solution.
 *
 * To add one, write references/scene_NAME.c with `const struct scene scene_NAME = {`: make finds it, and all tests
 * run on it.  Begin with a scene that is near, such as scene_rod_cosine.c.
 *   - `exact` is finite, with its bound, from t = 1e-310 to 1e300 s: let exponents underflow, divide by no t that is
 * 0.
 *   - Gradients have bounds too, and obey the walls: fill gradient_bound.  INFINITY is allowed at a front alone.
 *   - `second` is derived independently.  Where it takes too many terms its error_bound is INFINITY.
 *   - `odd`: distinct values, none 0 or 1.  `earliest`: from then on T is smooth over 10 `step`, that is, step is
 * below a tenth of sqrt(4 kappa earliest); 0.1 s and a hundredth of the extent fit a scene that starts smooth.
 *   - Name the kinks and jumps of the initial data (jump, kink of struct problem), or means over cells miss them. */

struct failure;

struct param {
    const char *name;
    double value;     /* default; an index into `choice` if there is one */
    const char *unit; /* SI, "" if dimensionless */
    const char *about;
    const char *const *choice; /* valid words, ended by NULL; NULL for a number */
};

struct exact {
    double temperature;             /* K */
    double error_bound;             /* K: truncation and rounding error of the evaluation */
    double gradient[DIM_MAX];       /* K m^-1; 0 along axes past dim.  Of `exact`, at t > 0 */
    double gradient_bound[DIM_MAX]; /* K m^-1 */
    int no_value; /* 1 at a corner between sides at different temperatures: temperature is their mean, error_bound
                     half their difference */
};

/* Parameters for tests.  All differ, and none is 0 or 1 where another value is valid, so a swapped or missing factor
 * changes the result. */
struct scene_odd {
    double param[PARAM_MAX];
    double scale;    /* K, scale of the temperature differences */
    double step;     /* m, step of the differences that check the equation */
    double earliest; /* s, from this time on the solution is smooth over a few steps */
};

struct scene {
    const char *name;
    const char *about;          /* one line */
    const char *citation;       /* source and equation */
    const struct param *params; /* ended by a NULL name; the last one is the end time; at most PARAM_MAX */
    /* Fills *p from p->param (every value set and finite).  Returns 0, or STATUS_INPUT with *why naming `--set
     * NAME=VALUE` and the valid range. */
    int (*setup)(struct problem *p, struct failure *why);
    /* Terms that all points share at the time t >= 0, freed by free(); NULL if there are none. */
    void *(*prepare)(const struct problem *p, double t);
    /* Exact solution at x and time t >= 0 s; `shared` is the result of `prepare`, or NULL. */
    struct exact (*exact)(const struct problem *p, const void *shared, const double *x, double t);
    /* The same at the n points (x[0][i], x[1][i], ...) for scenes in which lattice points share more work; else
     * NULL. */
    void (*at_points)(const struct problem *p, const void *shared, size_t n, const double *const *x, double t,
                      struct exact *e);
    /* Second form of the temperature, derived independently, to check the reference.  Every scene has one. */
    struct exact (*second)(const struct problem *p, const double *x, double t);
    /* Solution as printed in the source, K, if it differs from `exact`; else NULL. */
    double (*published)(const struct problem *p, const double *x, double t);
    struct scene_odd odd;
};

extern const struct scene *const scenes[]; /* ended by NULL, in alphabetical order */

const struct scene *scene_find(const char *name);              /* NULL if unknown */
void scene_defaults(const struct scene *s, struct problem *p); /* sets p->param to the defaults, all else to zero */

/* Exact solution of any scene at x (m) and time t >= 0 s.  For many points at one time use snapshot.h. */
struct exact scene_exact(const struct scene *s, const struct problem *p, const double *x, double t);

#endif
