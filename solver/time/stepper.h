/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_STEPPER_H
#define HEATLADDER_SOLVER_TIME_STEPPER_H

#include "solver/space/operator.h"
#include "solver/sweep/state.h"

#include <complex.h>

/* Time stepping of dT/dt = L(T) = A T + g with the spectrum of A in [-bound, 0].  A stepper is a row of steppers.def
 * and a file with its struct stepper. */

/* One stage of a step of dT/dt = L(T, t) that need not be linear:
 *
 *     Y_j = newer Y_(j-1) + older Y_(j-2) + (1 - newer - older) Y_0 + dt rate (L_(j-1) - first L_0),
 *
 * Y_0 the state at t, L_0 = L(Y_0, t), L_(j-1) = L(Y_(j-1), t + time dt).  Stage 1 is Y_0 + dt rate L_0. */
struct stage {
    double newer, older, rate, first, time;
};

struct march {
    enum stepper_name stepper; /* a stepper with updates */
    double time;               /* s, length of the run */
    long long steps;           /* 0: no steps, `evolve` instead */
    double alternation; /* steps alternate between dt (1 + alternation) and dt (1 - alternation); must be 0 with 3
                           arrays */
    int stages;         /* updates per step if the stepper has no fixed number */
    int start[2]; /* a damping first step: updates of a quarter step, done twice, and of the half step after them; 0:
                     the first step is like all others */
    const struct field *field; /* its positions are for messages; NULL if there are none */
    double lo, hi;             /* K, range of a stable run, see stepper_march */
    const struct problem
        *changing; /* the problem, if its walls or source change in time, with `options`; else NULL */
    const struct options *options;
    double bound; /* s^-1, spectral bound */
};

/* NULL or 0: not applicable. */
struct stepper {
    const char *name, *about; /* name on the command line; one line of description */
    int order;                /* order in time; 0: no time step, or no time error */
    int arrays;               /* states: 2, or 3 if an update reads Y0, the state at the start of the step.  With 3,
                                 Y0 is `start`: `old` of u[0] and u[1] has no value, so u[1] of a method that
                                 needs the start has .start, not .old */
    int stages;               /* updates per step; 0: returned by count */
    int degree;               /* degree of data that change within a step, as polynomials in time (stepper.c), p - 1
                                 for order p; 0: 1 */
    int damped;               /* stages up to which eigenvalues off the real axis decay too; 0: no limit */
    double (*error)(int stages);           /* time error relative to that of many stages; NULL: 1 */
    int (*count)(double dt, double bound); /* smallest number of updates for which a step of dt (s) is stable */
    /* Step length, s, if the user asks for `asked` (0: none).  If NULL: `asked`, or half of the stable step,
     * 1/bound. */
    double (*length)(double asked, double time, double bound);
    /* Fills u[0] to u[stages - 1] for a step of dt, except Y0, which is set if start is not 0. */
    void (*updates)(double dt, double bound, int stages, struct update *u);
    /* Stage j = 1 .. s of a step of s stages for an L that is not linear; NULL: for linear L only. */
    struct stage (*stage)(int s, int j);
    /* For rough data: `start` of struct march for a first step of dt, and the updates of a quarter step. */
    void (*first)(double dt, double bound, int start[2]);
    void (*damp)(double dt, int stages, struct update *u);
    /* Amplification factor G(z) for dT/dt = lambda T, z = dt lambda, in closed form and independent of `updates`;
     * and the theoretical stability interval, |G| <= 1 for 0 <= -z <= interval. */
    double complex (*amplification)(int stages, double complex z);
    double (*interval)(int stages);
    /* Requires a lattice of one material, and STATUS_OK from this function. */
    int (*needs)(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                 struct failure *why);
    /* Plans the march; NULL: whole steps of the length above. */
    int (*plan)(const struct problem *p, const struct options *o, const struct scheme *s,
                const struct heat_operator *a, struct march *m, struct failure *why);
    /* Advances T (in the particles' order) by t (s) without steps. */
    void (*evolve)(const struct heat_operator *a, double t, double *T);
};

const struct stepper *stepper_of(enum stepper_name name); /* NULL for STEPPER_AUTO */

enum { STEPPER_LIST = 100 };
/* "a, b or c", for messages: the steppers for data that change, or those for an L that is not linear; returns text.
 */
const char *stepper_list(int nonlinear, char text[STEPPER_LIST]);

/* The stepper that STEPPER_AUTO stands for.  With a step given, and for finite differences: Euler's method.  Else the
 * one without time error, which needs one stencil for all particles; where it does not apply (transforms 0): the one
 * that does the work of s^2/4 Euler steps in s stages. */
enum stepper_name stepper_auto(int particles, int step_given, int transforms);

/* A stepper without time error, with or without one stencil for all particles. */
enum stepper_name stepper_without_error(int transforms);

enum { STEPPER_STAGES_MAX = 1000000 }; /* keeps the rounding error of a step, s^2 eps, small */

/* Number of operator applications in a march. */
long long stepper_applications(const struct march *m);

enum { STEPPER_SHARE = 16384 }; /* updates of particles per thread between two waits that justify a thread */

/* The number of threads, at most `asked`, for which each has at least STEPPER_SHARE updates of the n particles. */
int stepper_threads(int asked, size_t n);

/* Advances T (n, in the particles' order, with room for a->state) through the march.  T is one of its states; adds
 * the bytes of the others, and of the ghosts, to *bytes.  Returns STATUS_UNSTABLE with step, time and particle if T
 * leaves [lo, hi] by half of hi - lo or is not finite; checked every 32 steps and at the end. */
int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why);

#endif
