/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choice of one fault among the fits: no other explains more of the error, and its size follows the spacing. */
#include "verification/fault/diagnosis.h"

#include "solver/field.h"
#include "verification/fault/fault_fits.h"
#include "verification/fault/wording.h"
#include "verification/text/json.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double INDISTINCT = 0.02; /* faults whose shares differ by less cannot be distinguished */

static int stays(const struct fault_fit *c) {
    return c->drift <= log(1 + FAULT_STEADY) && c->coarse.share >= FIT_SHARE - INDISTINCT;
}

/* Faults that a more common fault often explains as well: a clock with the same offset at every spacing (T depends
 * on kappa t only: a conductivity), and a coefficient of arbitrary size (one in the place of another). */
static int is_rare(const struct fault_fit *c) {
    int end = c->fault.kind == FAULT_CLOCK && strcmp(c->name, "s") == 0;
    return end || c->fault.kind == FAULT_AXIS || c->fault.kind == FAULT_RHO_C;
}

/* 1 if a is preferred to b: its size is more nearly constant or, if both are equally constant, it explains more. */
static int is_better(const struct fault_fit *a, const struct fault_fit *b) {
    static const double AS_WELL = 0.01;
    if (is_rare(a) != is_rare(b)) return is_rare(b);
    if (fabs(a->drift - b->drift) > AS_WELL) return a->drift < b->drift;
    return a->fine.share > b->fine.share;
}

unsigned diagnosis_sides(const struct problem *p, struct fault fault) {
    unsigned kinds = 0;
    for (int s = 0; s < 2 * p->dim; s++) {
        int across = fault.kind == FAULT_EXTENT && (s / 2 == fault.axis || fault.axis >= FAULT_BOTH_AXES);
        int held =
            fault.kind == FAULT_WALL && (s == fault.axis || (fault.axis == FAULT_ALL_SIDES && p->side[s] == NEUMANN));
        if (across || held) kinds |= 1u << p->side[s];
    }
    return kinds;
}

/* The kind of mean whose effect is the fraction `found` of the arithmetic mean's effect at a contact; effects are
 * proportional to 1/k - 1/harmonic.  It is the nearer of two, and another one if it is on the harmonic side of the
 * geometric mean by half of their distance.  A size is known to half of FAULT_STEADY: nearer means are not
 * distinguished.
 */
static int mean_of(const struct problem *p, double found) {
    double a = p->material[0].k[0], b = p->material[1].k[0], harmonic = (1 / a + 1 / b) / 2;
    double geometric = (1 / sqrt(a * b) - harmonic) / (2 / (a + b) - harmonic);
    double way = (found - geometric) / (1 - geometric); /* 0: geometric, 1: arithmetic */
    if (1 - geometric < FAULT_STEADY / 2) return MEAN_IS_EITHER;
    return way > 0.5 ? MEAN_IS_ARITHMETIC : way > -0.5 ? MEAN_IS_GEOMETRIC : MEAN_IS_OTHER;
}

static void name(const struct problem *p, const struct fault_fit *c, const struct diagnosis_rung *fine,
                 struct diagnosis *d) {
    int no_size = fault_is_whole(c->fault.kind) || c->fault.kind == FAULT_SAMPLES;
    d->named = 1;
    d->fault = c->fault;
    d->size = c->fine.size / c->unit[0] * (c->name[0] == '%' ? 100 : 1);
    d->unit = no_size ? "" : c->name;
    d->share = c->fine.share;
    d->sides = diagnosis_sides(p, c->fault);
    d->fourier = fine->dt * problem_diffusivity(p) / (fine->dx * fine->dx);
    if (c->fault.kind == FAULT_MEAN) d->fault.axis = mean_of(p, c->fine.size / c->unit[0]);
    wording_fault(d);
    d->is_pace = c->fault.kind == FAULT_CONDUCTIVITY && fault_is_pace(p); /* said where no other row excludes it */
}

/* A clock that is wrong by one step at one of the two rungs and right at the other. */
static int is_off_at_one(const struct fault_fit *c, struct diagnosis *d) {
    if (c->fault.kind != FAULT_CLOCK || strcmp(c->name, "steps") != 0) return 0;
    for (int k = 0; k < 2; k++) {
        const struct fit *off = k ? &c->coarse : &c->fine;
        double steps = c->steps[k];
        if (fabs(fabs(steps) - 1) > FAULT_STEADY || fabs(c->steps[1 - k]) > FAULT_STEADY || off->share < FIT_SHARE ||
            off->part < FIT_MOST)
            continue;
        *d = (struct diagnosis){.named = 1,
                                .fault = {FAULT_SOME_STEPS, 0},
                                .size = steps < 0 ? -1 : 1,
                                .unit = "steps",
                                .share = off->share};
        wording_fault(d);
        return 1;
    }
    return 0;
}

void diagnosis_find(const struct problem *p, const struct diagnosis_rung *fine, const struct diagnosis_rung *coarse,
                    struct diagnosis *d) {
    struct fault_fit c[FAULT_FITS];
    int n = fault_fits_all(p, (const struct diagnosis_rung[]){*fine, *coarse}, c), best = -1;
    double most = 0;
    *d = (struct diagnosis){.unit = ""};
    for (int i = 0; i < n; i++)
        if (c[i].fine.part >= FIT_MOST) most = fmax(most, c[i].fine.share);
    d->share = most;
    for (int i = 0; i < n; i++) {
        if (c[i].fine.part < FIT_MOST || c[i].fine.share < fmax(FIT_SHARE, most - INDISTINCT) || !stays(&c[i]))
            continue;
        if (best < 0 || is_better(&c[i], &c[best])) best = i;
    }
    if (best >= 0) {
        name(p, &c[best], fine, d);
        return;
    }
    for (int i = 0; i < n; i++)
        if (is_off_at_one(&c[i], d)) return;
    if (most >= FIT_SHARE)
        snprintf(d->what, sizeof d->what,
                 "no usual fault: what looks like one has a size that changes with the spacing%s",
                 fine->dt > 0 ? "" : "; `# steps = N` in the answer would show whether it is the clock");
    else if (most > 0)
        snprintf(d->what, sizeof d->what, "no usual fault explains more than %.0f %% of the error", 100 * most);
    else
        snprintf(d->what, sizeof d->what, "no usual fault explains more than a correct code's own part of the error");
}

int diagnosis_unstable(const struct diagnosis_rung *r, struct diagnosis *d) {
    static const double FAR = 100; /* times the size of the solution */
    double largest = 0, exact = 0;
    for (size_t i = 0; i < r->field->n; i++) {
        largest = fmax(largest, fabs(r->field->T[i] - r->exact[i]));
        if (isfinite(r->exact[i])) exact = fmax(exact, fabs(r->exact[i]));
    }
    int turns = 0; /* sign changes of the error from point to point */
    for (size_t i = 1; i < r->field->n; i++)
        turns += (r->field->T[i] - r->exact[i]) * (r->field->T[i - 1] - r->exact[i - 1]) < 0;
    if (!(largest > FAR * exact) || !(4 * turns > (int)r->field->n)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_UNSTABLE, 0}, .size = largest, .unit = "K", .share = NAN};
    wording_fault(d);
    return 1;
}

int diagnosis_repeat(double apart, double largest, struct diagnosis *d) {
    static const double SUMS = 1e-8; /* as whole/repeat: 1e6 round-off errors of 1e-16, a hundredfold */
    if (!(apart > SUMS * largest)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_NOISE, 0}, .size = apart, .unit = "K", .share = NAN};
    wording_fault(d);
    return 1;
}

void diagnosis_json(const struct diagnosis *d, struct json *j) {
    if (!d->named) {
        json_text(j, "diagnosis", NULL);
        return;
    }
    json_object(j, "diagnosis");
    json_add(j, "what %s|size %g|unit %s|share %g", d->what, d->size, d->unit, d->share);
    json_end(j);
}
