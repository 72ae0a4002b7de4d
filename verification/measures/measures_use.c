/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What users rely on, as gates: that a part stands for the whole, that the time error asked for is met and not by
 * far more than was asked. */
#include "verification/measures/measures.h"

#include "verification/run/symmetry.h"
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
