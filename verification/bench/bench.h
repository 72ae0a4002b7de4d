/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_BENCH_H
#define HEATLADDER_VERIFICATION_BENCH_BENCH_H

/* Error against cost: every candidate on a ladder of one scene, each rung timed several times. */

#include "verification/judge/run.h"

struct experiment;

/* ---- Candidates ---- */

/* Combinations of method and options whose error depends on dx alone. */

/* A brief one has every method with its best stepper on a lattice. */
enum bench_length { BENCH_LONG, BENCH_BOTH, BENCH_BRIEF };

struct candidate {
    const char *label;
    const char *method;
    struct options options; /* dx left open */
    int dim;                /* 1 or 2: for that dimension only; 0: for both */
    double steps;           /* > 0: 10 time steps and this number for each particle along x */
    enum bench_length in;   /* the benchmark that it is part of */
};

enum { CANDIDATE_UNIT_MAX = 1024 };

extern const struct candidate bench_candidates[]; /* ended by a NULL label */

/* The candidate's options with n particles along x: dx in m, dt in s. */
struct options bench_candidate_options(const struct candidate *c, const struct experiment *e, int n);

/* The smallest number of cells along x for which square cells tile the domain, with every jump on a face if
 * possible; its multiples tile it too.  0 if there is none up to CANDIDATE_UNIT_MAX. */
int bench_candidate_unit(const struct problem *p);

/* The smallest multiple of the unit that is at least `least`. */
int bench_candidate_member(double least, int unit);

/* Solves only; arguments as in struct method. */
int bench_candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                          struct failure *why);

/* Runs and measures the candidate like run_experiment. */
int bench_candidate_run(const struct candidate *c, const struct experiment *e, int n, struct result *out);

/* ---- Their ladders, timed ---- */

enum { BENCH_RUNS = 5, BENCH_RUNGS = 6, BENCH_ROWS = 180 };

struct bench_time {
    double median, lowest, highest; /* s */
};

struct bench_row {
    const struct candidate *candidate;
    int n;                /* particles along x */
    struct result result; /* its failure is the reason if there are no results */
    int left_out;         /* 1: not run, because its predicted time exceeds the limit */
    struct bench_time time;
    double work;                /* in the unit of solver/work.h */
    int front_time, front_work; /* 1: no other row has a smaller error at a lower cost */
};

struct bench_scene {
    const struct scene *scene;
    int count;
    struct bench_row row[BENCH_ROWS]; /* by candidate, coarsest first */
};

/* The counted work, or the median of the seconds. */
double bench_cost(const struct bench_row *row, int by_work);

/* "left out" if a run would take too long, "failed" if it failed, "not applicable" if the method refuses the
 * request; otherwise NULL. */
const char *bench_outcome(const struct bench_row *row);

/* Adds to *b the rungs of one candidate, n in multiples of `unit`, until two have failed or one is left out.
 * `seconds` limits its time. */
void bench_climb(const struct candidate *c, const struct experiment *e, int unit, double seconds,
                 struct bench_scene *b);

/* Fills *b within `seconds` with the candidates of a long or a brief benchmark; *e holds the scene, set up.  Runs one
 * after another on one thread. */
void bench_run(const struct experiment *e, enum bench_length length, double seconds, struct bench_scene *b);

/* Median and extremes of `count` times, which are sorted. */
struct bench_time bench_summary(double *seconds, int count);

#endif
