/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The number of time steps that a search ends at, extrapolated from two coarse searches.
 *
 * Runs of N steps at spacing dx have the error of space S = C dx^q and the time error K / N^p, p the stepper's order
 * and K a property of what is solved, which dx hardly changes.  Both are carried on along the line through the two
 * runs, in log S and log K over log dx. */
#include "verification/choose/plan.h"

#include "verification/run/experiment.h"
#include "verification/run/run.h"
#include "verification/run/time_step.h"

#include <math.h>

enum { COARSEST = 8, MULTIPLES = 4096 };        /* particles: least along an axis of a coarser run; multiples of dx */
static const double SMALL[3] = {0, 1000, 2500}; /* particles of a quick run, by dimension */
static const double QUICK = 2e7;                /* updates of its first trial */

struct rung {
    double dx, time, space; /* m; K; S */
};

static double least_along(const struct problem *p, double dx) {
    double least = INFINITY;
    for (int a = 0; a < p->dim; a++) least = fmin(least, (p->hi[a] - p->lo[a]) / dx);
    return least;
}

double plan_steps_particles(const struct problem *p, double dx) {
    double n = 1;
    for (int a = 0; a < p->dim; a++) n *= (p->hi[a] - p->lo[a]) / dx;
    return n;
}

static int is_quick(const struct experiment *e, double dx) {
    struct experiment with = *e;
    with.options.dx = dx;
    double n = plan_steps_particles(&e->problem, dx);
    return n <= SMALL[e->problem.dim] && n * time_step_first(&with) <= QUICK;
}

/* How far a plane is from the nearest wall of a cell, in dx. */
static double phase(double plane, double lo, double dx) {
    return fabs(remainder((plane - lo) / dx, 1));
}

/* Whether jumps lie between the particles as they do at dx: their error depends on that. */
static int has_same_phase(const struct problem *p, double dx, double other) {
    int same =
        p->materials == 1 || fabs(phase(p->interface, p->lo[0], dx) - phase(p->interface, p->lo[0], other)) < 1e-6;
    for (int a = 0; a < p->dim; a++)
        for (int k = 0; k < p->jumps[a]; k++)
            same &= fabs(phase(p->jump[a][k], p->lo[a], dx) - phase(p->jump[a][k], p->lo[a], other)) < 1e-6;
    return same;
}

static int run(const struct experiment *e, double dx, struct rung *at, long long *steps) {
    struct experiment with = *e;
    struct result result;
    with.options.dx = dx;
    if (run_experiment(&with, &result, NULL)) return 0;
    double time = result.time_error * result.error.l1;
    *steps = result.steps;
    *at = (struct rung){dx, time * pow((double)result.steps, time_step_order(&e->options)), result.error.l1 - time};
    return dx == e->options.dx || (at->time > 0 && at->space > 0); /* nothing is carried on from dx itself */
}

/* Log-log extrapolation to dx of the values a and b of the two rungs. */
static double carried(double dx, const struct rung rung[2], double a, double b) {
    return a * pow(a / b, log(dx / rung[0].dx) / log(rung[0].dx / rung[1].dx));
}

/* The finest two multiples of dx with quick runs, from `first` on; one, where dx itself is quick. */
static struct plan_steps take_rungs(const struct experiment *e, int first, int strictly, struct rung rung[2]) {
    struct plan_steps f = {0};
    const double dx = e->options.dx, least = least_along(&e->problem, dx);
    for (double m = first; f.runs < 2 && m < MULTIPLES && (m == 1 || least / m >= COARSEST); m++) {
        long long steps;
        if (!is_quick(e, m * dx) || (f.runs == 1 && m * dx < 1.4 * rung[0].dx)) continue;
        if ((strictly && !has_same_phase(&e->problem, dx, m * dx)) || !run(e, m * dx, &rung[f.runs], &steps))
            continue;
        f.dx[f.runs++] = m * dx;
        if (m == 1) return f.steps = (double)steps, f;
    }
    return f;
}

struct plan_steps plan_steps_predict(const struct experiment *e, int first) {
    struct rung rung[2];
    struct plan_steps f = take_rungs(e, first, 1, rung);
    const double dx = e->options.dx;
    if (f.steps == 0 && f.runs < 2) f = take_rungs(e, first, 0, rung);
    if (f.steps == 0 && f.runs == 2)
        f.steps = time_step_forecast(e, plan_steps_particles(&e->problem, dx),
                                     carried(dx, rung, rung[0].time, rung[1].time),
                                     carried(dx, rung, rung[0].space, rung[1].space));
    return f;
}
