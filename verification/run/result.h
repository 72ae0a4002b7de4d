/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_RUN_RESULT_H
#define HEATLADDER_VERIFICATION_RUN_RESULT_H

/* The result of one run: options as resolved, norms, counts and times. */

#include "solver/method.h"
#include "verification/run/norms.h"

struct json;

struct result {
    const struct scene *scene;
    const struct method *method;
    struct options options; /* as used: stepper and h resolved */
    struct failure failure; /* status STATUS_OK where there is a solution; else only the options above are set */
    double t_end;           /* s */
    double dt;              /* s; 0 for the exact stepper */
    double fourier;         /* dt max(kappa) / dx^2 */
    long long steps;
    int stages;    /* operator applications a step */
    double saving; /* updates of the fewest stable Euler steps over those taken, of a stepper with stages; NaN:
                      unknown */
    size_t particles;
    struct norms_error error;
    struct norms_error interior, boundary; /* a tenth of the least extent or more from the nearest wall, and nearer */
    struct norms_shape shape;
    double heat_drift;
    const char *derived_name;      /* the quantity of struct experiment; NULL for none */
    double derived, derived_exact; /* numerical and exact */
    double derived_error;          /* |difference| over |exact|, or itself where that is 0 */
    double derived_bound;          /* what the exact one's own error can make up of it */
    double derived_rounding;       /* what rounding can make up of it */
    double growth;     /* s^-1: of the fastest growing mode, 0 where none grows, NaN where it was not looked for */
    double time_error; /* the part of error.l1 that the time step makes up; 0 for exact, NaN where unknown */
    double reference_error; /* what the reference's own error can make up of error.l1 */
    double rounding;        /* what rounding can make up of error.l1 */
    struct cost cost;
    long long search_updates; /* of the runs that the choice of the time step took beside this one */
};

/* 1 where the method takes the option, by its key. */
int result_accepts(const struct result *r, const char *option);

/* 1 where a mode grows by more than twice in the run. */
int result_grows(const struct result *r);

/* A line on standard error where a mode grows. */
void result_warn(const struct result *r);

/* The members of the `run --json` contract, into an object that is open. */
void result_json(const struct result *r, struct json *j);

/* One line: what was run and how.  Cut to size. */
void result_describe(const struct result *r, char *text, size_t size);

#endif
