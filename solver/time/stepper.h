#ifndef HEATLADDER_SOLVER_TIME_STEPPER_H
#define HEATLADDER_SOLVER_TIME_STEPPER_H

#include "solver/space/operator.h"

/* Explicit time stepping of dT/dt = A T + g. */

struct march {
    enum stepper stepper; /* STEPPER_EULER, STEPPER_RK2, STEPPER_RKL2 or STEPPER_CHEBYSHEV */
    double time;          /* s, how long */
    long long steps;
    double alternation;  /* STEPPER_EULER: steps alternate between dt (1 + alternation) and dt (1 - alternation) */
    int stages;          /* STEPPER_RKL2; the degree of STEPPER_CHEBYSHEV; else 1 or 2 */
    int start[2];        /* STEPPER_RKL2: stages of a first step that damps, of each of two quarters of it and of the
                            half that follows; 0: a step as all others */
    const double *x, *y; /* m, positions for messages; NULL where there are none, and y on a rod */
    double lo, hi;       /* K, what a stable run stays near: see stepper_march */
    double bound;        /* s^-1, of the spectrum: for STEPPER_CHEBYSHEV, and for messages */
};

enum { STEPPER_STAGES_MAX = 1000000 }; /* s^2 eps, what rounding grows to in a step, stays small */

/* Stages that RKL2 needs for steps of dt (s), odd, from the bound (s^-1) on the spectrum; or more than
 * STEPPER_STAGES_MAX. */
int stepper_stages(double dt, double bound);

/* The stages of a damping first step of dt (s). */
void stepper_start(double dt, double bound, int stages[2]);

/* Applications of the operator in a march. */
long long stepper_applications(const struct march *m);

/* How many states a march holds. */
int stepper_arrays(enum stepper stepper);

/* Takes T (n, in the particles' order) through the march; adds what it holds to *bytes.  STATUS_UNSTABLE with step,
 * time and particle where T leaves [lo, hi] by half of hi - lo, or is not finite: looked at every 32 steps and at the
 * end. */
int stepper_march(const struct heat_operator *a, const struct march *m, double *T, size_t *bytes,
                  struct failure *why);

#endif
