/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Choosing by measured orders and constants: each candidate runs on a few coarse rungs, which predict where it
 * reaches what is wanted (extrapolation.h).  The cheapest is run and its error joins its rungs, until the
 * error is reached.  Where that is impossible, the finest feasible runs give the best error.
 *
 * Costs are counted, so that the choice is the same on every machine. */
#include "verification/choose/choose.h"

#include "verification/text/progress.h"
#include "verification/run/experiment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const double choose_work_max = 2e11;
enum { PROOFS = 8, LAST = 2 };
static const double NEARER = 0.9; /* of the best error: what a last run must promise */
static const double LUCKY = 0.1;  /* of the predicted error: below it one more run is wanted */
static const double FINER = 1.5;  /* particles along x of that run over those of the one before */

static int cheapest_first(const void *a, const void *b) {
    const struct extrapolation *x = a, *y = b;
    if (x->predicted_work != y->predicted_work) return x->predicted_work < y->predicted_work ? -1 : 1;
    return (x->candidate > y->candidate) - (x->candidate < y->candidate);
}

static void collect(const struct experiment *e, struct choose *c) {
    for (const struct candidate *k = candidates_table; k->label && c->count < CHOOSE_CANDIDATES; k++)
        if (!k->bench_only && (k->dim == 0 || k->dim == e->problem.dim)) c->one[c->count++].candidate = k;
}

static void calibrate(struct choose *c, const struct extrapolation_goal *goal) {
    struct progress shown = progress_start("candidates calibrated", c->count);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < c->count; i++) {
        extrapolation_calibrate(&c->one[i], goal);
        progress_tick(&shown);
    }
    progress_end(&shown);
}

/* A proving run, told beforehand where it makes the search long. */
static int run_proof(struct choose *c, const struct candidate *one, const struct extrapolation_goal *goal, int n,
                     struct result *result, double *between) {
    struct candidate_cost cost;
    struct failure ignored;
    if (!candidate_predict(one, goal->experiment, n, &cost, &ignored))
        forewarn_next(&c->forewarned, "the search with its next run", cost.proof / forewarn_rate);
    return candidate_prove(one, goal->experiment, n, result, between);
}

/* Whether a finer run has the error too; it joins the rungs where it does not. */
static int confirmed(struct choose *c, struct extrapolation *one, const struct extrapolation_goal *goal) {
    struct result result;
    int finer = candidate_member(FINER * one->wanted, goal->unit);
    double between;
    if (run_proof(c, one->candidate, goal, finer, &result, &between)) return 0;
    double error = fmax(result.error.l1, between);
    if (error <= goal->error) return 1;
    extrapolation_learn(one, goal, finer, error);
    return 0;
}

/* One proving run of what is wanted of *one.  1 where it ends the search: where the error is reached at the particles
 * and half-way between them.  An error far below the prediction may be luck. */
static int prove(struct choose *c, struct extrapolation *one, const struct extrapolation_goal *goal) {
    struct result result;
    struct extrapolation before = *one;
    double between;
    int status = run_proof(c, one->candidate, goal, one->wanted, &result, &between);
    c->proofs++;
    if (status) {
        extrapolation_rule_out(one, result.failure.text);
        return 0;
    }
    double error = fmax(result.error.l1, between);
    if (error < LUCKY * before.predicted_error && !confirmed(c, one, goal)) return 0;
    if (!c->best.candidate || error < fmax(c->proof.error.l1, c->between))
        c->best = before, c->proof = result, c->between = between;
    c->reached = error <= c->error;
    if (c->reached) return 1;
    extrapolation_learn(one, goal, before.wanted, error);
    return 0;
}

static void search(struct choose *c, const struct extrapolation_goal *goal) {
    struct progress shown = progress_start("proving runs at most", PROOFS);
    for (int done = 0; !done && c->proofs < PROOFS;) {
        qsort(c->one, (size_t)c->count, sizeof c->one[0], cheapest_first);
        if (!isfinite(c->one[0].predicted_work)) break;
        if (extrapolation_scout(&c->one[0], goal)) continue;
        progress_tick(&shown); /* one that is under way */
        done = prove(c, &c->one[0], goal);
    }
    progress_end(&shown);
}

/* The error is out of reach: the finest feasible runs, best prediction first, while one may improve on the best
 * error. */
static void try_finest(struct choose *c, const struct extrapolation_goal *goal) {
    struct extrapolation finest[CHOOSE_CANDIDATES];
    struct progress shown = progress_start("last runs at most", LAST);
    for (int i = 0; i < c->count; i++) {
        if (c->one[i].rounding > 0)
            c->rounding = c->rounding > 0 ? fmin(c->rounding, c->one[i].rounding) : c->one[i].rounding;
        finest[i] = c->one[i];
        if (!extrapolation_finest(&finest[i], goal)) finest[i].predicted_error = INFINITY;
    }
    for (int k = 0; k < LAST && !c->reached; k++) {
        int first = 0;
        for (int i = 1; i < c->count; i++)
            if (finest[i].predicted_error < finest[first].predicted_error) first = i;
        double nearest = c->best.candidate ? fmax(c->proof.error.l1, c->between) : INFINITY;
        if (!(finest[first].predicted_error < NEARER * nearest)) break;
        progress_tick(&shown);
        prove(c, &finest[first], goal);
        finest[first].predicted_error = INFINITY;
    }
    progress_end(&shown);
}

static int say_best(const struct choose *c, struct failure *why) {
    const struct extrapolation_rung *best = NULL;
    const char *whose = "";
    char rounding[80] = "";
    const struct extrapolation_rung proof = {c->best.wanted, fmax(c->proof.error.l1, c->between)};
    if (c->best.candidate) best = &proof, whose = c->best.candidate->label;
    if (c->rounding > 0)
        snprintf(rounding, sizeof rounding, ": rounding alone leaves %.2g after steps enough", c->rounding);
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < c->one[i].rungs; k++) {
            const struct extrapolation_rung *rung = &c->one[i].rung[k];
            if (!isfinite(rung->error) || (best && best->error <= rung->error)) continue;
            best = rung;
            whose = c->one[i].candidate->label;
        }
    if (!best)
        return refuse(why, STATUS_GATE, "an error of %g was not reached: no candidate runs on this scene", c->error);
    return refuse(why, STATUS_GATE,
                  "an error of %g was not reached%s; the best was %.3g, by %s with %d particles along x", c->error,
                  rounding, best->error, whose, best->n);
}

int choose_run(const struct experiment *e, double error, double work_max, struct choose *c, struct failure *why) {
    *c = (struct choose){.error = error};
    struct extrapolation_goal goal = {e, error, work_max, candidate_unit(&e->problem)};
    if (!goal.unit) {
        char fitting[160];
        candidate_fitting(&e->problem, fitting, sizeof fitting);
        return refuse(why, STATUS_INPUT, "no lattice of up to %d square cells along x fits this domain; one fits %s",
                      CANDIDATE_UNIT_MAX, fitting);
    }
    collect(e, c);
    calibrate(c, &goal);
    search(c, &goal);
    if (!c->reached) try_finest(c, &goal);
    if (c->reached) return STATUS_OK;
    return say_best(c, why);
}
