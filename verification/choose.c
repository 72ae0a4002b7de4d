/* Choosing by measured orders and constants: each candidate runs on a few coarse rungs; a line through the last of
 * them in log-log foretells where its error reaches what is wanted, and what that will cost.  The cheapest runs; what
 * it measures joins its rungs; and so on until the error is reached.
 *
 * Costs are counted, so that the choice is the same on every machine: what is done once and what each step does are
 * foretold apart, since they grow apart.  Rungs keep the place of the jumps between particles: where a lattice can
 * have all of them midway, only such lattices are taken, since there the order shows from the coarsest rungs on. */
#include "verification/choose.h"

#include "verification/request.h"
#include "verification/slope.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double MARGIN = 0.9;           /* of the error wanted: what a forecast aims at */
static const double WORK_MAX = 2e11;        /* a few minutes */
static const double COARSE_MAX = 1e10;      /* some seconds */
static const int COARSEST[3] = {0, 32, 16}; /* particles along x of the first rung, by dimension */
enum { RUNGS = 5, FITTED = 3, PROOFS = 8 };

static void rule_out(struct choose_one *c, const char *reason) {
    c->predicted_work = INFINITY;
    snprintf(c->reason, sizeof c->reason, "%.190s", reason);
}

/* Adds a run to the rungs, kept coarsest first; the coarsest makes room. */
static void add_rung(struct choose_one *c, int n, const struct result *r) {
    if (c->rungs == CHOOSE_RUNGS) memmove(c->rung, c->rung + 1, (size_t)--c->rungs * sizeof *c->rung);
    int at = c->rungs++;
    for (; at > 0 && c->rung[at - 1].n > n; at--) c->rung[at] = c->rung[at - 1];
    c->rung[at] = (struct choose_rung){n, r->error.l1, r->setup, candidate_work(r) - r->setup};
}

/* The order, and the growth of either part of the work: what is fixed in the one would hide how the other grows. */
static void fit(struct choose_one *c, int first, int last) {
    double n[CHOOSE_RUNGS], error[CHOOSE_RUNGS], once[CHOOSE_RUNGS], steps[CHOOSE_RUNGS];
    int m = 0;
    for (int i = first; i <= last; i++) {
        n[m] = c->rung[i].n;
        error[m] = c->rung[i].error;
        once[m] = c->rung[i].once;
        steps[m++] = c->rung[i].steps;
    }
    c->order = -slope_fit(n, error, m).value;
    c->once = slope_fit(n, once, m).value;
    c->steps = steps[0] > 0 ? slope_fit(n, steps, m).value : 0; /* none with transforms */
}

static void cannot_converge(struct choose_one *c) {
    const struct choose_rung *last = &c->rung[c->rungs - 1];
    char text[120];
    snprintf(text, sizeof text, "does not converge: order %.2f, E1 %.3g with %d particles along x", c->order,
             last->error, last->n);
    rule_out(c, text);
}

/* Where the error will be reached: between two rungs of which one has it, or beyond the last. */
static void foretell(struct choose_one *c, double error, int unit) {
    int reached = 0, last = c->rungs - 1;
    while (reached <= last && !(c->rung[reached].error <= error)) reached++;
    const struct choose_rung *base = &c->rung[reached <= last ? reached : last];
    if (reached == 0) { /* the coarsest has it already */
        c->wanted = base->n, c->predicted_error = base->error, c->predicted_work = base->once + base->steps;
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
    double along = base->n * pow(base->error / (MARGIN * error), 1 / c->order);
    if (reached <= last) along = fmin(base->n, fmax(along, c->rung[reached - 1].n + 1));
    if (reached > last) along = fmax(along, base->n + 1);
    if (!(along < 1e7)) {
        rule_out(c, "needs more than 1e7 particles along x");
        return;
    }
    c->wanted = candidate_member(along, unit);
    double ratio = (double)c->wanted / base->n;
    c->predicted_error = base->error * pow(ratio, -c->order);
    c->predicted_work = base->once * pow(ratio, c->once) + base->steps * pow(ratio, c->steps);
    if (c->predicted_work > WORK_MAX) rule_out(c, "would take more than 2e11 pairs");
}

/* A rung that is refused (too coarse, say) is left out; with fewer than two there is nothing to foretell from. */
static void calibrate(const struct request *r, struct choose_one *c, double error, int unit) {
    double n = COARSEST[r->problem.dim];
    int before = 0;
    for (int k = 0; k < RUNGS; k++, n *= 1.5) {
        struct result result;
        int along = candidate_member(fmax(n, before + 1), unit);
        before = along;
        if (candidate_steps_work(c->candidate, r, along) > COARSE_MAX) {
            if (c->rungs == 0) rule_out(c, "would take more than 1e10 pairs on a coarse rung");
            break;
        }
        if (candidate_run(c->candidate, r, along, &result)) {
            rule_out(c, result.failure.text);
            continue;
        }
        add_rung(c, along, &result);
        if (result.error.l1 <= error) break;
    }
    if (c->rungs < 2 && !(c->rungs == 1 && c->rung[0].error <= error)) return;
    c->reason[0] = '\0';
    foretell(c, error, unit);
}

static int cheapest_first(const void *a, const void *b) {
    const struct choose_one *x = a, *y = b;
    if (x->predicted_work != y->predicted_work) return x->predicted_work < y->predicted_work ? -1 : 1;
    return (x->candidate > y->candidate) - (x->candidate < y->candidate);
}

static void collect(const struct request *r, struct choose *c) {
    for (const struct candidate *k = candidates_table; k->label && c->count < CHOOSE_CANDIDATES; k++)
        if (!k->wide && (k->dim == 0 || k->dim == r->problem.dim)) c->one[c->count++].candidate = k;
}

/* One proving run of the cheapest.  1 where it ends the search. */
static int prove(const struct request *r, struct choose *c, int unit) {
    struct choose_one *first = &c->one[0];
    if (!isfinite(first->predicted_work)) return 1;
    double rounding = candidate_rounding(first->candidate, r, first->wanted);
    if (rounding > c->error) {
        char text[120];
        snprintf(text, sizeof text, "rounding leaves %.2g with %d particles along x", rounding, first->wanted);
        rule_out(first, text);
        c->rounding = c->rounding > 0 ? fmin(c->rounding, rounding) : rounding;
        return 0;
    }
    struct result result;
    struct choose_one foretold = *first;
    int status = candidate_run(first->candidate, r, first->wanted, &result);
    c->proofs++;
    if (status) {
        rule_out(first, result.failure.text);
        return 0;
    }
    if (!c->best.candidate || result.error.l1 < c->proof.error.l1) c->best = foretold, c->proof = result;
    c->reached = result.error.l1 <= c->error;
    if (c->reached) return 1;
    add_rung(first, first->wanted, &result);
    foretell(first, c->error, unit);
    return 0;
}

static int say_best(const struct choose *c, struct failure *why) {
    const struct choose_rung *best = NULL;
    const char *whose = "";
    char rounding[80] = "";
    if (c->rounding > 0)
        snprintf(rounding, sizeof rounding, ": rounding alone leaves %.2g after steps enough", c->rounding);
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < c->one[i].rungs; k++) {
            const struct choose_rung *rung = &c->one[i].rung[k];
            if (!isfinite(rung->error) || (best && best->error <= rung->error)) continue;
            best = rung;
            whose = c->one[i].candidate->label;
        }
    if (!best)
        return fail(why, STATUS_GATE, "an error of %g was not reached: no candidate runs on this scene", c->error);
    return fail(why, STATUS_GATE,
                "an error of %g was not reached%s; the best was %.3g, by %s with %d particles along x", c->error,
                rounding, best->error, whose, best->n);
}

int choose_run(const struct request *r, double error, struct choose *c, struct failure *why) {
    *c = (struct choose){.error = error};
    int unit = candidate_unit(&r->problem);
    if (!unit) {
        char fitting[120];
        candidate_fitting(&r->problem, fitting, sizeof fitting);
        return fail(why, STATUS_INPUT, "no lattice of up to 64 square cells along x fits this domain; one fits %s",
                    fitting);
    }
    collect(r, c);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < c->count; i++) calibrate(r, &c->one[i], error, unit);
    int done = 0;
    while (!done && c->proofs < PROOFS) {
        qsort(c->one, (size_t)c->count, sizeof c->one[0], cheapest_first);
        done = prove(r, c, unit);
    }
    if (c->reached) return STATUS_OK;
    return say_best(c, why);
}
