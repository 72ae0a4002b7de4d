/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_SCENE_H
#define HEATLADDER_REFERENCES_SCENE_H

#include "solver/problem.h"

#include <stddef.h>

/* A scene: a problem of the literature and its exact solution.  One file each, scene_<name>.c, found by wildcard. */

struct failure; /* solver/status.h */

struct param {
    const char *name;
    double value;     /* the default; an index into `choice` where there is one */
    const char *unit; /* SI, "" for none */
    const char *about;
    const char *const *choice; /* words that it can take, ended by NULL; NULL for a number */
};

struct exact {
    double temperature;       /* K */
    double error_bound;       /* K: truncation and rounding of the evaluation */
    double gradient[2];       /* K m^-1; along y 0 on a rod.  Of `exact` alone, and at t > 0 */
    double gradient_bound[2]; /* K m^-1 */
    int no_value; /* 1 where the solution has no value: a corner whose sides disagree.  temperature is then
                     the mean of the two, error_bound half their difference */
};

/* Parameters for tests, all distinct and none 0 or 1 where another value can be, so that no swap or forgotten factor
 * can hide. */
struct scene_odd {
    double param[PARAM_MAX];
    double scale;    /* K, of the temperature differences */
    double step;     /* m, of the differences that check the equation */
    double earliest; /* s, from when on the solution is smooth over a few steps */
};

struct scene {
    const char *name;
    const char *about;          /* one line */
    const char *citation;       /* source and equation */
    const struct param *params; /* the last is the end time; ended by a NULL name; at most PARAM_MAX */
    /* From p->param (every value set, finite) to the whole of *p.  0, or STATUS_INPUT with *why filled, naming
     * `--set NAME=VALUE` and what would be valid. */
    int (*setup)(struct problem *p, struct failure *why);
    /* What all points share at the time t >= 0, to be freed by free(); NULL where the scene has nothing to share. */
    void *(*prepare)(const struct problem *p, double t);
    /* Exact solution of *p at x and time t, from what `prepare` gave for that time; NULL as `prepare` is. */
    struct exact (*prepared)(const struct problem *p, const void *shared, const double x[2], double t);
    /* The same at the n points (x[i], y[i]), where those of a lattice have more to share; else NULL. */
    void (*at_points)(const struct problem *p, const void *shared, size_t n, const double *x, const double *y,
                      double t, struct exact *e);
    /* Exact solution of *p at x and time t >= 0 s, of a scene that has nothing to share; else NULL (scene_exact). */
    struct exact (*exact)(const struct problem *p, const double x[2], double t);
    /* A second form of the temperature, derived apart, for the reference to be checked against (every scene has one).
     */
    struct exact (*second)(const struct problem *p, const double x[2], double t);
    /* The solution as printed in the source, K, where that differs from `exact`; else NULL. */
    double (*published)(const struct problem *p, const double x[2], double t);
    struct scene_odd odd;
};

extern const struct scene *const scenes[]; /* ended by NULL, in alphabetical order */

const struct scene *scene_find(const char *name);              /* NULL where there is none */
void scene_defaults(const struct scene *s, struct problem *p); /* p->param from the table; the rest zero */

/* The exact solution of any scene at x, m, and time t >= 0 s.  For many points at one time: snapshot.h. */
struct exact scene_exact(const struct scene *s, const struct problem *p, const double x[2], double t);

#endif
