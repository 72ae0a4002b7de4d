/* The measures of gates. */
#include "verification/gates/measures.h"

#include "references/scene.h"
#include "verification/command/request.h"
#include "verification/ladder/consistency.h"
#include "verification/ladder/judge.h"
#include "verification/ladder/ladder.h"
#include "verification/gates/measures_stability.h"
#include "verification/gates/measures_use.h"
#include "verification/run/run.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void measures_fail(struct measured *m, const char *text) {
    *m = (struct measured){.value = NAN, .ci = {NAN, NAN}, .error = NAN, .verdict = VERDICT_FAIL};
    snprintf(m->reason, sizeof m->reason, "%.300s", text);
}

void measures_judge(struct measured *m, double value, double lo, double hi) {
    m->value = m->ci[0] = m->ci[1] = value;
    m->verdict = verdict_within(value, lo, hi);
    const char *where = m->verdict == VERDICT_PASS ? "lies inside"
                        : isfinite(value)          ? "lies outside"
                                                   : "is not finite;";
    snprintf(m->reason, sizeof m->reason, "%.4g %s [%g, %g]", value, where, lo, hi);
}

static void slope_in(enum ladder_norm norm, const struct request *r, double lo, double hi, struct measured *m) {
    struct failure why = {0};
    struct ladder *l = xcalloc(1, sizeof *l);
    int status = ladder_run(&r->experiment, &r->rungs, l, &why);
    measures_fail(m, why.text);
    if (!status) {
        ladder_fit(l, norm);
        ladder_judge(l, lo, hi);
        m->value = l->slope.value;
        m->ci[0] = l->slope.ci[0];
        m->ci[1] = l->slope.ci[1];
        m->verdict = l->verdict;
        snprintf(m->reason, sizeof m->reason, "%s", l->reason);
        m->error = ladder_finest_error(l);
    }
    free(l);
}

static void take_slope(const struct request *r, double lo, double hi, struct measured *m) {
    slope_in(LADDER_L1, r, lo, hi, m);
}

static void take_slope_l2(const struct request *r, double lo, double hi, struct measured *m) {
    slope_in(LADDER_L2, r, lo, hi, m);
}

static void take_slope_linf(const struct request *r, double lo, double hi, struct measured *m) {
    slope_in(LADDER_LINF, r, lo, hi, m);
}

static void take_slope_interior(const struct request *r, double lo, double hi, struct measured *m) {
    slope_in(LADDER_INTERIOR, r, lo, hi, m);
}

static void take_slope_boundary(const struct request *r, double lo, double hi, struct measured *m) {
    slope_in(LADDER_BOUNDARY, r, lo, hi, m);
}

static int by_falling_dx(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

static void take_operator_slope(const struct request *r, double lo, double hi, struct measured *m) {
    struct numbers dx = r->rungs.dx;
    struct experiment e = r->experiment;
    struct failure why = {0};
    double error[RUNG_MAX];
    qsort(dx.value, (size_t)dx.count, sizeof dx.value[0], by_falling_dx);
    for (int i = 0; i < dx.count; i++) {
        e.options.dx = dx.value[i];
        int status = consistency_error(&e, &error[i], &why);
        measures_fail(m, why.text);
        if (status) return;
    }
    struct slope s = slope_fit(dx.value, error, dx.count);
    m->value = s.value;
    m->ci[0] = s.ci[0];
    m->ci[1] = s.ci[1];
    m->error = error[dx.count - 1];
    struct judged judged = {dx.value, error, dx.count, 0};
    m->verdict = judge_order(&judged, lo, hi, m->reason, sizeof m->reason);
}

/* One run; 0, or *m failed. */
static int run(const struct request *r, struct result *result, struct measured *m) {
    int status = run_experiment(&r->experiment, result, NULL);
    measures_fail(m, result->failure.text);
    if (!status) m->error = result->error.l1;
    return status;
}

static void take_error(const struct request *r, double lo, double hi, struct measured *m) {
    struct result result;
    if (!run(r, &result, m)) measures_judge(m, result.error.l1, lo, hi);
}

static void take_error_linf(const struct request *r, double lo, double hi, struct measured *m) {
    struct result result;
    if (!run(r, &result, m)) measures_judge(m, result.error.linf, lo, hi);
}

static void take_overshoot(const struct request *r, double lo, double hi, struct measured *m) {
    struct result result;
    if (!run(r, &result, m)) measures_judge(m, fmax(result.shape.overshoot, result.shape.undershoot), lo, hi);
}

static void take_heat_drift(const struct request *r, double lo, double hi, struct measured *m) {
    struct result result;
    if (!run(r, &result, m)) measures_judge(m, result.heat_drift, lo, hi);
}

static void take_checkerboard(const struct request *r, double lo, double hi, struct measured *m) {
    struct result result;
    if (!run(r, &result, m)) measures_judge(m, result.shape.checkerboard, lo, hi);
}

static void take_checkerboard_kept(const struct request *r, double lo, double hi, struct measured *m) {
    struct request early = *r;
    struct result first, last;
    early.experiment.problem.t_end = r->experiment.problem.t_end / 10;
    if (run(&early, &first, m) || run(r, &last, m)) return;
    measures_judge(m, last.shape.checkerboard / first.shape.checkerboard, lo, hi);
}

/* Points that fill the domain evenly and meet no symmetry of it: the additive sequences of the plastic number. */
static void odd_point(const struct problem *p, int i, double x[2]) {
    static const double step[2] = {0.7548776662466927, 0.5698402909980532};
    for (int a = 0; a < 2; a++) {
        double u = 0.137 + 0.174 * a + step[a] * i;
        x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (u - floor(u));
    }
}

/* How far the two forms of a reference are apart, in units of what their bounds allow.  The ceiling is on the bound
 * at the end time, where runs are judged, relative to the largest temperature: a reference cannot pass by promising
 * little. */
static void take_reference(const struct request *r, double lo, double hi, struct measured *m) {
    enum { POINTS = 32, TIMES = 4 };
    static const double part[TIMES] = {0.0113, 0.173, 0.619, 1};
    const struct problem *p = &r->experiment.problem;
    double worst = 0, where[3] = {0}, bound = 0, size = 0;
    for (int i = 0; i < POINTS * TIMES && !isnan(worst); i++) {
        double x[2], t = p->t_end * part[i % TIMES];
        odd_point(p, i / TIMES, x);
        struct exact a = r->experiment.scene->exact(p, x, t), b = r->experiment.scene->second(p, x, t);
        double apart = fabs(a.temperature - b.temperature);
        double allowed = a.error_bound + b.error_bound;
        double ratio = !(allowed >= 0) ? NAN : apart == 0 ? 0 : apart / allowed;
        if (t == p->t_end) bound = fmax(bound, a.error_bound);
        size = fmax(size, fabs(a.temperature));
        if (ratio <= worst) continue;
        worst = ratio;
        where[0] = x[0], where[1] = x[1], where[2] = t;
    }
    measures_fail(m, "");
    measures_judge(m, worst, lo, hi);
    m->error = bound / size;
    if (m->verdict == VERDICT_PASS) return;
    snprintf(m->reason, sizeof m->reason, "the two forms are %.3g of their bounds apart at %g, %g m, %g s", worst,
             where[0], where[1], where[2]);
}

const struct measure measures[] = {
    {"slope", "order of E1 over a ladder", 1, take_slope},
    {"slope_l2", "order of the relative L2 error over a ladder", 1, take_slope_l2},
    {"slope_linf", "order of the largest error over a ladder", 1, take_slope_linf},
    {"slope_interior", "order of E1 a tenth of the extent and more from the walls", 1, take_slope_interior},
    {"slope_boundary", "order of E1 nearer to the walls", 1, take_slope_boundary},
    {"operator_slope", "order of a particle method's derivatives of a smooth function", 1, take_operator_slope},
    {"error", "E1 of a run", 0, take_error},
    {"error_linf", "largest error of a run, K", 0, take_error_linf},
    {"fold", "updates of the whole over those of the half or quarter that stands for it", 1, measures_use_fold},
    {"plan", "updates planned over those of the run", 1, measures_use_plan},
    {"time_error", "time error of a run over the one asked for", 0, measures_use_time_error},
    {"choose", "E1 of the run that `choose` proves over the one asked for", 0, measures_use_choose},
    {"overshoot", "how far a run leaves its initial range, above or below, K", 0, take_overshoot},
    {"heat_drift", "heat gained over a run, relative to the heat at its start", 0, take_heat_drift},
    {"checkerboard", "amplitude of the checkerboard in a run, K", 0, take_checkerboard},
    {"checkerboard_kept", "that amplitude at the end, over that at a tenth of the time", 0, take_checkerboard_kept},
    {"claim", "1 where a claim's verdict is the expected one", 0, measures_use_claim},
    {"reference", "distance of a reference's two forms, over the sum of their bounds", 0, take_reference},
    {"limit_agree", "largest |measured/von Neumann - 1| of a stability limit over h/dx", 0, measures_stability_agree},
    {"limit_published", "published over true limit, where a run at 0.99 of it grows", 0,
     measures_stability_published},
    {"limit_interval", "measured stability interval over the one of theory", 0, measures_stability_interval},
    {"stepper_factor", "largest |G - theory| along the real axis, over |G| + 1", 0, measures_stability_factor},
    {"growth", "largest real part of an eigenvalue, kappa/dx^2", 0, measures_stability_growth},
    {"maximum_principle", "h/dx from 0.6 to 3 where weights and runs disagree on it", 0, measures_stability_maximum},
    {"refusal", "exit status of a run that names particle, neighbours and reason", 0, measures_stability_refusal},
    {"endurance", "heat drift of 1e7 steps that stay bounded, over 1e7 eps", 0, measures_stability_endurance},
    {0}};

const struct measure *measures_find(const char *name, struct measured *m) {
    const char *names[WORDS_MAX] = {0};
    struct failure why = {0};
    for (int i = 0; measures[i].name && i < WORDS_MAX - 1; i++) names[i] = measures[i].name;
    int i = words_index(names, name);
    if (i >= 0) return &measures[i];
    words_unknown(names, "measure", name, &why);
    measures_fail(m, why.text);
    return NULL;
}
