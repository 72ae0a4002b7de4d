#ifndef HEATLADDER_VERIFICATION_PLAN_H
#define HEATLADDER_VERIFICATION_PLAN_H

/* What a run will store and do, and why, without its time loop. */

#include "solver/method.h"

struct request;

enum { PLAN_ARRAYS = 12 };

struct plan_array {
    const char *what;
    size_t bytes;
};

struct plan {
    struct options options; /* stepper and h as they will be used */
    int dim;
    int cut[2]; /* 1 where only the upper half along that axis is computed: the problem is even about its middle */
    size_t computed;   /* particles of the part that is computed, which what follows is about */
    int rows;          /* 1: a row of weights for each particle; 0: one stencil for all */
    int reach[2];      /* of the stencil, in particles; 0 with rows */
    size_t particles;  /* of the whole */
    double neighbours; /* mean number of a particle */
    int count;         /* arrays */
    struct plan_array array[PLAN_ARRAYS];
    size_t bytes; /* at the peak */
    double dt;    /* s; 0 for the exact stepper */
    long long steps;
    int stages;
    int refined; /* 1: the time step is open; what follows is its first guess */
    long long updates, interactions;
};

/* The plan of `run` for the options *o.  A status of solver/method.h. */
int plan_make(const struct request *r, const struct options *o, struct plan *plan, struct failure *why);

#endif
