/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growing modes, found by power iteration on a step of RKL2 (stepper.c): its factor G(dt lambda) is at most 1 in size
 * for every mode that does not grow, however long the step, and above 1 for those that grow.  Noise goes through four
 * steps of the length of the run; of a mode that doubles in it, sixteen times its share is left then, and the last
 * step shows its factor.  Where that is above 1.1 steps go on until two show the same, so that the transient growth
 * of an operator far from normal is over; where it is above e they are shorter, so that the factor is exp(dt lambda).
 */
#include "solver/time/growth.h"
#include "solver/time/stepper.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static const double LEAST = 0.0953; /* log(1.1): what is stated of a mode in the whole time */

/* All weights >= 0: by the maximum principle no mode grows. */
static int weights_show_none(const struct heat_operator *a) {
    if (!a->value) return 0;
    for (size_t k = 0; k < a->row[a->n]; k++)
        if (a->value[k] < 0) return 0;
    return 1;
}

/* In [-1, 1): splitmix64 (Steele, Lea & Flood 2014). */
static double noise(size_t i) {
    uint64_t z = ((uint64_t)i + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-52 - 1;
}

static double norm(const double *T, size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += T[i] * T[i];
    return sqrt(sum);
}

/* T, of norm 1, by a step of dt; 0 where T is no number any more. */
static int advance(const struct heat_operator *a, double bound, double dt, double *T) {
    struct march m = {.stepper = STEPPER_RKL2,
                      .time = dt,
                      .steps = 1,
                      .stages = stepper_of(STEPPER_RKL2)->count(dt, bound),
                      .lo = -HUGE_VAL,
                      .hi = HUGE_VAL,
                      .bound = bound};
    struct failure why;
    size_t bytes = 0;
    return m.stages <= STEPPER_STAGES_MAX && !stepper_march(a, &m, T, &bytes, &why);
}

/* T becomes of norm 1; returns the logarithm of what it was. */
static double normalise(double *T, size_t n) {
    double size = norm(T, n);
    for (size_t i = 0; i < n; i++) T[i] /= size;
    return log(size);
}

/* The same; returns the logarithm of the factor and leaves T of norm 1. */
static double step(const struct heat_operator *a, double bound, double dt, double *T) {
    return advance(a, bound, dt, T) ? normalise(T, a->n) : NAN;
}

/* The rate that the last of some steps shows, of *length s each or shorter.  One whose factor is not a number is
 * taken again; steps end where the rate is below `least`, s^-1. */
static double iterate(const struct heat_operator *a, double bound, double least, double *T, double *length) {
    enum { STEPS = 4, MOST = 40, TRIES = 60 };
    double grown = 0, dt = *length, *kept = xcalloc(a->n, sizeof *kept);
    for (int k = 0, tries = 0; k < MOST && tries < TRIES; k++, tries++) {
        for (size_t i = 0; i < a->n; i++) kept[i] = T[i];
        double before = grown, shorter = 1;
        grown = step(a, bound, dt, T);
        if (!isfinite(grown)) {
            for (size_t i = 0; i < a->n; i++) T[i] = kept[i];
            shorter = 16;
        } else if (grown > 1) {
            shorter = fmax(2, grown / 0.7);
        }
        if (shorter > 1) {
            dt /= shorter, k = -1, grown = 0; /* the next counts as the first */
            continue;
        }
        if (k >= STEPS - 1 && (grown < least * dt || fabs(grown - before) < 0.02 * grown)) break;
    }
    free(kept);
    *length = dt;
    return grown / dt;
}

/* RKL2's factor is above 1 too for what decays while it swings, if |Im lambda| dt is too large.  The rate of a mode
 * that grows is the same by shorter steps. */
static double confirm(const struct heat_operator *a, double bound, double time, double *T) {
    double dt = time, least = LEAST / time, rate = iterate(a, bound, least, T, &dt);
    while (rate > least && dt * bound > 1) {
        double before = rate;
        dt /= 4;
        rate = iterate(a, bound, least, T, &dt);
        if (fabs(rate - before) < 0.05 * before) break;
    }
    return rate > least ? rate : 0;
}

/* Noise of norm 1 and the operator without what walls and sources add. */
struct trial {
    struct heat_operator a;
    double *T; /* owned */
};

static void trial_create(struct trial *t, const struct heat_operator *a) {
    *t = (struct trial){.a = *a, .T = xcalloc(a->n, sizeof *t->T)};
    t->a.g = NULL, t->a.constant = 0;
    for (size_t i = 0; i < a->n; i++) t->T[i] = noise(i);
    normalise(t->T, a->n);
}

static void trial_free(struct trial *t) {
    free(t->T);
}

double growth_rate(const struct heat_operator *a, double bound, double time) {
    if (!(time > 0) || !(bound > 0) || weights_show_none(a)) return 0;
    struct trial t;
    trial_create(&t, a);
    double rate = confirm(&t.a, bound, time, t.T);
    trial_free(&t);
    return rate;
}

/* What a step takes from the noise, five times over: of modes that hardly change in a step, next to nothing. */
static int take_what_decays(struct trial *t, double bound, double dt) {
    enum { TIMES = 5 };
    double *kept = xcalloc(t->a.n, sizeof *kept);
    int ok = 1;
    for (int k = 0; k < TIMES && ok; k++) {
        for (size_t i = 0; i < t->a.n; i++) kept[i] = t->T[i];
        ok = advance(&t->a, bound, dt, t->T);
        for (size_t i = 0; i < t->a.n; i++) t->T[i] -= kept[i];
        normalise(t->T, t->a.n);
    }
    free(kept);
    return ok;
}

/* The logarithm of the factor of what is left of the noise in the end: the mean of the later half of some steps,
 * which end where a mode of its usual share, 1 / sqrt(n), would be a hundredth of that. */
static double slowest(struct trial *t, double bound, double dt, double steps) {
    enum { MOST = 60 };
    const double gone = -log(100 * sqrt((double)t->a.n));
    double sum[MOST + 1] = {0};
    int k = 0;
    if (!take_what_decays(t, bound, dt)) return INFINITY;
    while (k < MOST && k < steps && sum[k] > gone) {
        double grown = step(&t->a, bound, dt, t->T);
        if (!isfinite(grown)) return INFINITY;
        sum[k + 1] = sum[k] + grown, k++;
    }
    return (sum[k] - sum[k / 2]) / (k - k / 2);
}

double growth_by_steps(const struct heat_operator *a, double bound, double dt, double steps) {
    const double least = log(0.8);
    struct trial t;
    trial_create(&t, a);
    double grown = slowest(&t, bound, dt, steps);
    trial_free(&t);
    if (grown < least) return 0;
    double rate = growth_rate(a, bound, dt * steps); /* of the equations themselves, which shorter steps leave */
    return rate > 0 && rate * dt > grown / 2 ? 0 : exp(grown);
}
