#ifndef HEATLADDER_VERIFICATION_FORECAST_H
#define HEATLADDER_VERIFICATION_FORECAST_H

#include "solver/method.h"

struct request;

struct forecast {
    double steps; /* 0: none, no coarser run is possible or the steps are out of reach */
    int runs;     /* that it rests on: the run itself, where it is small, or two coarser ones */
    double dx[2]; /* m, theirs */
};

/* How many steps verification/stepping.h will choose for a run whose time step *o leaves open. */
struct forecast forecast_steps(const struct request *r, const struct options *o);

#endif
