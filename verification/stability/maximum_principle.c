/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maximum principle: from the weights, and from runs.
 *
 * An impulse of 1 K exposes a negative weight w_j in one step: T_j = dt w_j.  Runs of 2, 4, ... 32 steps check later
 * times. */
#include "verification/stability/maximum_principle.h"

#include "verification/stability/symbol.h"

#include <math.h>

double maximum_principle_h(int k) {
    return 0.6 + 2.4 * k / (MAXIMUM_COUNT - 1);
}

static int run(const struct model_problem *b, double F, long long steps, double *undershoot, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_IMPULSE, 0);
    struct options o = b->options;
    struct field f;
    p.t_end = F * (double)steps;
    o.dt = F;
    if (method_solve(b->method, &p, &o, &f, why)) return why->status;
    for (size_t i = 0; i < f.n; i++) *undershoot = fmax(*undershoot, fmax(-f.T[i], f.T[i] - 1));
    field_free(&f);
    return STATUS_OK;
}

int maximum_principle_find(const struct model_problem *given, double h, struct maximum_principle *x,
                           struct failure *why) {
    struct model_problem b = *given;
    struct symbol s;
    *x = (struct maximum_principle){0};
    b.options.h = h;
    b.n = 0;
    if (model_problem_resolve(&b, 15, why) || symbol_create(&s, &b, why)) return why->status;
    x->lowest = symbol_lowest(&s);
    double F = 0.9 / fabs(symbol_weight(&s, 0, 0, 0));
    symbol_free(&s);
    int status = STATUS_OK;
    for (long long steps = 1; steps <= 32 && !status; steps *= 2) status = run(&b, F, steps, &x->undershoot, why);
    return status;
}
