/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The part of a symmetric problem gives the field of the whole. */
#include "verification/measures/measures.h"

#include "verification/run/symmetry.h"
#include "verification/command/request.h"

#include <math.h>

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
