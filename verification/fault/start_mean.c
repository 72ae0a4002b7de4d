/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the numbers of a code are point values or cell means: its answer at the start, compared with dx^2/24
 * laplace(T) of the initial data. */
#include "verification/fault/diagnosis.h"

#include "solver/field.h"
#include "verification/fault/fit.h"

#include <math.h>

/* dx^2/24 laplace(T) of the initial data, K, by differences within the cell; NAN next to a side. */
static double start_mean(const struct problem *p, const struct diagnosis_rung *r, size_t i) {
    const double d = r->dx / 8;
    double at[DIM_MAX], sum = 0;
    field_place(r->field, i, at);
    for (int a = 0; a < p->dim; a++) {
        double above[DIM_MAX] = {at[0], at[1], at[2]}, below[DIM_MAX] = {at[0], at[1], at[2]};
        above[a] += d, below[a] -= d;
        if (below[a] < p->lo[a] || above[a] > p->hi[a]) return NAN;
        sum += p->initial(p, above) - 2 * p->initial(p, at) + p->initial(p, below);
    }
    return r->dx * r->dx / 24 * sum / (d * d);
}

double diagnosis_mean(const struct problem *p, const struct diagnosis_rung *start) {
    double ee = 0, em = 0, mm = 0;
    if (p->materials > 1 || p->jumps[0] + p->jumps[1] + p->jumps[2] > 0 || p->source) return NAN;
    for (size_t i = 0; i < start->field->n; i++) {
        double e = start->field->T[i] - start->exact[i], m = start_mean(p, start, i);
        if (isfinite(e) && isfinite(m)) ee += e * e, em += e * m, mm += m * m;
    }
    return mm > 0 && ee - em * em / mm <= (1 - FIT_SHARE) * fmax(ee, mm) ? em / mm : NAN;
}
