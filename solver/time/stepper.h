/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_STEPPER_H
#define HEATLADDER_SOLVER_TIME_STEPPER_H

#include "solver/space/operator.h"
#include "solver/sweep/state.h"

#include <complex.h>

/* Time stepping of dT/dt = L(T) = A T + g, A with its spectrum on [-bound, 0].  A stepper is a row of steppers.def
 * and one file with its struct stepper. */

struct march {
    enum stepper_name stepper; /* one that has updates */
    double time;               /* s, how long */
    long long steps;           /* 0: no steps, but `evolve` */
    double alternation;  /* steps alternate between dt (1 + alternation) and dt (1 - alternation); 0 with 3 arrays */
    int stages;          /* updates a step, where the stepper leaves them open */
    int start[2];        /* updates of a first step that damps: of each of two quarters of it, and of the half that
                            follows; 0: a step as all others */
    const double *x, *y; /* m, positions for messages; NULL where there are none, and y on a rod */
    double lo, hi;       /* K, what a stable run stays near: see stepper_march */
    double bound;        /* s^-1, of the spectrum */
};

/* What is NULL or 0 does not apply. */
struct stepper {
    const char *name, *about; /* as typed; one line */
    int order;                /* of its error in time; 0: it has no step to choose, or no error in time */
    int arrays; /* states: 2, or 3 where an update reads the state at the begin of the step (start, Y0) */
    int stages; /* updates a step; 0: as count returns */
    int (*count)(double dt, double bound); /* the fewest that a step of dt (s) takes to be stable */
    /* s: the step to take where one of `asked` is asked for (0: none); without this function it is `asked`, or half
     * of what is stable, 1/bound */
    double (*length)(double asked, double time, double bound);
    /* The updates of a step of dt into u[0] to u[stages - 1], Y0 aside: it is set where start is not 0. */
    void (*updates)(double dt, double bound, int stages, struct update *u);
    /* Where the data are rough: stages of a first step of dt as in struct march, and the updates of its quarters. */
    void (*first)(double dt, double bound, int start[2]);
    void (*damp)(double dt, int stages, struct update *u);
    /* T -> G(z) T for dT/dt = lambda T, z = dt lambda: a closed form that shares nothing with `updates`; and the
     * stability interval of theory, |G| <= 1 for -z in [0, it]. */
    double complex (*amplification)(int stages, double complex z);
    double (*interval)(int stages);
    /* A lattice of one material, which it can be used on where this gives STATUS_OK. */
    int (*needs)(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                 struct failure *why);
    /* Plans its own march; without this function whole steps of the length above. */
    int (*plan)(const struct problem *p, const struct options *o, const struct scheme *s,
                const struct heat_operator *a, struct march *m, struct failure *why);
    /* T (in the particles' order) after t (s), without steps. */
    void (*evolve)(const struct heat_operator *a, double t, double *T);
};

const struct stepper *stepper_of(enum stepper_name name); /* NULL of STEPPER_AUTO */

enum { STEPPER_STAGES_MAX = 1000000 }; /* s^2 eps, what rounding grows to in a step, stays small */

/* Applications of the operator in a march. */
long long stepper_applications(const struct march *m);

enum { STEPPER_SHARE = 16384 }; /* updates of particles that are worth a thread, between two waits */

/* Of the threads asked for those that n particles have STEPPER_SHARE updates each for. */
int stepper_threads(int asked, size_t n);

/* Takes T (n, in the particles' order) through the march; adds the bytes of its states to *bytes.  STATUS_UNSTABLE
 * with step, time and particle where T leaves [lo, hi] by half of hi - lo, or is not finite: looked at every 32 steps
 * and at the end. */
int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why);

#endif
