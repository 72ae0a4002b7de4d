/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_JUDGE_RESULT_H
#define HEATLADDER_VERIFICATION_JUDGE_RESULT_H

/* The result of one run: options as resolved, norms, counts and times. */

#include "solver/method.h"
#include "verification/judge/norms.h"

struct json;

struct result {
    const struct scene *scene;
    const struct method *method;
    struct options options; /* as used, with stepper and h resolved */
    struct failure failure; /* STATUS_OK if there is a solution; otherwise only the options above are set */
    double t_end;           /* s */
    double dt;              /* s; 0 for the exact stepper */
    double fourier;         /* dt max(kappa) / dx^2 */
    long long steps;
    int stages;    /* operator applications per step */
    double saving; /* updates of the fewest stable Euler steps over those of a stepper with stages; NaN: unknown */
    size_t particles;
    double error[NORM_QUANTITY + 1]; /* in each norm; of the quantity |difference| over |exact|, or |difference| if
                                        that is 0.  A point is near a wall within a tenth of the extent. */
    size_t left_out;                 /* points without an exact value */
    struct norms_shape shape;
    double heat_drift;
    const char *derived_name;      /* the quantity of struct experiment; NULL for none */
    double derived, derived_exact; /* numerical and exact */
    double derived_bound;          /* possible share of the exact value's own error */
    double derived_rounding;       /* possible share of rounding */
    double growth;                 /* s^-1: of the fastest growing mode, 0 if none grows, NaN if not determined */
    double time_error;             /* share of the time step in error[NORM_L1]; 0 for exact, NaN if unknown */
    double reference_error;        /* possible share of the reference's own error in error[NORM_L1] */
    double rounding;               /* possible share of rounding in error[NORM_L1] */
    struct cost cost;
    long long search_updates; /* updates of the other runs in the search for the time step */
};

/* 1 if the method accepts the option. */
int result_accepts(const struct result *r, const char *option);

/* 1 if a mode grows by more than a factor of 2 in the run. */
int result_grows(const struct result *r);

/* Warns on standard error if a mode grows. */
void result_warn(const struct result *r);

/* Writes the members of the `run --json` contract into an open object. */
void result_json(const struct result *r, struct json *j);

/* One line: what was run, and how; truncated to size. */
void result_describe(const struct result *r, char *text, size_t size);

#endif
