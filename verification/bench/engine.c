/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Throughput of the engine.  The triad a = b + s c moves 24 bytes per element through memory (McCalpin 1995).  An
 * update that reads and writes one double moves 16, so that a sweep out of cache cannot exceed triad/16 updates per
 * second unless several steps share a sweep.  A row of the sparse operator moves 12 bytes per entry and about 40 per
 * particle, once for all updates that share a sweep. */
#include "verification/bench/engine.h"

#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/sweep/state.h"
#include "verification/judge/command.h"
#include "verification/bench/bench.h"
#include "verification/text/progress.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum { TRIAD = 1 << 23 }; /* doubles of each array: 64 MiB */

static void add(struct bench_engine *e, const char *what, const char *unit, struct bench_time t, double aim,
                int at_most) {
    struct bench_engine_row *row = &e->row[e->count++];
    *row = (struct bench_engine_row){"", unit, t.median, t.lowest, t.highest, aim, at_most};
    snprintf(row->what, sizeof row->what, "%s", what);
}

static struct bench_time constant(double value) {
    return (struct bench_time){value, value, value};
}

/* Adds the rate of a row that takes t seconds for `count` items. */
static void add_rate(struct bench_engine *e, const char *what, const char *unit, double count, struct bench_time t) {
    add(e, what, unit, bench_ratio(constant(count), t), NAN, 0);
}

/* Seconds of one triad. */
static struct bench_time triad(void) {
    double *a = xcalloc(TRIAD, sizeof *a), *b = xcalloc(TRIAD, sizeof *b), *c = xcalloc(TRIAD, sizeof *c);
    double seconds[BENCH_RUNS], sum = 0;
    for (int i = 0; i < TRIAD; i++) a[i] = 0, b[i] = i, c[i] = 1;
    for (int k = 0; k < BENCH_RUNS; k++) {
        double s = 1 + k, start = omp_get_wtime();
        for (int i = 0; i < TRIAD; i++) a[i] = b[i] + s * c[i];
        seconds[k] = omp_get_wtime() - start;
        sum += a[k]; /* prevents the compiler from removing a triad */
    }
    free(a);
    free(b);
    free(c);
    if (sum < 0) return (struct bench_time){NAN, NAN, NAN};
    return bench_summary(seconds, BENCH_RUNS);
}

/* Seconds per update of one particle in the time loop of the command. */
static struct bench_time update(const struct bench_engine *e, const char *command) {
    struct command r;
    struct failure why;
    struct bench_time none = {NAN, NAN, NAN};
    double seconds[BENCH_RUNS];
    int status = command_read(command, &r, &why);
    r.experiment.options.dx *= e->coarser;
    for (int k = -1; k < BENCH_RUNS && !status; k++) {
        struct field f;
        status = method_solve(r.experiment.method, &r.experiment.problem, &r.experiment.options, &f, &why);
        if (status) break;
        if (k >= 0) seconds[k] = f.cost.step_seconds / (double)f.cost.updates;
        field_free(&f);
    }
    command_free(&r);
    return status ? none : bench_summary(seconds, BENCH_RUNS);
}

/* 1000 applications each: Euler steps, and steps of 7 stages. */
#define FTCS_160 "run square-step ftcs --dx 4/160 --fourier 0.2 --t-end 12.5"
#define EULER_160 "run square-step so_ssph --stepper euler --dx 4/160 --fourier 0.2 --t-end 12.5"
#define RKL2_160 "run square-step so_ssph --stepper rkl2 --dx 4/160 --dt 0.25 --t-end 35.5"

static void in_cache(struct bench_engine *e) {
    struct bench_time ftcs = update(e, FTCS_160), so = update(e, EULER_160), rkl2 = update(e, RKL2_160);
    struct bench_time walls = update(e, "run plate so_ssph --stepper euler --dx 0.1/160 --fourier 0.2 --t-end 5");
    add_rate(e, "ftcs, 160 x 160", "updates/s", 1, ftcs);
    add_rate(e, "so_ssph euler, 160 x 160", "updates/s", 1, so);
    add_rate(e, "so_ssph rkl2, 160 x 160", "updates/s", 1, rkl2);
    add_rate(e, "so_ssph euler, 160 x 160, walls that hold temperatures", "updates/s", 1, walls);
    add(e, "so_ssph over ftcs, updates a second, 160 x 160", "", bench_ratio(ftcs, so), 0.5, 0);
    add(e, "a step of so_ssph in steps of ftcs, 160 x 160", "", bench_ratio(so, ftcs), 3, 1);
}

#define OUT_OF_CACHE " --dx 4/2560 --fourier 0.2 --t-end 0.0031"

static void out_of_cache(struct bench_engine *e, double bandwidth) {
    struct bench_time ftcs = update(e, "run square-step ftcs" OUT_OF_CACHE);
    struct bench_time so = update(e, "run square-step so_ssph --stepper euler" OUT_OF_CACHE);
    add_rate(e, "ftcs, 2560 x 2560", "updates/s", 1, ftcs);
    add_rate(e, "so_ssph euler, 2560 x 2560", "updates/s", 1, so);
    add(e, "so_ssph over triad/16 B, 2560 x 2560", "", bench_ratio(constant(16 / bandwidth), so), 0.7, 0);
    add(e, "ftcs over triad/16 B, 2560 x 2560", "", bench_ratio(constant(16 / bandwidth), ftcs), NAN, 0);
}

/* Seconds per update of the operator a, in batches of eight as a march issues them. */
static struct bench_time apply(const struct heat_operator *a) {
    enum { UPDATES = 8 };
    struct update u[UPDATES];
    double *x = xcalloc(a->state, sizeof *x), *y = xcalloc(a->state, sizeof *y), seconds[BENCH_RUNS];
    for (size_t i = 0; i < a->state; i++) x[i] = (double)(i % 7);
    for (int k = 0; k < UPDATES; k++) u[k] = (struct update){.rate = 1e-9, .self = 1};
    for (int k = -1; k < BENCH_RUNS; k++) {
        double start = omp_get_wtime();
        state_update(a, u, UPDATES, (double *[2]){x, y});
        if (k >= 0) seconds[k] = (omp_get_wtime() - start) / UPDATES;
    }
    free(x);
    free(y);
    return bench_summary(seconds, BENCH_RUNS);
}

/* Builds the rows of a run and measures the seconds: particles, dummy particles and all weights. */
static int set_up(const struct bench_engine *engine, const char *command, struct heat_operator *a, double *seconds) {
    struct command r;
    struct failure why;
    struct options o;
    struct lattice l;
    struct cloud c;
    int rows, status = command_read(command, &r, &why);
    const struct experiment *e = &r.experiment;
    double start = omp_get_wtime();
    r.experiment.options.dx *= engine->coarser;
    if (!status) status = particles_prepare(&e->problem, &e->options, e->method->scheme, &o, &l, &rows, &why);
    if (!status) status = particles_cloud(&e->problem, &o, e->method->scheme, &l, &c, &why);
    if (!status) {
        status = operator_create_csr(a, &e->problem, &o, e->method->scheme, &c, l.dx[0], &why);
        *seconds = omp_get_wtime() - start;
        layout_cloud_free(&c);
    }
    command_free(&r);
    return status;
}

static void cloud(struct bench_engine *e, double bandwidth) {
    struct heat_operator a;
    double seconds;
    if (set_up(e, "run square-step so_ssph --layout jitter --jitter 0.2 --dx 4/1000 --h 1.1", &a, &seconds)) return;
    struct bench_time t = apply(&a);
    double bytes = 12 * (double)a.row[a.n] + 40 * (double)a.n;
    add(e, "assembly of 10^6 jittered particles", "s", constant(seconds), 10, 1);
    add(e, "bytes a particle of its rows", "", constant((double)a.bytes / (double)a.n), 1200, 1);
    add_rate(e, "its updates", "updates/s", (double)a.n, t);
    add(e, "time of its update over that of its traffic at the triad's bandwidth", "",
        bench_ratio(t, constant(bytes / bandwidth)), 1.5, 1);
    operator_free(&a);
}

/* Measures the set-up of 10^6 particles between two set-ups of another kind. */
static void set_up_beside(struct bench_engine *e, const char *command, const char *what, const char *other,
                          const char *over) {
    const char *const turn[] = {other, command, other};
    double seconds[3] = {NAN, NAN, NAN};
    for (int k = 0; k < 3; k++) {
        struct heat_operator a;
        if (set_up(e, turn[k], &a, &seconds[k])) break;
        operator_free(&a);
    }
    struct bench_time own = constant(seconds[1]), others = bench_summary((double[]){seconds[0], seconds[2]}, 2);
    others.median = (seconds[0] + seconds[2]) / 2;
    add(e, what, "s", own, NAN, 0);
    add(e, over, "", bench_ratio(own, others), 2, 1);
}

/* A cell is clipped by about 20 bisectors; a row of so_ssph sums 15 outer products of 5 terms and factors a
 * matrix. */
static void cells(struct bench_engine *e) {
    set_up_beside(e, "run square-step voronoi_flux --layout jitter --jitter 0.2 --dx 4/1000",
                  "set-up of 10^6 Voronoi cells",
                  "run square-step so_ssph --layout jitter --jitter 0.2 --dx 4/1000 --h 1.1",
                  "that over the set-up of so_ssph");
}

int bench_engine_holds(const struct bench_engine_row *row) {
    if (isnan(row->aim)) return 1;
    return row->at_most ? row->value <= row->aim : row->value >= row->aim;
}

void bench_engine_run(struct bench_engine *e, double coarser) {
    *e = (struct bench_engine){.coarser = coarser};
    struct bench_time t = triad();
    double bandwidth = 24.0 * TRIAD / t.lowest; /* as STREAM reports it: the best run */
    add_rate(e, "triad, one thread", "bytes/s", 24.0 * TRIAD, t);
    struct progress progress = progress_start("parts of the engine", 4);
    progress_tick(&progress);
    in_cache(e);
    progress_tick(&progress);
    out_of_cache(e, bandwidth);
    progress_tick(&progress);
    cloud(e, bandwidth);
    progress_tick(&progress);
    cells(e);
    progress_end(&progress);
    t = triad();
    add(e, "the best triad at the end, over that at the start", "", constant(24.0 * TRIAD / t.lowest / bandwidth),
        NAN, 0);
}
