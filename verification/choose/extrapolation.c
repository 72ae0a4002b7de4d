/* Error and cost of runs, predicted: a line through the last coarse runs in log-log gives the order in space; two
 * runs that differ in their time steps alone give the error in time; the plan of the very run gives its cost.
 *
 * RKL2 leaves its time step open.  E1 = S n^-p + K N^-2 with N steps, whose stages grow as n / sqrt(N): the work,
 * n^(d+1) sqrt(N), is least where the time makes up p / (p + 4 (d + 1)) of E1.  A step takes no mode down by more
 * than DAMPED, but for the first one at a jump: what is gone at the end time must be below the error in N steps,
 * however small K.
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
static const double DAMPED = 0.6;         /* RKL2's factor of the stiffest modes in a step, about */
static const int COARSEST[3] = {0, 4, 4}; /* by dimension: particles along x of the first rung, */
static const int TIMED[3] = {0, 64, 32};  /* of the runs that show the error in time, */
static const int RUNGS[3] = {0, 10, 8};   /* and rungs, apart by 1.5 */
enum { FITTED = 3, FAR = 4 };

void extrapolation_rule_out(struct extrapolation *c, const char *reason) {
    c->predicted_work = INFINITY;
    snprintf(c->reason, sizeof c->reason, "%.190s", reason);
}

/* ---- Time ---- */

/* Time steps whose error is a share of `error` and that damp the stiff modes below it; 0: not open. */
static int time_steps(const struct extrapolation *c, const struct extrapolation_goal *goal, double error) {
    if (!(c->candidate->steps > 0)) return 0;
    double share = 1 / (1 + 2 * (goal->experiment->problem.dim + 1.0)), least = log(goal->error) / log(DAMPED);
    return (int)fmin(1e7, ceil(fmax(fmax(2, least), sqrt(c->time_constant / (share * MARGIN * error)))));
}

static double time_part(const struct extrapolation *c, int steps) {
    return steps > 0 ? c->time_constant / ((double)steps * steps) : 0;
}

/* The space error of a rung; at least half of its error, since a small remainder is uncertain. */
static double space_part(const struct extrapolation *c, const struct extrapolation_rung *rung) {
    return fmax(rung->error / 2, rung->error - time_part(c, rung->size.steps));
}

/* Second order: of the difference between N and 2 N steps, 4/3 is the error of N. */
static void measure_time(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct experiment *e = goal->experiment;
    int steps = time_steps(c, goal, goal->error);
    struct candidate_size coarse = {candidate_member(TIMED[e->problem.dim], goal->unit), steps},
                          fine = {coarse.n, 2 * steps};
    struct field a = {0}, b = {0};
    struct failure why;
    if (steps == 0) return;
    if (!candidate_solve(c->candidate, e, coarse, &a, &why) && !candidate_solve(c->candidate, e, fine, &b, &why)) {
        double change = field_distance(&b, a.T, b.T);
        if (isfinite(change)) c->time_constant = 4.0 / 3 * change * steps * steps;
    }
    field_free(&a);
    field_free(&b);
}

/* ---- Space ---- */

/* Adds a run to the rungs, kept coarsest first; the coarsest makes room. */
static void add_rung(struct extrapolation *c, struct candidate_size size, double error) {
    if (c->rungs == EXTRAPOLATION_RUNGS) memmove(c->rung, c->rung + 1, (size_t)--c->rungs * sizeof *c->rung);
    int at = c->rungs++;
    for (; at > 0 && c->rung[at - 1].size.n > size.n; at--) c->rung[at] = c->rung[at - 1];
    c->rung[at] = (struct extrapolation_rung){size, error};
}

static void fit(struct extrapolation *c, int first, int last) {
    double n[EXTRAPOLATION_RUNGS], error[EXTRAPOLATION_RUNGS];
    for (int i = first; i <= last; i++) {
        n[i - first] = c->rung[i].size.n;
        error[i - first] = space_part(c, &c->rung[i]);
    }
    c->order = -slope_fit(n, error, last - first + 1).value;
}

static double space_beyond(const struct extrapolation *c, const struct extrapolation_rung *base, double n) {
    return space_part(c, base) * pow(n / base->size.n, -c->order);
}

static void cannot_converge(struct extrapolation *c) {
    const struct extrapolation_rung *last = &c->rung[c->rungs - 1];
    char text[120];
    snprintf(text, sizeof text, "does not converge: order %.2f, E1 %.3g with %d particles along x", c->order,
             last->error, last->size.n);
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
    else if (cost.rounding > goal->error && c->wanted.n > last->size.n) {
        snprintf(text, sizeof text, "rounding leaves %.2g with %d particles along x", cost.rounding, c->wanted.n);
        c->rounding = cost.rounding;
    } else if (cost.whole > goal->work_max)
        snprintf(text, sizeof text, "would take %.2g pairs with %d particles along x", cost.whole, c->wanted.n);
    else if (cost.bytes > BYTES_MAX)
        snprintf(text, sizeof text, "would hold %.2g bytes with %d particles along x", cost.bytes, c->wanted.n);
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
        c->wanted = base->size, c->predicted_error = base->error;
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
    c->wanted.steps = time_steps(c, goal, goal->error);
    double in_time = time_part(c, c->wanted.steps);
    double along = base->size.n * pow(space_part(c, base) / (MARGIN * goal->error - in_time), 1 / c->order);
    if (reached <= last) along = fmin(base->size.n, fmax(along, c->rung[reached - 1].size.n + 1));
    if (reached > last) along = fmax(along, base->size.n + 1);
    if (!(along < 1e7)) {
        extrapolation_rule_out(c, "needs more than 1e7 particles along x");
        return;
    }
    c->wanted.n = candidate_member(along, goal->unit);
    c->predicted_error = space_beyond(c, base, c->wanted.n) + in_time;
    check_cost(c, goal);
}

/* A rung that is refused (too coarse, say) is left out; with fewer than two there is no line. */
void extrapolation_calibrate(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct experiment *e = goal->experiment;
    double n = COARSEST[e->problem.dim], before = 1;
    int had = 0;
    measure_time(c, goal);
    extrapolation_rule_out(c, "has too few coarse rungs");
    for (int k = 0; k < RUNGS[e->problem.dim]; k++, n *= 1.5) {
        struct candidate_size size = {candidate_member(n, goal->unit), 0};
        if (c->rungs > 0) size.n = candidate_member(fmax(n, c->rung[c->rungs - 1].size.n + 1), goal->unit);
        size.steps = time_steps(c, goal, fmax(goal->error, before / 10));
        struct candidate_cost cost;
        struct result result;
        struct failure why;
        double between;
        if (candidate_predict(c->candidate, e, size, &cost, &why)) {
            extrapolation_rule_out(c, why.text);
            continue;
        }
        if (cost.work > (c->rungs < FITTED ? COARSE_MAX : MORE_MAX) || cost.bytes > BYTES_MAX) {
            extrapolation_rule_out(c, "would take more than 1e10 pairs on a coarse rung");
            break;
        }
        if (candidate_prove(c->candidate, e, size, &result, &between)) {
            extrapolation_rule_out(c, result.failure.text);
            continue;
        }
        before = result.error.l1 <= goal->error ? fmax(result.error.l1, between) : result.error.l1;
        add_rung(c, size, before);
        if (before <= goal->error && ++had == 2) break; /* one alone may be luck */
        if (!(before <= goal->error)) had = 0;
    }
    if (c->rungs < 2 && !(c->rungs == 1 && c->rung[0].error <= goal->error)) return;
    c->reason[0] = '\0';
    predict(c, goal);
}

/* At a quarter of n the cost is a few hundredths: (1/4)^(d+1), and less where the steps are fewer too. */
int extrapolation_scout(struct extrapolation *c, const struct extrapolation_goal *goal) {
    const struct extrapolation_rung *last = &c->rung[c->rungs - 1];
    struct candidate_size size = {candidate_member((double)c->wanted.n / FAR, goal->unit), 0};
    struct result result;
    if (c->wanted.n <= 2 * FAR * last->size.n || size.n <= last->size.n) return 0;
    size.steps = time_steps(c, goal, fmax(goal->error, space_beyond(c, last, size.n)));
    if (candidate_run(c->candidate, goal->experiment, size, &result)) return 0;
    add_rung(c, size, result.error.l1);
    predict(c, goal);
    return 1;
}

void extrapolation_learn(struct extrapolation *c, const struct extrapolation_goal *goal, struct candidate_size size,
                         double predicted, double measured) {
    if (measured > predicted) c->time_constant *= measured / predicted; /* of time or of space: unknown */
    add_rung(c, size, measured);
    predict(c, goal);
}

int extrapolation_finest(struct extrapolation *c, const struct extrapolation_goal *goal) {
    int found = 0;
    if (c->rungs < 2 || !(c->order > 0.2)) return 0;
    const struct extrapolation_rung *base = &c->rung[c->rungs - 1];
    for (double n = base->size.n * 1.1; n < 1e7; n *= 1.1) {
        struct extrapolation finer = *c;
        struct candidate_cost cost;
        struct failure why;
        finer.wanted.n = candidate_member(n, goal->unit);
        double space = space_beyond(c, base, finer.wanted.n);
        finer.wanted.steps = time_steps(c, goal, fmax(space / MARGIN, goal->error));
        if (candidate_predict(c->candidate, goal->experiment, finer.wanted, &cost, &why)) break;
        finer.predicted_error = space + time_part(c, finer.wanted.steps) + cost.rounding;
        if (cost.whole > goal->work_max || cost.bytes > BYTES_MAX) break;
        if (found && finer.predicted_error > c->predicted_error) break;
        finer.predicted_work = cost.work;
        *c = finer;
        found = 1;
    }
    return found;
}
