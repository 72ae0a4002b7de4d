/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_ENGINE_H
#define HEATLADDER_VERIFICATION_BENCH_ENGINE_H

/* Throughput of the hot loops, beside the memory bandwidth of the machine. */

enum { BENCH_ENGINE_MOST = 18 };

struct bench_engine_row {
    char what[96];
    const char *unit;
    double value, lowest, highest; /* median and extremes */
    double aim;                    /* NaN for none */
    int at_most;                   /* 1: value <= aim is wanted; 0: value >= aim */
};

struct bench_engine {
    double coarser; /* factor of all spacings; 1 for the rows as they read */
    int count;
    struct bench_engine_row row[BENCH_ENGINE_MOST];
};

/* Fills *e, one measurement after the other, at spacings that are so many times coarser than its rows say: 1 is the
 * benchmark, of half a minute or so. */
void bench_engine_run(struct bench_engine *e, double coarser);

/* 1 where the row has no aim or holds it. */
int bench_engine_holds(const struct bench_engine_row *row);

#endif
