/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What users rely on, as gates: that a part stands for the whole, that plans are kept, that an error asked for is met
 * and not by far more than was asked. */
#include "verification/measures/measures.h"

#include "verification/choose/choose.h"
#include "verification/run/symmetry.h"
#include "verification/choose/plan.h"
#include "verification/command/request.h"
#include "verification/run/run.h"

#include <math.h>
#include <stdlib.h>

/* The error beside it: how far the two fields are apart, K. */
void measures_symmetry(const struct request *r, double lo, double hi, struct measured *m) {
    const struct experiment *e = &r->experiment;
    struct options whole = e->options;
    struct field a = {0}, b = {0};
    struct failure why = {0};
    whole.domain = DOMAIN_WHOLE;
    int status = symmetry_solve(e->method, &e->problem, &e->options, &a, &why);
    if (!status) status = symmetry_solve(e->method, &e->problem, &whole, &b, &why);
    measures_fail(m, &why);
    if (!status) {
        measures_judge(m, (double)b.cost.updates / (double)a.cost.updates, lo, hi);
        m->error = a.n == b.n ? field_farthest(&a, b.T) : NAN;
    }
    field_free(&a);
    field_free(&b);
}

/* The error beside it: bytes, steps and particles that were planned and are not, or the other way round. */
void measures_plan(const struct request *r, double lo, double hi, struct measured *m) {
    struct plan plan;
    struct result result;
    struct failure why = {0};
    int status = plan_make(&r->experiment, PLAN_RUN, &plan, &why);
    measures_fail(m, &why);
    if (status) return;
    if (measures_run(&r->experiment, &result, NULL, m)) return;
    const struct field *run = &plan.part.run;
    measures_judge(m, (double)run->cost.updates / (double)result.cost.updates, lo, hi);
    m->error = fabs((double)plan.part.bytes[OUTLINE_STEPS] - (double)result.cost.bytes) +
               fabs((double)(run->steps - result.steps)) + fabs((double)plan.particles - (double)result.particles);
}

void measures_time_error(const struct request *r, double lo, double hi, struct measured *m) {
    struct experiment exact = r->experiment;
    struct result result;
    struct field reference;
    exact.time_error = 0;
    exact.options.stepper = STEPPER_EXACT;
    if (measures_run(&exact, &result, &reference, m)) return;
    int status = run_against(&r->experiment, reference.T, 0, &result);
    measures_fail(m, &result.failure);
    if (!status) measures_judge(m, result.error.l1 / r->experiment.time_error, lo, hi);
    field_free(&reference);
}

void measures_choose(const struct request *r, double lo, double hi, struct measured *m) {
    struct choose *c = xcalloc(1, sizeof *c);
    struct failure why = {0};
    int status = choose_run(&r->experiment, r->error, choose_work_max, c, &why);
    measures_fail(m, &why);
    if (!status) measures_judge(m, fmax(c->proof.error.l1, c->between) / r->error, lo, hi);
    free(c);
}
