/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Boundedness, conservation and monotonicity after 10^7 steps.
 *
 * Each step rounds every temperature by at most eps/2 of it, and the sum over its neighbours by a few eps more if
 * terms cancel.  Errors of one sign would change the heat by about n_steps eps; random errors by sqrt(n_steps)
 * eps. */
#include "verification/stability/long_run.h"

#include "solver/time/stepper.h"

#include <math.h>
#include <stdlib.h>

enum { LOOK = 10000, PARTICLES = 32 };

static double heat(const double *T, size_t n, double *largest) {
    long double sum = 0;
    *largest = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        sum += T[i];
        if (T[i] > *largest || isnan(T[i])) *largest = T[i];
    }
    return (double)(sum / (long double)n);
}

int long_run_measure(const struct model_problem *given, double F, long long steps, struct long_run *e,
                     struct failure *why) {
    struct model_problem b = *given;
    struct heat_operator a;
    b.n = PARTICLES;
    b.insulated = 1;
    struct problem p = model_problem_setup(&b, MODEL_NOISE, 0);
    if (model_problem_operator(&b, &p, &a, why)) return why->status;
    double *T = xcalloc(a.state, sizeof *T), before, largest;
    for (size_t i = 0; i < a.n; i++) T[i] = 1.5 + p.initial(&p, (double[2]){(double)i, 0}) / 2;
    double start = heat(T, a.n, &before);
    int status = STATUS_OK;
    *e = (struct long_run){.rise = -INFINITY};
    for (; e->steps < steps && !status; e->steps += LOOK) {
        struct march m = {
            .stepper = b.step.stepper, .time = F * LOOK, .steps = LOOK, .stages = b.step.stages, .lo = 1, .hi = 2};
        size_t bytes = 0;
        status = stepper_march(&a, &m, T, &bytes, why);
        e->mean = heat(T, a.n, &largest);
        e->rise = fmax(e->rise, largest - before);
        before = largest;
    }
    e->largest = before;
    e->drift = (e->mean - start) / start;
    free(T);
    operator_free(&a);
    return status;
}
