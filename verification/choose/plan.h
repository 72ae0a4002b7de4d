#ifndef HEATLADDER_VERIFICATION_CHOOSE_PLAN_H
#define HEATLADDER_VERIFICATION_CHOOSE_PLAN_H

/* What a run will store and do, and why, without doing it. */

#include "verification/choose/plan_steps.h"

struct experiment;

enum { PLAN_ARRAYS = 16 };

/* A run holds most in one of these. */
enum plan_phase { PLAN_SET_UP, PLAN_STEPS, PLAN_ANSWER, PLAN_REFINE, PLAN_ERRORS, PLAN_PHASES };

struct plan_array {
    const char *what;
    size_t bytes;
    enum plan_phase from, to; /* held from the one to the other */
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
    double stand_in;   /* m: the spacing of the coarser rows that were counted; 0: these rows themselves */
    size_t answer;     /* bytes of the part's places and temperatures */
    int count;         /* arrays */
    struct plan_array array[PLAN_ARRAYS]; /* all but what no number of particles adds to */
    size_t bytes[PLAN_PHASES];            /* held in each phase */
    double dt;                            /* s; 0 for the exact stepper */
    long long steps;
    int stages;
    int refined; /* 1: the time step is open; what follows is foretold */
    struct plan_steps forecast;
    long long updates, interactions;
};

extern const char *const plan_phases[]; /* their names, ended by NULL */

enum plan_phase plan_peak(const struct plan *plan);

/* The plan of the run of *e.  Nothing as large as the run's own arrays is allocated, but for rows, which
 * are assembled up to 2e5 particles and estimated past that, and for the coarse runs that foretell an open time step.
 * A status of solver/method.h. */
int plan_make(const struct experiment *e, struct plan *plan, struct failure *why);

#endif
