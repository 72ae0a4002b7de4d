/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_CANDIDATE_H
#define HEATLADDER_VERIFICATION_BENCH_CANDIDATE_H

/* Combinations of method and options whose error depends on dx alone. */

#include "verification/judge/result.h"

struct experiment;

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* > 0: 10 time steps and this number for each particle along x */
};

enum { CANDIDATE_UNIT_MAX = 1024 };

extern const struct candidate candidates_table[]; /* ended by a NULL label */

/* The candidate's options with n particles along x: dx in m, dt in s. */
struct options candidate_options(const struct candidate *c, const struct experiment *e, int n);

/* The smallest number of cells along x for which square cells tile the domain, with every jump on a face if
 * possible; its multiples tile it too.  0 if there is none up to CANDIDATE_UNIT_MAX. */
int candidate_unit(const struct problem *p);

/* The smallest multiple of the unit that is at least `least`. */
int candidate_member(double least, int unit);

/* Solves only; arguments as in struct method. */
int candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                    struct failure *why);

/* Runs and measures the candidate like run_experiment. */
int candidate_run(const struct candidate *c, const struct experiment *e, int n, struct result *out);

#endif
