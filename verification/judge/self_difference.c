/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time errors from differences of runs.
 *
 * With T(dt) = T_0 + C dt^p on one grid two successive runs differ by
 *
 *     d_i = |T_i - T_(i+1)| = |C| (dt_i^p - dt_(i+1)^p)
 *
 * without the spatial error, which is the same in both.  The time error of run i is thus, by Richardson (1911),
 *
 *     |C| dt_i^p = d_i / (1 - (dt_(i+1) / dt_i)^p)
 *
 * The required p is the resulting slope: a fixed point, found by repeating the fit.  With one finer run as the
 * reference, its step replaces dt_(i+1). */
#include "verification/judge/self_difference.h"

#include "solver/field.h"
#include "verification/judge/ladder.h"
#include "verification/judge/norms.h"
#include "verification/case/experiment.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdlib.h>

enum { FITS = 30 };
static const double LEAST = 0.05; /* smallest significant order */

struct place {
    double x[DIM_MAX], T, w;
    size_t i;
};

static int by_place(const void *a, const void *b) {
    const struct place *p = a, *q = b;
    int k = 0;
    while (k < DIM_MAX - 1 && p->x[k] == q->x[k]) k++;
    return (p->x[k] > q->x[k]) - (p->x[k] < q->x[k]);
}

/* The points in sorted order, since an external program may write them in any. */
static struct place *sorted(const struct field *f) {
    struct place *at = xcalloc(f->n, sizeof *at);
    for (size_t i = 0; i < f->n; i++) {
        field_place(f, i, at[i].x);
        at[i].T = f->T[i], at[i].w = f->weight ? f->weight[i] : 1, at[i].i = i;
    }
    qsort(at, f->n, sizeof *at, by_place);
    return at;
}

static int on_one_grid(const struct problem *p, const struct place *a, const struct place *b, size_t n) {
    for (size_t i = 0; i < n; i++)
        for (int d = 0; d < p->dim; d++)
            if (fabs(a[i].x[d] - b[i].x[d]) > 1e-9 * (p->hi[d] - p->lo[d])) return 0;
    return 1;
}

static void measure(const struct place *a, const struct place *b, size_t n, double apart[NORM_QUANTITY]) {
    struct field f = {.n = n, .T = xcalloc(n, sizeof *f.T), .weight = xcalloc(n, sizeof *f.weight)};
    double *exact = xcalloc(n, sizeof *exact);
    for (size_t i = 0; i < n; i++) f.T[i] = a[i].T, exact[i] = b[i].T, f.weight[i] = b[i].w;
    norms_all(&f, exact, NULL, apart);
    free(exact);
    free(f.weight);
    free(f.T);
}

/* The field that rung i is measured against: that of --fine, or that of the next rung. */
static int reference_of(const struct ladder *l, int i) {
    return l->fine > 0 ? l->n : i + 1;
}

/* Factor of the difference between runs at dt and at a finer step.  A program that chooses its own step runs twice
 * at the same one; the difference is then an error as it is. */
static double extrapolated(double dt, double finer, double p) {
    return finer < dt ? 1 / (1 - pow(finer / dt, p)) : 1;
}

/* dt: of the rungs, and at l->n of the last field. */
static void extrapolate(struct ladder *l, const double *dt) {
    double p = 1, d[RUNG_MAX], error[RUNG_MAX];
    for (int i = 0; i < l->n; i++) error[i] = d[i] = l->rung[i].error[NORM_L1];
    for (int fit = 0; fit < FITS; fit++) {
        for (int i = 0; i < l->n; i++) error[i] = d[i] * extrapolated(dt[i], dt[reference_of(l, i)], p);
        double next = slope_fit(dt, error, l->n).value;
        if (!(isfinite(next) && next > LEAST)) break;
        p = next;
    }
    for (int i = 0; i < l->n; i++) {
        double more = extrapolated(dt[i], dt[reference_of(l, i)], p);
        for (int k = 0; k < NORM_QUANTITY; k++) l->rung[i].error[k] *= more;
        l->x[i] = dt[i];
    }
}

int self_difference_fields(const struct problem *p, const struct field *a, const struct field *b,
                           double apart[NORM_QUANTITY]) {
    struct place *at = sorted(a), *of = sorted(b);
    int same = a->n == b->n && on_one_grid(p, at, of, a->n);
    if (same) measure(at, of, a->n, apart);
    free(at);
    free(of);
    return same;
}

void self_difference_other(const struct field *a, const struct field *b, double *T) {
    struct place *at = sorted(a), *of = sorted(b);
    for (size_t k = 0; k < a->n; k++) T[at[k].i] = of[k].T;
    free(at);
    free(of);
}

int self_difference_errors(const struct problem *p, const struct field *field, const double *dt, struct ladder *l,
                           struct failure *why) {
    for (int i = 0; i < l->n; i++) {
        int of = reference_of(l, i), fine = l->fine > 0;
        if (!self_difference_fields(p, &field[i], &field[of], l->rung[i].error))
            return refuse(
                why, STATUS_INPUT,
                "a ladder in time needs all runs on one grid: at %g s the points differ from those of %s%g s",
                dt[fine ? i : of], fine ? "--fine " : "", dt[fine ? of : i]);
        l->rung[i].reference_error = 0;
    }
    l->self_differences = 1;
    extrapolate(l, dt);
    return STATUS_OK;
}
