/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One row: the fault among the fits that no other beats and whose size follows the spacing; and faults that have a
 * test of their own. */
#include "verification/fault/diagnosis.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/fit.h"
#include "verification/fault/response.h"
#include "verification/fault/wording.h"
#include "verification/text/json.h"
#include "verification/text/number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double INDISTINCT = 0.02; /* faults whose shares differ by less cannot be distinguished */

static int stays(const struct fault_fit *c) {
    return c->drift <= log(1 + FIT_STEADY) && c->rung[1].share >= FIT_SHARE - INDISTINCT;
}

/* Faults that a more common fault often explains as well: a clock with the same offset at every spacing (T depends
 * on k t/rho c only: a conductivity), rho c, a coefficient of arbitrary size (one in the place of another), and
 * initial data of another size (a decay that is a little longer). */
static int rarity(const struct fault_fit *c) {
    if (c->fault.kind == FAULT_CLOCK && strcmp(c->name, "s") == 0) return 2;
    return c->fault.kind == FAULT_START_SIZE || c->fault.kind == FAULT_HEAT_CAPACITY ||
           fault_rows[c->fault.kind].is & FAULT_RARE;
}

/* 1 if a is preferred to b: its size is more nearly constant or, if both are equally constant, it explains more. */
static int is_better(const struct fault_fit *a, const struct fault_fit *b) {
    static const double AS_WELL = 0.01;
    if (rarity(a) != rarity(b)) return rarity(a) < rarity(b);
    if (fabs(a->drift - b->drift) > AS_WELL) return a->drift < b->drift;
    return a->rung[0].share > b->rung[0].share;
}

/* The kind of mean whose effect is the fraction `found` of the arithmetic mean's effect at a contact.  It is the
 * nearer of two, and another one if it is on the harmonic side of the geometric mean by half of their distance.  A
 * size is known to half of FIT_STEADY: nearer means are not distinguished. */
static int mean_of(double geometric, double found) {
    double way = (found - geometric) / (1 - geometric); /* 0: geometric, 1: arithmetic */
    if (1 - geometric < FIT_STEADY / 2) return MEAN_IS_EITHER;
    return way > 0.5 ? MEAN_IS_ARITHMETIC : way > -0.5 ? MEAN_IS_GEOMETRIC : MEAN_IS_OTHER;
}

struct diagnosis diagnosis_of(const struct fault_fit *c, const char *unit, double size) {
    struct diagnosis d = {
        .named = 1, .fault = c->fault, .size = size * (unit[0] == '%' ? 100 : 1), .sides = c->sides};
    d.unit = fault_rows[c->fault.kind].unit == UNIT_WHOLE ? "" : unit;
    d.fourier = c->step[0] / c->diffusive[0];
    if (c->fault.kind == FAULT_MEAN) d.fault.at = mean_of(c->geometric, size);
    wording_fault(&d);
    return d;
}

/* A clock that is wrong by one step at one of the two rungs and right at the other. */
static int is_off_at_one(const struct evidence *found, struct diagnosis *d) {
    for (int way = -1; way <= 1; way += 2) {
        int off[2];
        const double share = fit_some_steps(found, way, off);
        if (share < FIT_SHARE || off[0] == off[1]) continue;
        if (fit_first(found, FAULT_CLOCK)->rung[off[1]].part < FIT_MOST) continue;
        *d = (struct diagnosis){
            .named = 1, .fault = {FAULT_SOME_STEPS, 0}, .size = way, .unit = "steps", .share = share};
        wording_fault(d);
        return 1;
    }
    return 0;
}

/* Most faults of melting displace the front, and one row can often not tell them apart: 1 if what another leaves is
 * less than twice of what this one does. */
static int is_shared(const struct evidence *found, const struct fault_fit *best) {
    const double left = 1 - best->rung[0].share;
    for (int i = 0; i < found->n && found->melts; i++) {
        const struct fault_fit *c = &found->fit[i];
        if (c->fault.kind != best->fault.kind && stays(c) && 1 - c->rung[0].share < 2 * left) return 1;
    }
    return 0;
}

/* PACE_... of the faults with the share of *best, if it is one of them. */
static unsigned paces(const struct evidence *found, const struct fault_fit *best) {
    unsigned all = 0;
    for (int i = 0; i < found->n; i++) {
        const struct fault_fit *c = &found->fit[i];
        const char *unit = c->fault.kind == FAULT_CLOCK && strcmp(c->name, "s") == 0 ? "%" : c->name;
        if (stays(c) && c->rung[0].share > best->rung[0].share - INDISTINCT) all |= fit_pace(c->fault.kind, unit);
    }
    return fit_pace(best->fault.kind, best->name) ? all : 0;
}

void diagnosis_choose(const struct evidence *found, struct diagnosis *d) {
    const int n = found ? found->n : 0;
    const struct fault_fit *c = found ? found->fit : NULL;
    int best = -1;
    double most = 0;
    *d = (struct diagnosis){.unit = ""};
    for (int i = 0; i < n; i++)
        if (c[i].rung[0].part >= FIT_MOST) most = fmax(most, c[i].rung[0].share);
    d->share = most;
    for (int i = 0; i < n; i++) {
        const struct fit *fine = &c[i].rung[0];
        if (fine->part < FIT_MOST || fine->share < fmax(FIT_SHARE, most - INDISTINCT) || !stays(&c[i])) continue;
        if (best < 0 || is_better(&c[i], &c[best])) best = i;
    }
    if (best >= 0 && is_shared(found, &c[best])) {
        snprintf(d->what, sizeof d->what, "a front that is displaced, for which several faults explain as much");
        return;
    }
    if (best >= 0) {
        *d = diagnosis_of(&c[best], c[best].name, c[best].rung[0].size / c[best].unit[0]);
        d->share = c[best].rung[0].share;
        d->paces = paces(found, &c[best]);
        wording_fault(d);
        return;
    }
    if (is_off_at_one(found, d)) return;
    if (most >= FIT_SHARE)
        snprintf(d->what, sizeof d->what,
                 "no usual fault: what looks like one has a size that changes with the spacing%s",
                 c[0].step[0] > 0 ? "" : "; `# steps = N` in the answer would show whether it is the clock");
    else if (most > 0)
        snprintf(d->what, sizeof d->what, "no usual fault explains more than %.0f %% of the error", 100 * most);
    else
        snprintf(d->what, sizeof d->what, "no usual fault explains more than a correct code's own part of the error");
}

void diagnosis_whole_steps(double late, struct diagnosis *d) {
    const int at = late > 0 ? STEPS_LATE : STEPS_EARLY;
    const double share = fit_whole_steps(d->evidence, at, fabs(late));
    if (share < FIT_SHARE) return;
    const struct fault_fit *clock = fit_first(d->evidence, FAULT_CLOCK);
    if (at == STEPS_EARLY && stays(clock) && strcmp(clock->name, "s") != 0) return; /* one step too few */
    free(d->evidence);
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_WHOLE_STEPS, at}, .size = 1, .unit = "", .share = share};
    wording_fault(d);
}

/* The sides next to which, in one layer of cells, seven tenths of the squared error are. */
static unsigned beside(const struct problem *p, const struct diagnosis_rung *r) {
    static const double MOST = 0.7, LAYER = 1.01; /* cells; a node beside a held wall is one away */
    double all = 0, layer[SIDES] = {0};
    unsigned sides = 0;
    for (size_t i = 0; i < r->field->n; i++) {
        double x[DIM_MAX], e = r->field->T[i] - r->exact[i];
        field_place(r->field, i, x);
        if (!isfinite(e)) continue;
        all += e * e;
        for (int s = 0; s < 2 * p->dim; s++)
            if (fabs(x[s / 2] - (s % 2 ? p->hi[s / 2] : p->lo[s / 2])) < LAYER * r->dx) layer[s] += e * e;
    }
    for (int s = 0; s < 2 * p->dim; s++)
        if (layer[s] > MOST * all) sides |= 1u << s;
    return sides;
}

void diagnosis_find(const struct problem *p, const struct diagnosis_rung *fine, const struct diagnosis_rung *coarse,
                    struct diagnosis *d) {
    struct evidence *found = fit_all(p, (const struct diagnosis_rung[]){*fine, *coarse});
    diagnosis_choose(found, d);
    d->evidence = found;
    d->beside = beside(p, fine);
}

int diagnosis_unstable(const struct diagnosis_rung *r, struct diagnosis *d) {
    static const double FAR = 100, OVERFLOW = 1e20; /* times the size of the solution */
    double largest = 0, exact = 0;
    for (size_t i = 0; i < r->field->n; i++) {
        if (!isfinite(r->exact[i])) continue; /* a corner where held sides disagree */
        largest = fmax(largest, fabs(r->field->T[i] - r->exact[i]));
        exact = fmax(exact, fabs(r->exact[i]));
    }
    int turns = 0; /* sign changes of the error from point to point */
    for (size_t i = 1; i < r->field->n; i++)
        turns += (r->field->T[i] - r->exact[i]) * (r->field->T[i - 1] - r->exact[i - 1]) < 0;
    int is_overflow = largest > OVERFLOW * exact;
    if (!(largest > FAR * exact) || !(is_overflow || 4 * turns > (int)r->field->n)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_UNSTABLE, 0}, .size = largest, .unit = "K", .share = NAN};
    wording_fault(d);
    return 1;
}

/* A few round-off errors of the largest value: temperatures mapped back to the scene (references/mapping.h) have
 * them. */
static const double CLOSE = 16 * DBL_EPSILON;

int diagnosis_cut(const struct problem *p, const struct diagnosis_rung *r, struct diagnosis *d) {
    enum { LEAST = 3, PART = 50 };     /* points, and 1/50 of all: mirrored points are equal too */
    static const double BEYOND = 0.01; /* parts of the solution's range, above rounding */
    const struct field *f = r->field;
    const double off = CLOSE * field_largest(f);
    double lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < f->n; i++)
        if (isfinite(r->exact[i])) lo = fmin(lo, r->exact[i]), hi = fmax(hi, r->exact[i]);
    for (int at = CUT_BELOW; at <= CUT_ABOVE; at++) {
        const double sign = at == CUT_BELOW ? 1 : -1;
        double last = INFINITY;
        int n = 0;
        for (size_t i = 0; i < f->n; i++) last = fmin(last, sign * f->T[i]);
        for (size_t i = 0; i < f->n; i++) {
            double x[DIM_MAX];
            field_place(f, i, x);
            n += sign * f->T[i] - last <= off && last - sign * r->exact[i] > BEYOND * (hi - lo) &&
                 fabs(f->T[i] - p->initial(p, x)) > off; /* or nothing has reached the point */
        }
        if (n < LEAST || n * PART < (int)f->n) continue;
        *d = (struct diagnosis){.named = 1, .fault = {FAULT_CUT, at}, .size = 1, .unit = "", .share = NAN};
        wording_fault(d);
        return 1;
    }
    return 0;
}

void diagnosis_overflow(struct diagnosis *d) {
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_UNSTABLE, 0}, .unit = "", .share = NAN};
    wording_fault(d);
}

void diagnosis_exchanged(int pair, struct diagnosis *d) {
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_TRANSPOSED, pair}, .size = 1, .unit = "", .share = NAN};
    wording_fault(d);
}

int diagnosis_repeat(double apart, double largest, struct diagnosis *d) {
    static const double SUMS = 1e-8; /* as whole/repeat: 1e6 round-off errors of 1e-16, a hundredfold */
    if (!(apart > SUMS * largest)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_NOISE, 0}, .size = apart, .unit = "K", .share = NAN};
    wording_fault(d);
    return 1;
}

/* ---- Few digits ----
 *
 * An explicit step that changes T by less than half a unit of its last digit, u |T|, changes nothing.  The run
 * stalls where F times the second difference is that small.  The error of a steady state is therefore up to N^2/8
 * u/F for N cells, N^2 u at F = 1/8.  A larger error has another cause. */

int diagnosis_rounding(const struct field *f, double error, double cells, struct diagnosis *d) {
    enum { MOST = 9, LEAST = 10, ROUND = 4 }; /* digits; ten values of more than ROUND are not round by chance */
    int digits = 0, full = 0;
    const double off = CLOSE * field_largest(f);
    char text[NUMBER_PRINTED];
    for (size_t i = 0; i < f->n && digits <= MOST; i++) {
        double T = f->T[i];
        int single = fabs(T - (float)T) <= off;
        int of = number_digits(T, T == 0 ? 0 : off / fabs(T), MOST, text);
        if (single && of > FLT_DIG + 1) of = FLT_DIG + 1;
        full += of > ROUND;
        digits = of > digits ? of : digits;
    }
    double unit = 0.5 * pow(10, 1 - digits);
    if (digits > MOST || full < LEAST || !(error <= cells * cells * unit)) return 0;
    *d = (struct diagnosis){.named = 1, .fault = {FAULT_DIGITS, 0}, .size = digits, .unit = "digits", .share = NAN};
    wording_fault(d);
    return 1;
}

/* ---- Values or means ---- */

/* dx^2/24 laplace(T) of the initial data, K, by differences within the cell; NAN next to a side. */
static double start_mean(const struct problem *p, const struct diagnosis_rung *r, size_t i) {
    const double d = r->dx / 8;
    double at[DIM_MAX], sum = 0;
    field_place(r->field, i, at);
    for (int a = 0; a < p->dim; a++) {
        double above[DIM_MAX] = {at[0], at[1], at[2]}, below[DIM_MAX] = {at[0], at[1], at[2]};
        above[a] += d, below[a] -= d;
        if (below[a] < p->lo[a] || above[a] > p->hi[a]) return NAN;
        sum += p->initial(p, above) - 2 * p->initial(p, at) + p->initial(p, below);
    }
    return r->dx * r->dx / 24 * sum / (d * d);
}

double diagnosis_mean(const struct problem *p, const struct diagnosis_rung *start) {
    double ee = 0, em = 0, mm = 0;
    if (p->materials > 1 || p->jumps[0] + p->jumps[1] + p->jumps[2] > 0 || p->source) return NAN;
    for (size_t i = 0; i < start->field->n; i++) {
        double e = start->field->T[i] - start->exact[i], m = start_mean(p, start, i);
        if (isfinite(e) && isfinite(m)) ee += e * e, em += e * m, mm += m * m;
    }
    return mm > 0 && ee - em * em / mm <= (1 - FIT_SHARE) * fmax(ee, mm) ? em / mm : NAN;
}

/* ---- Data of another time ----
 *
 * Data of another time than that of their stage, from two answers on one grid whose steps differ by dt.  An error of
 * order 1 in time differs between them by
 *
 *     T_2 - T_1 = n dt R + c h,   0 <= c
 *
 * with the response R to data that are taken n steps late, K/s, and h of Euler's method.  The errors in space cancel.
 */

/* Sum of products over the points. */
static double product(size_t n, const double *a, const double *b) {
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/* Fits `apart` by r and h; returns the share of its square, with the factor of r in *size. */
static double fit_both(size_t n, const double *apart, const double *r, const double *h, double *size) {
    double ar = product(n, apart, r), ah = product(n, apart, h), rr = product(n, r, r), rh = product(n, r, h);
    double hh = product(n, h, h), aa = product(n, apart, apart), det = rr * hh - rh * rh, c = 0;
    if (!(rr > 0 && aa > 0)) return 0;
    if (det > 1e-6 * rr * hh) c = (ah * rr - ar * rh) / det;
    if (c < 0) c = 0;
    *size = (ar - c * rh) / rr;
    return (*size * ar + c * ah) / aa;
}

void diagnosis_steps(const struct problem *p, const struct field *f, const double *apart, double dt,
                     struct diagnosis *d) {
    static const double SAME = 0.25;
    static const enum fault_kind kinds[] = {FAULT_WALL_TIME, FAULT_SOURCE_TIME};
    struct response_lattice l;
    *d = (struct diagnosis){.unit = "steps"};
    if (!(dt > 0) || response_lattice_create(p, &l)) return;
    double *array[3], size; /* base, h, R */
    for (int k = 0; k < 3; k++) array[k] = xcalloc(f->n, sizeof **array);
    response_base(p, &l, f, array[0], array[1]);
    double best = FIT_SHARE, euler = fit_both(f->n, apart, array[1], array[1], &size);
    double due = dt * problem_diffusivity(p) / (l.dx * l.dx);
    int is_euler = euler >= FIT_SHARE && fabs(fabs(size) / due - 1) < SAME; /* explicit or implicit steps */
    for (int k = 0; k < 2 && !is_euler; k++) {
        struct fault fault = {kinds[k], 0};
        struct response r;
        if (response_take(p, &l, fault, 0, &r)) continue;
        response_at(&r, &l, f, array[0], array[2]);
        response_free(&r);
        double share = fit_both(f->n, apart, array[2], array[1], &size);
        if (share < best) continue;
        best = share;
        d->named = 1, d->fault = fault, d->size = size / dt, d->share = share;
    }
    for (int k = 0; k < 3; k++) free(array[k]);
    response_lattice_free(&l);
    if (d->named) wording_fault(d);
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
