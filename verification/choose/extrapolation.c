/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Error and cost of runs, predicted: a line through the last coarse runs in log-log gives the order; the plan of the
 * very run gives its cost.  No candidate has a time step of its own to choose: it follows from dx, or there is no
 * error in time.  (RKL2 in N steps takes 2 sqrt(N h) updates where polynomials take 8.7 sqrt(h), h as in chebyshev.c,
 * and some log(E1) / log(0.6) steps at least: it would save a third at E1 = 1e-2, a sixth at 1e-3, nothing at 1e-4.)
 *
 * Rungs keep the place of the jumps between particles: where a lattice can have all of them midway, only such
 * lattices are taken, since there the order shows from the coarsest rungs on. */
#include "verification/choose/extrapolation.h"

#include "verification/run/experiment.h"
#include "verification/ladder/slope.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double MARGIN = 0.9;         /* of the error wanted: what a forecast aims at */
static const double COARSE_MAX = 1e10;    /* some seconds: of a rung without which there is no forecast */
static const double MORE_MAX = 1e8;       /* of a rung beyond those */
static const double BYTES_MAX = 8e9;      /* what a run may hold */
static const int COARSEST[3] = {0, 4, 4}; /* particles along x of the first rung, by dimension */
static const int RUNGS[3] = {0, 10, 8};   /* how many, by dimension, each 1.5 times as fine as the one before */
enum { FITTED = 3, FAR = 4 };

void extrapolation_rule_out(struct extrapolation *c, const char *reason) {
    c->predicted_work = INFINITY;
    snprintf(c->reason, sizeof c->reason, "%.190s", reason);
}

/* Adds a run to the rungs, kept coarsest first; the coarsest makes room. */
static void add_rung(struct extrapolation *c, int n, double error) {
    if (c->rungs == EXTRAPOLATION_RUNGS) memmove(c->rung, c->rung + 1, (size_t)--c->rungs * sizeof *c->rung);
    int at = c->rungs++;
    for (; at > 0 && c->rung[at - 1].n > n; at--) c->rung[at] = c->rung[at - 1];
    c->rung[at] = (struct extrapolation_rung){n, error};
}

static void fit(struct extrapolation *c, int first, int last) {
    double n[EXTRAPOLATION_RUNGS], error[EXTRAPOLATION_RUNGS];
    for (int i = first; i <= last; i++) {
        n[i - first] = c->rung[i].n;
        error[i - first] = c->rung[i].error;
    }
    c->order = -slope_fit(n, error, last - first + 1).value;
}

static double error_beyond(const struct extrapolation *c, const struct extrapolation_rung *base, double n) {
    return base->error * pow(n / base->n, -c->order);
}

static void cannot_converge(struct extrapolation *c) {
    const struct extrapolation_rung *last = &c->rung[c->rungs - 1];
    char text[120];
    snprintf(text, sizeof text, "does not converge: order %.2f, E1 %.3g with %d particles along x", c->order,
             last->error, last->n);
    extrapolation_rule_out(c, text);
}

/* ---- Cost ---- */

/* The cost of the predicted run, or the reason that rules it out. */
static void check_cost(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct extrapolation_rung *last = &c->rung[c->rungs - 1];
    struct candidate_cost cost;
    struct failure why;
    char text[120];
    c->rounding = 0;
    if (candidate_predict(c->candidate, goal->experiment, c->wanted, &cost, &why))
        snprintf(text, sizeof text, "%.119s", why.text);
    else if (cost.rounding > goal->error && c->wanted > last->n) {
        snprintf(text, sizeof text, "rounding leaves %.2g with %d particles along x", cost.rounding, c->wanted);
        c->rounding = cost.rounding;
    } else if (cost.whole > goal->work_max)
        snprintf(text, sizeof text, "would take %.2g pairs with %d particles along x", cost.whole, c->wanted);
    else if (cost.bytes > BYTES_MAX)
        snprintf(text, sizeof text, "would hold %.2g bytes with %d particles along x", cost.bytes, c->wanted);
    else {
        c->predicted_work = cost.work;
        return;
    }
    extrapolation_rule_out(c, text);
}

/* The size that reaches the error: between two rungs that bracket it, or beyond the last. */
static void predict(struct extrapolation *c, const struct extrapolation_goal *goal) {
    int last = c->rungs - 1, reached = last + 1; /* from there on every rung has it */
    while (reached > 0 && c->rung[reached - 1].error <= goal->error) reached--;
    const struct extrapolation_rung *base = &c->rung[reached <= last ? reached : last];
    if (reached == 0) { /* the coarsest has it already */
        c->wanted = base->n, c->predicted_error = base->error;
        check_cost(c, goal);
        return;
    }
    if (reached <= last)
        fit(c, reached - 1, reached);
    else
        fit(c, last - FITTED + 1 > 0 ? last - FITTED + 1 : 0, last);
    if (!(c->order > 0.2)) {
        cannot_converge(c);
        return;
    }
    double along = base->n * pow(base->error / (MARGIN * goal->error), 1 / c->order);
    if (reached <= last) along = fmin(base->n, fmax(along, c->rung[reached - 1].n + 1));
    if (reached > last) along = fmax(along, base->n + 1);
    if (!(along < 1e7)) {
        extrapolation_rule_out(c, "needs more than 1e7 particles along x");
        return;
    }
    c->wanted = candidate_member(along, goal->unit);
    c->predicted_error = error_beyond(c, base, c->wanted);
    check_cost(c, goal);
}

/* A rung that is refused (too coarse, say) is left out; with fewer than two there is no line. */
void extrapolation_calibrate(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct experiment *e = goal->experiment;
    double n = COARSEST[e->problem.dim], before = 1;
    int had = 0;
    extrapolation_rule_out(c, "has too few coarse rungs");
    for (int k = 0; k < RUNGS[e->problem.dim]; k++, n *= 1.5) {
        int along = candidate_member(c->rungs > 0 ? fmax(n, c->rung[c->rungs - 1].n + 1) : n, goal->unit);
        struct candidate_cost cost;
        struct result result;
        struct failure why;
        double between;
        if (candidate_predict(c->candidate, e, along, &cost, &why)) {
            extrapolation_rule_out(c, why.text);
            continue;
        }
        if (cost.work > (c->rungs < FITTED ? COARSE_MAX : MORE_MAX) || cost.bytes > BYTES_MAX) {
            extrapolation_rule_out(c, "would take more than 1e10 pairs on a coarse rung");
            break;
        }
        if (candidate_prove(c->candidate, e, along, &result, &between)) {
            extrapolation_rule_out(c, result.failure.text);
            continue;
        }
        before = result.error.l1 <= goal->error ? fmax(result.error.l1, between) : result.error.l1;
        add_rung(c, along, before);
        if (before <= goal->error && ++had == 2) break; /* one alone may be luck */
        if (!(before <= goal->error)) had = 0;
    }
    if (c->rungs < 2 && !(c->rungs == 1 && c->rung[0].error <= goal->error)) return;
    c->reason[0] = '\0';
    predict(c, goal);
}

/* At a quarter of n the cost is a few hundredths: (1/4)^(d+1). */
int extrapolation_scout(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct extrapolation_rung *last = &c->rung[c->rungs - 1];
    int n = candidate_member((double)c->wanted / FAR, goal->unit);
    struct result result;
    if (c->wanted <= 2 * FAR * last->n || n <= last->n) return 0;
    if (candidate_prove(c->candidate, goal->experiment, n, &result, NULL)) return 0;
    add_rung(c, n, result.error.l1);
    predict(c, goal);
    return 1;
}

void extrapolation_learn(struct extrapolation *c, const struct extrapolation_goal *goal, int n, double measured) {
    add_rung(c, n, measured);
    predict(c, goal);
}

int extrapolation_finest(struct extrapolation *c, const struct extrapolation_goal *goal) {
    int found = 0;
    if (c->rungs < 2 || !(c->order > 0.2)) return 0;
    const struct extrapolation_rung *base = &c->rung[c->rungs - 1];
    for (double n = base->n * 1.1; n < 1e7; n *= 1.1) {
        struct extrapolation finer = *c;
        struct candidate_cost cost;
        struct failure why;
        finer.wanted = candidate_member(n, goal->unit);
        if (candidate_predict(c->candidate, goal->experiment, finer.wanted, &cost, &why)) break;
        finer.predicted_error = error_beyond(c, base, finer.wanted) + cost.rounding;
        if (cost.whole > goal->work_max || cost.bytes > BYTES_MAX) break;
        if (found && finer.predicted_error > c->predicted_error) break;
        finer.predicted_work = cost.work;
        *c = finer;
        found = 1;
    }
    return found;
}
