/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_BENCH_H
#define HEATLADDER_VERIFICATION_BENCH_BENCH_H

/* Error against cost: every candidate on a ladder of one scene, each rung timed several times. */

#include "verification/bench/candidate.h"

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

/* Fills *b within `seconds`; *e holds the scene, set up.  Runs one after another on one thread. */
void bench_run(const struct experiment *e, double seconds, struct bench_scene *b);

/* Median and extremes of `count` times, which are sorted. */
struct bench_time bench_summary(double *seconds, int count);

/* Ratio of the medians, with the smallest and largest ratios that the extremes admit. */
struct bench_time bench_ratio(struct bench_time a, struct bench_time b);

#endif
