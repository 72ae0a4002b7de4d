/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_PLAN_H
#define HEATLADDER_VERIFICATION_CHOOSE_PLAN_H

/* Predicted storage and work of a run: the outline of its method for the part that is computed, and what symmetry,
 * the search for a time step and the measured errors add. */

#include "solver/method.h"
#include "solver/outline.h"

struct experiment;

/* What is done to predict an open time step. */
enum plan_search {
    PLAN_STORAGE, /* nothing, for the bytes alone: it counts as one step */
    PLAN_RUN,     /* the run itself, where it is small, or coarser ones */
    PLAN_SKETCH   /* coarser runs alone: less work than the run */
};

struct plan_steps {
    double steps; /* 0: none, no coarser run is possible or the steps are out of reach */
    int runs;     /* that it rests on: the run itself, where it is small, or two coarser ones */
    double dx[2]; /* m, theirs */
};

struct plan {
    struct options options; /* stepper and h as they will be used */
    int dim;
    int cut[2]; /* 1 where only the upper half along that axis is computed: the problem is even about its middle */
    struct outline part; /* what is computed */
    size_t particles;    /* of the whole */
    int refined;         /* 1: the time step is open; steps, updates and interactions are predicted */
    struct plan_steps forecast;
};

extern const char *const plan_phases[]; /* names of enum outline_phase, ended by NULL */

/* The phase in which most bytes are held. */
enum outline_phase plan_peak(const struct plan *plan);

/* What the solve does, in the unit of solver/outline.h, entries of rows at what it takes to read them. */
double plan_work(const struct plan *plan);

/* The plan of the run of *e.  Nothing as large as the run's own arrays is allocated, but for rows, which are
 * assembled up to 2e5 particles and estimated past that, and for the coarse runs that predict an open time step.
 * Bytes are good to 5 %, but for rows while they are assembled (a factor of 1.5) and for what FFTW holds, which is
 * left out: on a rod up to 0.6 of the plan, and 0.2 MB of a program's life. A status of solver/status.h: what the run
 * refuses, and STATUS_NOT_APPLICABLE for a method that has no outline. */
int plan_make(const struct experiment *e, enum plan_search search, struct plan *plan, struct failure *why);

/* How many steps verification/run/time_step.h will choose for a run whose time step *e leaves open: 1 for `first`, or
 * 2 where the run itself is not to be made. */
struct plan_steps plan_steps_predict(const struct experiment *e, int first);

/* Particles of spacing dx, m, that fill the domain; not rounded. */
double plan_steps_particles(const struct problem *p, double dx);

#endif
