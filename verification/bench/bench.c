/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The benchmark of a scene.  A rung is run once to warm up and to measure its error, then BENCH_RUNS times for the
 * median time.  Each candidate gets an equal share of the remaining seconds.  It climbs while the predicted time of
 * the next rung, the time of the last rung times the expected growth, fits into its share.  The coarsest rung always
 * runs, except for many steps of a given length.  A rung that fails or is left out is kept with its reason. */
#include "verification/bench/bench.h"

#include "solver/time/stepper.h"
#include "verification/judge/run.h"
#include "verification/case/experiment.h"
#include "verification/solve/symmetry.h"
#include "verification/text/progress.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <omp.h>
#include <string.h>

/* ---- Candidates ---- */

/* In the order of struct candidate, the options last. */
#define CANDIDATE(label, method, dim, steps, ...)                                                                    \
    { label, method, {__VA_ARGS__}, dim, steps, BENCH_LONG }
#define BOTH(label, method, dim, ...)                                                                                \
    { label, method, {__VA_ARGS__}, dim, 0, BENCH_BOTH }
#define BRIEF(method)                                                                                                \
    { method " exact", method, {EXACT}, 0, 0, BENCH_BRIEF }
#define EXACT .stepper = STEPPER_EXACT
#define EULER .stepper = STEPPER_EULER
#define RKL2 .stepper = STEPPER_RKL2
#define CHEBYSHEV .stepper = STEPPER_CHEBYSHEV
#define MATCHED .stepper = STEPPER_MATCHED
#define SPLINE .sampling = SAMPLING_SPLINE
#define CELL .sampling = SAMPLING_CELL
#define QUARTIC .kernel = KERNEL_QUARTIC
#define WENDLAND .kernel = KERNEL_WENDLAND
#define SERIES .mean = MEAN_SERIES
#define JITTER .layout = LAYOUT_JITTER, .jitter = 0.2
/* Other operators have larger errors for the same work on a lattice (gates/gates.def). */
const struct candidate bench_candidates[] = {
    BOTH("so_ssph matched, cubic kernel", "so_ssph", 2, MATCHED, SPLINE, .h_iso = 1),
    CANDIDATE("so_ssph matched, quartic kernel", "so_ssph", 2, 0, MATCHED, SPLINE, .h_iso = 1, QUARTIC),
    BOTH("so_ssph matched, cubic kernel", "so_ssph", 1, MATCHED, SPLINE, .h = 1.05),
    CANDIDATE("so_ssph matched, cell samples", "so_ssph", 1, 0, MATCHED, CELL, .h = 1.05),
    CANDIDATE("ftcs matched", "ftcs", 1, 0, MATCHED, SPLINE),
    BOTH("so_ssph exact, h/dx 0.9", "so_ssph", 0, EXACT, .h = 0.9),
    CANDIDATE("so_ssph exact, cell samples", "so_ssph", 0, 0, EXACT, CELL),
    CANDIDATE("so_ssph exact, quartic kernel, h/dx 1.3", "so_ssph", 0, 0, EXACT, QUARTIC, .h = 1.3),
    CANDIDATE("so_ssph exact, wendland kernel, h/dx 1.3", "so_ssph", 0, 0, EXACT, WENDLAND, .h = 1.3),
    CANDIDATE("so_ssph of order 4, exact", "so_ssph", 0, 0, EXACT, .order = 4),
    BOTH("brookshaw exact", "brookshaw", 0, EXACT),
    BOTH("fatehi_manzari exact, h/dx 0.9", "fatehi_manzari", 0, EXACT, .h = 0.9),
    BOTH("ftcs at F = 1/6", "ftcs", 0, EULER, .fourier = 1.0 / 6),
    CANDIDATE("brookshaw chebyshev, series mean", "brookshaw", 0, 0, CHEBYSHEV, SERIES),
    CANDIDATE("contact_ssph chebyshev, h/dx 0.7, cell samples", "contact_ssph", 1, 0, CHEBYSHEV, CELL, .h = 0.7),
    CANDIDATE("so_ssph rkl2", "so_ssph", 0, 0.125, RKL2, CELL),
    CANDIDATE("brookshaw rkl2, series mean", "brookshaw", 0, 0.125, RKL2, SERIES),
    CANDIDATE("so_ssph rk2 at F = 0.1", "so_ssph", 0, 0, .stepper = STEPPER_RK2, .fourier = 0.1),
    CANDIDATE("so_ssph euler at F = 0.1", "so_ssph", 0, 0, EULER, .fourier = 0.1),
    CANDIDATE("so_ssph euler, dt = 5e-5 s (Song)", "so_ssph", 0, 0, EULER, .h = 1.05, .dt = 5e-5),
    CANDIDATE("so_ssph jittered by 0.2 dx, rkl2", "so_ssph", 0, 0.125, RKL2, JITTER),
    CANDIDATE("fatehi_manzari jittered by 0.2 dx, rkl2", "fatehi_manzari", 0, 0.125, RKL2, JITTER),
    BOTH("fo_ssph exact", "fo_ssph", 0, EXACT),
    BOTH("ftcs_flux at F = 0.2", "ftcs_flux", 0, EULER, .fourier = 0.2),
    BRIEF("brookshaw_corrected"),
    BRIEF("schwaiger"),
    BRIEF("cspm"),
    BRIEF("kernel_second"),
    BRIEF("flux_divergence"),
    BRIEF("conjugate"),
    BRIEF("positive"),
    BRIEF("voronoi_flux"),
    BRIEF("contact_ssph"),
    {0}};

/* Whether n square cells along x tile the domain with every jump on a face; for a round body, whether rings of the
 * same width fill it. */
static int fits(const struct problem *p, int n, int jumps) {
    double dx = (p->hi[0] - p->lo[0]) / n, rings = (p->radius[1] - p->radius[0]) / dx;
    if (p->shape && fabs(rings - nearbyint(rings)) > 1e-9 * rings) return 0;
    for (int a = 0; a < p->dim; a++) {
        double whole = (p->hi[a] - p->lo[a]) / dx;
        if (fabs(whole - nearbyint(whole)) > 1e-9 * whole) return 0;
        for (int k = 0; jumps && k < p->jumps[a]; k++) {
            double at = (p->jump[a][k] - p->lo[a]) / dx;
            if (fabs(at - nearbyint(at)) > 1e-9 * whole) return 0;
        }
    }
    double at = (p->interface - p->lo[0]) / dx;
    return p->materials == 1 || fabs(at - nearbyint(at)) <= 1e-9 * n;
}

int bench_candidate_unit(const struct problem *p) {
    for (int jumps = 1; jumps >= 0; jumps--)
        for (int n = 1; n <= CANDIDATE_UNIT_MAX; n++)
            if (fits(p, n, jumps)) return n;
    return 0;
}

int bench_candidate_member(double least, int unit) {
    return unit * (int)fmax(1, ceil(least / unit - 1e-9));
}

struct options bench_candidate_options(const struct candidate *c, const struct experiment *e, int n) {
    struct options o = c->options;
    o.dx = (e->problem.hi[0] - e->problem.lo[0]) / n;
    o.threads = e->options.threads;
    o.domain = DOMAIN_WHOLE; /* times are those of the whole scene */
    if (e->problem.shape && method_find(c->method)->scheme) o.walls = WALLS_FIT;
    if (o.stepper == stepper_without_error(0)) o.dt = e->problem.t_end; /* one step has no error in time */
    if (c->steps > 0) o.dt = e->problem.t_end / ceil(10 + c->steps * n);
    return o;
}

static struct experiment experiment_of(const struct candidate *c, const struct experiment *e, int n) {
    struct experiment with = *e;
    with.method = method_find(c->method);
    with.options = bench_candidate_options(c, e, n);
    return with;
}

int bench_candidate_run(const struct candidate *c, const struct experiment *e, int n, struct result *out) {
    struct experiment with = experiment_of(c, e, n);
    return run_experiment(&with, out, NULL);
}

int bench_candidate_solve(const struct candidate *c, const struct experiment *e, int n, struct field *f,
                          struct failure *why) {
    struct experiment with = experiment_of(c, e, n);
    return symmetry_solve(with.method, &with.problem, &with.options, f, why);
}

/* ---- Ladders ---- */

/* Particles along x, by dimension. */
static const int COARSEST[DIM_MAX + 1] = {0, 32, 16, 8}, FINEST[DIM_MAX + 1] = {0, 4096, 640, 160};
enum { FAILURES = 2 };

struct bench_time bench_summary(double *seconds, int count) {
    gsl_sort(seconds, 1, (size_t)count);
    return (struct bench_time){seconds[count / 2], seconds[0], seconds[count - 1]};
}

static double time_once(const struct candidate *c, const struct experiment *e, int n) {
    struct field f = {0};
    struct failure why;
    double start = omp_get_wtime();
    int status = bench_candidate_solve(c, e, n, &f, &why);
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
    out->options = bench_candidate_options(c, e, row->n);
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
        int n = bench_candidate_member(at, unit);
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
        if (bench_candidate_run(c, e, n, &row->result)) {
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
    double error = row->result.error[NORM_L1], cost = bench_cost(row, by_work);
    if (row->result.failure.status) return 0;
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *other = &b->row[i];
        if (other->result.failure.status || other == row) continue;
        double e = other->result.error[NORM_L1], w = bench_cost(other, by_work);
        if (e <= error && w <= cost && (e < error || w < cost)) return 0;
    }
    return 1;
}

/* 1 for a candidate of a benchmark of that length in that dimension. */
static int takes_part(const struct candidate *c, enum bench_length length, int dim) {
    return (c->in == length || c->in == BENCH_BOTH) && (!c->dim || c->dim == dim);
}

void bench_run(const struct experiment *e, enum bench_length length, double seconds, struct bench_scene *b) {
    int unit = bench_candidate_unit(&e->problem);
    *b = (struct bench_scene){.scene = e->scene};
    int count = 0;
    for (const struct candidate *c = bench_candidates; c->label; c++) count += takes_part(c, length, e->problem.dim);
    double begin = omp_get_wtime();
    int left = count;
    struct progress progress = progress_start("candidates", count);
    for (const struct candidate *c = bench_candidates; c->label && unit; c++) {
        if (!takes_part(c, length, e->problem.dim)) continue;
        bench_climb(c, e, unit, (seconds - (omp_get_wtime() - begin)) / left--, b);
        progress_tick(&progress);
    }
    progress_end(&progress);
    for (int i = 0; i < b->count; i++) {
        b->row[i].front_time = on_front(b, &b->row[i], 0);
        b->row[i].front_work = on_front(b, &b->row[i], 1);
    }
}
