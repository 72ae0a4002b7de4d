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
    struct result result; /* its failure says why there is no more than that */
    int left_out;         /* 1: not run, since it is predicted to take longer than may be spent */
    struct bench_time time;
    double work;                /* in the unit of solver/work.h */
    int front_time, front_work; /* 1: no other row has a smaller error for less */
};

struct bench_scene {
    const struct scene *scene;
    int count;
    struct bench_row row[BENCH_ROWS]; /* by candidate, coarsest first */
};

/* The counted work, or the median of the seconds. */
double bench_cost(const struct bench_row *row, int by_work);

/* "left out" where a run would take too long, "failed" where it went wrong, "not applicable" where the method
 * refuses what it is asked for; NULL for none of these. */
const char *bench_outcome(const struct bench_row *row);

/* Adds to *b the rungs of one candidate, n multiples of `unit`, until two have failed or one is left out: so many
 * seconds may be spent. */
void bench_climb(const struct candidate *c, const struct experiment *e, int unit, double seconds,
                 struct bench_scene *b);

/* Fills *b in so many seconds; *e holds the scene, set up.  Runs one after the other on one thread. */
void bench_run(const struct experiment *e, double seconds, struct bench_scene *b);

/* Median and extremes of `count` times, which are sorted. */
struct bench_time bench_summary(double *seconds, int count);

/* a/b: of the medians, and from the least to the most that the extremes allow. */
struct bench_time bench_ratio(struct bench_time a, struct bench_time b);

#endif
