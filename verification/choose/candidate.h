/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CHOOSE_CANDIDATE_H
#define HEATLADDER_VERIFICATION_CHOOSE_CANDIDATE_H

/* Combinations of method and options with an error that falls with dx alone, so that a few coarse runs predict the
 * rest. */

#include "verification/run/result.h"

struct experiment;

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* > 0: time steps for each particle along x, and 10 */
    int bench_only;         /* 1: for bench alone */
};

enum { CANDIDATE_UNIT_MAX = 1024 };

extern const struct candidate candidates_table[]; /* ended by a NULL label */

/* Its options with n particles along x of the domain: dx in m, dt in s. */
struct options candidate_options(const struct candidate *c, const struct experiment *e, int n);

/* The least number of cells along x with which square cells tile the domain, every jump on a face where that is
 * possible; so do its multiples.  0 where there is none up to CANDIDATE_UNIT_MAX. */
int candidate_unit(const struct problem *p);

/* As text: the nearest domain that has a candidate_unit. */
void candidate_fitting(const struct problem *p, char *text, size_t size);

/* The smallest multiple of the unit that is not below `least`. */
int candidate_member(double least, int unit);

/* The solve alone, as struct method's. */
int candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                    struct failure *why);

/* Runs and measures it, as run_experiment; *between, where not NULL: the error half-way between the particles
 * (halfway.h). */
int candidate_prove(const struct candidate *c, const struct experiment *e, int n, struct result *out,
                    double *between);

/* The predicted cost of a run, from its plan (plan.h). */
struct candidate_cost {
    double work;     /* field.work */
    double whole;    /* with the exact temperatures and the full cost of CSR entries: for limits */
    double proof;    /* with those half-way between the particles too */
    double bytes;    /* peak */
    double rounding; /* mean part of E1 due to rounding */
};

/* The cost of the run; a status of solver/status.h.  Rounding: T is rounded at each application of the operator, by
 * eps/4 of itself in the mean and at random: eps/4 sqrt(applications).  With transforms the symbol of the slowest
 * mode is what is left of terms of size kappa/dx^2, each wrong by eps/4 in the mean, and acts until the mode is gone:
 * eps/4 kappa min(t, L^2/(pi^2 kappa))/dx^2. */
int candidate_predict(const struct candidate *c, const struct experiment *e, int n, struct candidate_cost *cost,
                      struct failure *why);

#endif
