/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Growing modes by power iteration on a step of RKL2 (stepper.c).  Its factor G(dt lambda) is at most 1 in magnitude
 * for every mode that does not grow, at any step length, and above 1 for growing modes.
 *
 * Noise is advanced by four steps of the length of the run.  The amplitude of a mode that doubles within the run is
 * then multiplied by sixteen, and the last step gives its factor.  If the factor is above 1.1, steps continue until
 * two agree, so that the transient growth of a non-normal operator has ended.  If it is above e, shorter steps are
 * used, for which the factor is exp(dt lambda). */
#include "solver/time/growth.h"
#include "solver/time/stepper.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static const double LEAST = 0.0953; /* log(1.1): least growth over the run that is reported */

/* With all weights >= 0 the maximum principle excludes growing modes. */
static int weights_show_none(const struct heat_operator *a) {
    if (!a->value) return 0;
    for (size_t k = 0; k < a->row[a->n]; k++)
        if (a->value[k] < 0) return 0;
    return 1;
}

/* Uniform in [-1, 1): splitmix64 (Steele, Lea & Flood 2014). */
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

/* Advances T, of norm 1, by dt.  Returns 0 if T is no longer finite. */
static int march_for(const struct heat_operator *a, double bound, double dt, double *T) {
    const enum stepper_name stepper = stepper_auto(1, 0, 0);
    struct march m = {.stepper = stepper,
                      .time = dt,
                      .steps = 1,
                      .stages = stepper_of(stepper)->count(dt, bound),
                      .lo = -HUGE_VAL,
                      .hi = HUGE_VAL,
                      .bound = bound};
    struct failure why;
    size_t bytes = 0;
    return m.stages <= STEPPER_STAGES_MAX && !stepper_march(a, &m, T, &bytes, &why);
}

/* Scales T to norm 1; returns the logarithm of its previous norm. */
static double normalise(double *T, size_t n) {
    double size = norm(T, n);
    for (size_t i = 0; i < n; i++) T[i] /= size;
    return log(size);
}

/* Advances T by dt and scales it to norm 1; returns the logarithm of the growth factor. */
static double grow_by_step(const struct heat_operator *a, double bound, double dt, double *T) {
    return march_for(a, bound, dt, T) ? normalise(T, a->n) : NAN;
}

/* Growth rate from the last of several steps of at most *length s.  A step with a factor that is not finite is
 * repeated with a shorter dt.  Stops early if the rate is below `least`, s^-1. */
static double iterate(const struct heat_operator *a, double bound, double least, double *T, double *length) {
    enum { STEPS = 4, MOST = 40, TRIES = 60 };
    double grown = 0, dt = *length, *kept = xcalloc(a->n, sizeof *kept);
    for (int k = 0, tries = 0; k < MOST && tries < TRIES; k++, tries++) {
        for (size_t i = 0; i < a->n; i++) kept[i] = T[i];
        double before = grown, shorter = 1;
        grown = grow_by_step(a, bound, dt, T);
        if (!isfinite(grown)) {
            for (size_t i = 0; i < a->n; i++) T[i] = kept[i];
            shorter = 16;
        } else if (grown > 1) {
            shorter = fmax(2, grown / 0.7);
        }
        if (shorter > 1) {
            dt /= shorter, k = -1, grown = 0; /* restarts the count */
            continue;
        }
        if (k >= STEPS - 1 && (grown < least * dt || fabs(grown - before) < 0.02 * grown)) break;
    }
    free(kept);
    *length = dt;
    return grown / dt;
}

/* RKL2's factor also exceeds 1 for decaying oscillations with a large |Im lambda| dt.  Only a growing mode keeps its
 * rate with shorter steps. */
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

/* The operator without walls' values and sources. */
static struct heat_operator homogeneous(const struct heat_operator *a) {
    struct heat_operator out = *a;
    out.g = NULL, out.constant = 0;
    return out;
}

/* n values of noise of norm 1, to be freed. */
static double *noise_create(size_t n) {
    double *T = xcalloc(n, sizeof *T);
    for (size_t i = 0; i < n; i++) T[i] = noise(i);
    normalise(T, n);
    return T;
}

double growth_rate(const struct heat_operator *a, double bound, double time) {
    if (!(time > 0) || !(bound > 0) || weights_show_none(a)) return 0;
    struct heat_operator own = homogeneous(a);
    double *T = noise_create(a->n), rate = confirm(&own, bound, time, T);
    free(T);
    return rate;
}

/* Replaces the noise by its change in a step, five times: modes that hardly change in a step are removed. */
static int keep_decaying(const struct heat_operator *a, double bound, double dt, double *T) {
    enum { TIMES = 5 };
    double *kept = xcalloc(a->n, sizeof *kept);
    int ok = 1;
    for (int k = 0; k < TIMES && ok; k++) {
        for (size_t i = 0; i < a->n; i++) kept[i] = T[i];
        ok = march_for(a, bound, dt, T);
        for (size_t i = 0; i < a->n; i++) T[i] -= kept[i];
        normalise(T, a->n);
    }
    free(kept);
    return ok;
}

/* Logarithm of the factor of the slowest remaining mode: the mean over the later half of the steps.  The iteration
 * ends when a mode with the average share of the noise, 1 / sqrt(n), would be a hundredth of the remainder. */
static double slowest(const struct heat_operator *a, double bound, double dt, double steps, double *T) {
    enum { MOST = 60 };
    const double gone = -log(100 * sqrt((double)a->n));
    double sum[MOST + 1] = {0};
    int k = 0;
    if (!keep_decaying(a, bound, dt, T)) return INFINITY;
    while (k < MOST && k < steps && sum[k] > gone) {
        double grown = grow_by_step(a, bound, dt, T);
        if (!isfinite(grown)) return INFINITY;
        sum[k + 1] = sum[k] + grown, k++;
    }
    return (sum[k] - sum[k / 2]) / (k - k / 2);
}

double growth_by_steps(const struct heat_operator *a, double bound, double dt, double steps) {
    const double least = log(0.8);
    struct heat_operator own = homogeneous(a);
    double *T = noise_create(a->n), grown = slowest(&own, bound, dt, steps, T);
    free(T);
    if (grown < least) return 0;
    /* growth of the equations themselves, which shorter steps do not remove */
    double rate = growth_rate(a, bound, dt * steps);
    return rate > 0 && rate * dt > grown / 2 ? 0 : exp(grown);
}
