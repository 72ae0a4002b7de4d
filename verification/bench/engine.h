/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_ENGINE_H
#define HEATLADDER_VERIFICATION_BENCH_ENGINE_H

/* Throughput of the hot loops compared with the memory bandwidth of the machine. */

enum { BENCH_ENGINE_MOST = 18 };

struct bench_engine_row {
    char what[96];
    const char *unit;
    double value, lowest, highest; /* median and extremes */
    double aim;                    /* NaN: none */
    int at_most;                   /* 1: the target is value <= aim; 0: value >= aim */
};

struct bench_engine {
    double coarser; /* factor of all spacings; 1 for the rows as written */
    int count;
    struct bench_engine_row row[BENCH_ENGINE_MOST];
};

/* Fills *e with one measurement after another, at spacings multiplied by `coarser`: 1 is the benchmark, which takes
 * about half a minute. */
void bench_engine_run(struct bench_engine *e, double coarser);

/* 1 if the row has no target or meets it. */
int bench_engine_holds(const struct bench_engine_row *row);

#endif
