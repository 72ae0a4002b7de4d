/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_CANDIDATE_H
#define HEATLADDER_VERIFICATION_BENCH_CANDIDATE_H

/* Combinations of method and options with an error that falls with dx alone. */

#include "verification/run/result.h"

struct experiment;

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* > 0: time steps for each particle along x, and 10 */
};

enum { CANDIDATE_UNIT_MAX = 1024 };

extern const struct candidate candidates_table[]; /* ended by a NULL label */

/* Its options with n particles along x of the domain: dx in m, dt in s. */
struct options candidate_options(const struct candidate *c, const struct experiment *e, int n);

/* The least number of cells along x with which square cells tile the domain, every jump on a face where that is
 * possible; so do its multiples.  0 where there is none up to CANDIDATE_UNIT_MAX. */
int candidate_unit(const struct problem *p);

/* The smallest multiple of the unit that is not below `least`. */
int candidate_member(double least, int unit);

/* The solve alone, as struct method's. */
int candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                    struct failure *why);

/* Runs and measures it, as run_experiment. */
int candidate_run(const struct candidate *c, const struct experiment *e, int n, struct result *out);

#endif
