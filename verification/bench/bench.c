/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The benchmark of a scene.  A rung is run once to warm up and to measure its error, then BENCH_RUNS times for the
 * median time.  Each candidate gets an equal share of the remaining seconds.  It climbs while the predicted time of
 * the next rung, the time of the last rung times the expected growth, fits into its share.  The coarsest rung always
 * runs, except for many steps of a given length.  A rung that fails or is left out is kept with its reason. */
#include "verification/bench/bench.h"

#include "solver/time/stepper.h"
#include "verification/text/progress.h"
#include "verification/solve/experiment.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <omp.h>
#include <string.h>

/* Particles along x, by dimension. */
static const int COARSEST[DIM_MAX + 1] = {0, 32, 16, 8}, FINEST[DIM_MAX + 1] = {0, 4096, 640, 160};
enum { FAILURES = 2 };

struct bench_time bench_summary(double *seconds, int count) {
    gsl_sort(seconds, 1, (size_t)count);
    return (struct bench_time){seconds[count / 2], seconds[0], seconds[count - 1]};
}

struct bench_time bench_ratio(struct bench_time a, struct bench_time b) {
    return (struct bench_time){a.median / b.median, a.lowest / b.highest, a.highest / b.lowest};
}

static double time_once(const struct candidate *c, const struct experiment *e, int n) {
    struct field f = {0};
    struct failure why;
    double start = omp_get_wtime();
    int status = candidate_solve(c, e, n, &f, &why);
    double seconds = omp_get_wtime() - start;
    field_free(&f);
    return status ? NAN : seconds;
}

static struct bench_time time_runs(const struct candidate *c, const struct experiment *e, int n) {
    double seconds[BENCH_RUNS];
    for (int k = 0; k < BENCH_RUNS; k++) seconds[k] = time_once(c, e, n);
    return bench_summary(seconds, BENCH_RUNS);
}

/* Explicit steps proportional to dx^2 cost N^(1 + 2/d); n steps of sqrt(n) stages N^(1 + 3/(2d)); one step of n
 * polynomial updates N^(1 + 1/d); transforms N. */
static double expected_growth(const struct candidate *c, int dim) {
    const struct stepper *s = stepper_of(c->options.stepper);
    if (c->options.dt > 0 || (s && s->evolve)) return 1;
    if (s && s->count) return s->order ? 1 + 1.5 / dim : 1 + 1.0 / dim;
    return 1 + 2.0 / dim;
}

/* Predicted seconds of all runs of the coarsest rung: 1 ns per update for a given step; otherwise nothing is
 * predicted. */
static double coarsest_seconds(const struct candidate *c, const struct experiment *e, int n) {
    const double UPDATE = 1e-9;
    if (c->options.dt == 0) return 0;
    return (BENCH_RUNS + 1) * UPDATE * pow(n, e->problem.dim) * e->problem.t_end / c->options.dt;
}

static void leave_out(const struct candidate *c, const struct experiment *e, double seconds, double left,
                      struct bench_row *row) {
    struct result *out = &row->result;
    *out = (struct result){.scene = e->scene, .method = method_find(c->method), .t_end = e->problem.t_end};
    out->options = candidate_options(c, e, row->n);
    refuse(&out->failure, STATUS_NOT_APPLICABLE, "%d times %.2g s predicted, %.2g s are left", BENCH_RUNS + 1,
           seconds / (BENCH_RUNS + 1), left);
    row->left_out = 1;
}

void bench_climb(const struct candidate *c, const struct experiment *e, int unit, double seconds,
                 struct bench_scene *b) {
    const int dim = e->problem.dim;
    int failures = 0, rungs = 0, before = 0;
    double begin = omp_get_wtime(), took = 0;
    for (double at = COARSEST[dim]; at <= FINEST[dim] && rungs < BENCH_RUNGS; at *= 2) {
        int n = candidate_member(at, unit);
        if (n == before || b->count == BENCH_ROWS) continue;
        double predicted =
            before ? took * pow((double)n / before, dim * expected_growth(c, dim)) : coarsest_seconds(c, e, n);
        before = n;
        struct bench_row *row = &b->row[b->count++];
        *row = (struct bench_row){.candidate = c, .n = n};
        double start = omp_get_wtime(), left = seconds - (start - begin);
        if (predicted > 0 && predicted > left) {
            leave_out(c, e, predicted, left, row);
            return;
        }
        if (candidate_run(c, e, n, &row->result)) {
            if (++failures == FAILURES) return;
            continue;
        }
        rungs++;
        row->work = row->result.cost.work;
        row->time = time_runs(c, e, n);
        took = omp_get_wtime() - start;
    }
}

const char *bench_outcome(const struct bench_row *row) {
    int status = row->result.failure.status;
    if (row->left_out) return "left out";
    return status == STATUS_OK ? NULL : status_refused(status) ? "not applicable" : "failed";
}

double bench_cost(const struct bench_row *row, int by_work) {
    return by_work ? row->work : row->time.median;
}

/* Whether no other row is at least as good in both quantities and better in one. */
static int on_front(const struct bench_scene *b, const struct bench_row *row, int by_work) {
    double error = row->result.error.l1, cost = bench_cost(row, by_work);
    if (row->result.failure.status) return 0;
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *other = &b->row[i];
        if (other->result.failure.status || other == row) continue;
        double e = other->result.error.l1, w = bench_cost(other, by_work);
        if (e <= error && w <= cost && (e < error || w < cost)) return 0;
    }
    return 1;
}

void bench_run(const struct experiment *e, double seconds, struct bench_scene *b) {
    int unit = candidate_unit(&e->problem);
    *b = (struct bench_scene){.scene = e->scene};
    int count = 0;
    while (candidates_table[count].label) count++;
    double begin = omp_get_wtime();
    int left = count;
    struct progress progress = progress_start("candidates", count);
    for (const struct candidate *c = candidates_table; c->label && unit; c++, left--) {
        if (!c->dim || c->dim == e->problem.dim)
            bench_climb(c, e, unit, (seconds - (omp_get_wtime() - begin)) / left, b);
        progress_tick(&progress);
    }
    progress_end(&progress);
    for (int i = 0; i < b->count; i++) {
        b->row[i].front_time = on_front(b, &b->row[i], 0);
        b->row[i].front_work = on_front(b, &b->row[i], 1);
    }
}
