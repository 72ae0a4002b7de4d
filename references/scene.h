#ifndef HEATLADDER_REFERENCES_SCENE_H
#define HEATLADDER_REFERENCES_SCENE_H

#include "solver/problem.h"

#include <stddef.h>

/* A scene: a problem of the literature and its exact solution.  One file each, scene_<name>.c, found by wildcard. */

struct failure; /* solver/method.h */

struct param {
    const char *name;
    double value;     /* the default; an index into `choice` where there is one */
    const char *unit; /* SI, "" for none */
    const char *about;
    const char *const *choice; /* words that it can take, ended by NULL; NULL for a number */
};

struct exact {
    double temperature; /* K */
    double error_bound; /* K: truncation and rounding of the evaluation */
};

struct scene {
    const char *name;
    const char *about;          /* one line */
    const char *citation;       /* source and equation */
    const struct param *params; /* ended by a NULL name; at most PARAM_MAX */
    /* From p->param (every value set, finite) to the whole of *p.  0, or STATUS_INPUT with *why filled, naming
     * `--set NAME=VALUE` and what would be valid. */
    int (*setup)(struct problem *p, struct failure *why);
    /* Exact solution of *p at x and time t >= 0 s. */
    struct exact (*exact)(const struct problem *p, const double x[2], double t);
    /* A second form, derived apart, for the reference to be checked against (every scene has one). */
    struct exact (*second)(const struct problem *p, const double x[2], double t);
    /* The solution as printed in the source, K, where that differs from `exact`; else NULL. */
    double (*published)(const struct problem *p, const double x[2], double t);
};

extern const struct scene *const scenes[]; /* ended by NULL, in alphabetical order */

const struct scene *scene_find(const char *name);              /* NULL where there is none */
void scene_defaults(const struct scene *s, struct problem *p); /* p->param from the table; the rest zero */

#endif
