/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of an external program besides its errors. */
#include "verification/gates/measures.h"

#include "solver/field.h"
#include "verification/solve/program.h"
#include "verification/case/command.h"
#include "verification/fault/diagnose.h"
#include "verification/judge/ladder.h"
#include "verification/judge/self_difference.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void skip(struct measured *m, const char *text) {
    struct failure why;
    refuse(&why, STATUS_SKIPPED, "%s", text);
    measures_fail(m, &why);
}

/* Runs the same case twice.  Returns 1 if the answers can be compared, with their relative difference and the
 * largest |T|, K.  The second run is not kept, so that it cannot read the answer of the first. */
static int run_twice(const struct experiment *e, struct result *first, double apart[NORM_QUANTITY], double *largest,
                     struct measured *m) {
    struct experiment again = *e;
    struct result second;
    struct field a = {0}, b = {0};
    int comparable = 0;
    again.program.keep = NULL;
    if (!e->program.solver) {
        skip(m, "needs --solver: --results has one run");
    } else if (!measures_run(e, first, &a, m) && !measures_run(&again, &second, &b, m)) {
        comparable = self_difference_fields(&e->problem, &a, &b, apart);
        if (!comparable) skip(m, "the points differ from run to run");
        *largest = field_largest(&a);
    }
    field_free(&a);
    field_free(&b);
    return comparable;
}

/* If answers differ from run to run, they differ at each time step, and errors are differences of two answers. */
static void judge_noise(const struct command *r, const struct ladder *l, struct measured *m) {
    struct experiment e = r->experiment;
    struct measured tried = *m;
    double apart[NORM_QUANTITY];
    struct result first;
    struct diagnosis d;
    double largest, error = ladder_finest_error(l), ceiling = r->rungs.ceiling;
    e.options.dt = l->x[l->n - 1];
    e.program.keep = NULL;
    if (!e.program.solver || !run_twice(&e, &first, apart, &largest, &tried)) return;
    if (!(apart[NORM_L1] > JUDGE_NOISE * error) || !diagnosis_repeat(apart[NORM_LINF], largest, &d)) return;
    if (ceiling > 0 && error - 3 * apart[NORM_L1] > ceiling) return;
    measures_diagnosed(m, &d);
    snprintf(m->reason, sizeof m->reason, "%s", m->diagnosis);
    m->verdict = VERDICT_INCONCLUSIVE;
}

/* Compares the answers at the two finest rungs, where the error has its order. */
static void diagnose_steps(const struct command *r, const struct ladder *l, struct measured *m) {
    struct experiment e = r->experiment;
    struct measured tried = *m;
    struct result result[2];
    struct field f[2] = {{0}, {0}};
    int usable = e.program.solver != NULL && l->n >= 2;
    e.program.keep = NULL;
    for (int k = 0; k < 2 && usable; k++) {
        e.options.dt = l->x[l->n - 2 + k];
        usable = !measures_run(&e, &result[k], &f[k], &tried);
    }
    usable = usable && f[0].n == f[1].n;
    for (size_t i = 0; usable && i < f[0].n; i++) {
        double x[2][DIM_MAX];
        for (int k = 0; k < 2; k++) field_place(&f[k], i, x[k]);
        for (int a = 0; a < f[0].dim; a++) usable = usable && x[0][a] == x[1][a];
    }
    if (usable) {
        struct diagnosis d;
        for (size_t i = 0; i < f[0].n; i++) f[0].T[i] -= f[1].T[i];
        diagnosis_steps(&e.problem, &f[1], f[0].T, result[0].dt - result[1].dt, &d);
        measures_diagnosed(m, &d);
    }
    for (int k = 0; k < 2; k++) field_free(&f[k]);
}

/* A program with its own time step gives the same answer for every requested step: the row does not apply. */
void measures_slope_time(const struct command *r, double lo, double hi, struct measured *m) {
    struct ladder *l = xcalloc(1, sizeof *l);
    int status = measures_ladder(r, lo, hi, l, m), differ = 0;
    for (int i = 0; i < l->n; i++) differ += l->error[i] != 0;
    if (!status && !differ)
        skip(m, "the answers are the same for every dt: the program takes a time step of its own");
    else if (m->verdict != VERDICT_PASS && !l->failure.status)
        judge_noise(r, l, m);
    if (m->verdict == VERDICT_FAIL && !l->failure.status && !m->found.named) diagnose_steps(r, l, m);
    ladder_free(l);
    free(l);
}

/* A single run has few known digits; other faults are identified with a run at twice the spacing.  If runs differ,
 * or if the printed digits could account for the excess over `hi`, the error is inconclusive. */
static void diagnose(const struct command *r, const struct field *f, double hi, struct measured *m) {
    const struct experiment *e = &r->experiment;
    const double dx = e->options.dx;
    double extent = fmax(e->problem.hi[0] - e->problem.lo[0], e->problem.hi[1] - e->problem.lo[1]);
    struct ladder_rungs rungs = {.dx = {.count = 2, .value = {2 * dx, dx}}, .diagnose = 1};
    struct ladder *l = xcalloc(1, sizeof *l);
    struct failure ignored;
    struct diagnosis d = {.unit = ""};
    struct field given = program_as_given(&e->program, f, NULL);
    int digits, rounded = diagnosis_rounding(&given, m->error, extent / dx, &d);
    double printed = norms_digits(f, &e->program.map, &digits);
    if (!rounded && e->program.solver && !ladder_run(e, &rungs, l, &ignored)) diagnose_ladder(e, l, &d);
    measures_diagnosed(m, &d);
    if (l->noise.share > JUDGE_NOISE) {
        snprintf(m->reason, sizeof m->reason, "%s", m->diagnosis);
        m->verdict = VERDICT_INCONCLUSIVE;
    } else if ((rounded || !d.named) && m->error - 2 * printed <= hi) {
        snprintf(m->reason, sizeof m->reason,
                 "printed digits: %d in the file make up %.0f %% of the error; more of them show what is left",
                 digits, 100 * fmin(printed / m->error, 1));
        m->verdict = VERDICT_INCONCLUSIVE;
    }
    field_free(&given);
    ladder_free(l);
    free(l);
}

void measures_error(const struct command *r, double lo, double hi, struct measured *m) {
    const struct experiment *e = &r->experiment;
    struct result result;
    struct field f = {0};
    if (!measures_run(e, &result, &f, m)) {
        measures_judge(m, result.error[NORM_L1], lo, hi);
        if (e->external && m->verdict == VERDICT_FAIL) diagnose(r, &f, hi, m);
    }
    field_free(&f);
}

void measures_repeat(const struct command *r, double lo, double hi, struct measured *m) {
    double apart[NORM_QUANTITY];
    struct result first;
    struct diagnosis d;
    double largest;
    if (!run_twice(&r->experiment, &first, apart, &largest, m)) return;
    measures_judge(m, apart[NORM_LINF] / largest, lo, hi);
    m->error = first.error[NORM_L1];
    if (m->verdict == VERDICT_FAIL && diagnosis_repeat(apart[NORM_LINF], largest, &d)) {
        measures_diagnosed(m, &d);
        snprintf(m->reason, sizeof m->reason, "%s; where that is meant, --skip this row", m->diagnosis);
        m->verdict = VERDICT_INCONCLUSIVE;
    }
}

void measures_digits(const struct command *r, double lo, double hi, struct measured *m) {
    enum { MANY = 10 };
    struct result result;
    struct field f = {0};
    struct diagnosis d;
    if (!measures_run(&r->experiment, &result, &f, m)) {
        struct field given = program_as_given(&r->experiment.program, &f, NULL);
        int few = diagnosis_rounding(&given, 0, 1, &d);
        measures_judge(m, few ? d.size : MANY, lo, hi);
        if (few) measures_diagnosed(m, &d);
        field_free(&given);
    }
    field_free(&f);
}
