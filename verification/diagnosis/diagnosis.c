/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One field cannot distinguish faults with similar responses (without a source T depends on kappa t alone).  The
 * dependence of the size on the spacing can: a clock is wrong by a number of steps, a position by a number of cells,
 * a coefficient by a fraction of itself. */
#include "verification/diagnosis/diagnosis.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/diagnosis/fit.h"
#include "verification/diagnosis/response.h"
#include "verification/diagnosis/wording.h"
#include "verification/text/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double INDISTINCT = 0.02; /* faults whose shares differ by less cannot be distinguished */
/* Relative change of a size from rung to rung below which it counts as constant: the finest spacings of the battery
 * have the ratio 4/3, by which a size in a unit with another power of dx changes at least. */
static const double STEADY = 0.25;
static const double LEAST_MEAN =
    0.3; /* least fraction of the arithmetic mean's effect for which another mean is detected */
enum { POINTS = 20000, FAULTS = 120 };

struct candidate_fault {
    struct fault fault;
    struct fit fine, coarse;
    double unit[2];   /* the unit of the size at the fine and the coarse rung: a step, a cell, or 1 */
    double drift;     /* |log| of the change of the size in its unit; INFINITY if the size is not constant */
    const char *name; /* name of the unit */
    double steps[2];  /* for a clock with known steps: the size at both rungs */
};

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

static int list_faults(const struct problem *p, struct fault *list) {
    static const struct {
        enum fault_kind kind;
        int count; /* number of axes, sides or corners */
    } kinds[] = {{FAULT_CLOCK, 1},
                 {FAULT_CONDUCTIVITY, 1},
                 {FAULT_SWAP, FAULT_PAIRS},
                 {FAULT_TRANSPOSED, FAULT_PAIRS},
                 {FAULT_SOURCE, 1},
                 {FAULT_CAPACITY, 1},
                 {FAULT_INTERFACE, 1},
                 {FAULT_MEAN, 1},
                 {FAULT_AMPLITUDE, 1},
                 {FAULT_SOURCE_TIME, 1},
                 {FAULT_FROZEN, 1},
                 {FAULT_DIFFUSIVITY, 1},
                 {FAULT_OFFSET, 1},
                 {FAULT_NEAR_WALL, 1},
                 {FAULT_ISOTROPIC, FAULT_OTHERS},
                 {FAULT_EXTENT, FAULT_ALL_AXES + 1},
                 {FAULT_START_SHIFT, DIM_MAX},
                 {FAULT_START_WIDTH, DIM_MAX},
                 {FAULT_SAMPLES, DIM_MAX},
                 {FAULT_WALL, FAULT_ALL_SIDES + 1},
                 {FAULT_CORNER, FAULT_CORNERS},
                 {FAULT_WALL_TIME, 1},
                 {FAULT_WALL_FROZEN, 1},
                 {FAULT_COEFFICIENT, FAULT_ALL_SIDES + 1},
                 {FAULT_LAW, LAWS},
                 {FAULT_AXIS, DIM_MAX},
                 {FAULT_RHO_C, 2}};
    int n = 0;
    struct faulty ignored;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int a = 0; a < kinds[i].count; a++) {
            list[n] = (struct fault){kinds[i].kind, a};
            n += fault_make(p, list[n], 0, &ignored);
        }
    return n;
}

/* Outward displacement, m, of the jumps of the initial data, if they are midway between the adjacent points along an
 * axis; 0 if they do not agree. */
static double displacement(const struct problem *p, int axis, const struct diagnosis_rung *r) {
    double out = 0;
    for (int k = 0; k < p->jumps[axis]; k++) {
        double at = p->jump[axis][k], below = -INFINITY, above = INFINITY;
        for (size_t i = 0; i < r->field->n; i++) {
            double x[DIM_MAX], place = field_place(r->field, i, x)[axis];
            if (place < at)
                below = fmax(below, place);
            else
                above = fmin(above, place);
        }
        double moved = (2 * k < p->jumps[axis] ? -1 : 1) * ((below + above) / 2 - at);
        if (k && fabs(moved - out) > 1e-6 * r->dx) return 0;
        out = moved;
    }
    return fabs(out) > 1e-6 * r->dx ? out : 0;
}

static const char DIFFUSIVE[] = "dx^2/kappa"; /* a unit of time */

/* |log| of the change of the size from rung to rung in these units. */
static double drift(const struct candidate_fault *c, double fine, double coarse) {
    double ratio = c->coarse.size / coarse / (c->fine.size / fine);
    return ratio > 0 ? fabs(log(ratio)) : INFINITY;
}

/* Finds the unit in which the size of a fault is constant from rung to rung, and the remaining change.  If a program
 * does not report its time steps, they may have a fixed length or be a fraction of dx^2/kappa. */
static void follow(const struct problem *p, struct candidate_fault *c, const struct diagnosis_rung *fine,
                   const struct diagnosis_rung *coarse) {
    int place = c->fault.kind == FAULT_EXTENT || c->fault.kind == FAULT_START_SHIFT ||
                c->fault.kind == FAULT_START_WIDTH || c->fault.kind == FAULT_INTERFACE ||
                c->fault.kind == FAULT_MEAN || c->fault.kind == FAULT_NEAR_WALL;
    int in_time =
        c->fault.kind == FAULT_CLOCK || c->fault.kind == FAULT_SOURCE_TIME || c->fault.kind == FAULT_WALL_TIME;
    int clock = in_time && fine->dt > 0 && coarse->dt > 0;
    c->unit[0] = clock ? fine->dt : place ? fine->dx : 1;
    c->unit[1] = clock ? coarse->dt : place ? coarse->dx : 1;
    if (c->fault.kind == FAULT_SAMPLES)
        c->unit[0] = displacement(p, c->fault.axis, fine), c->unit[1] = displacement(p, c->fault.axis, coarse);
    c->name = clock ? "steps" : in_time ? "s" : place ? "cells" : c->fault.kind == FAULT_OFFSET ? "K" : "%";
    if (clock) c->steps[0] = c->fine.size / fine->dt, c->steps[1] = c->coarse.size / coarse->dt;
    c->drift = drift(c, c->unit[0], c->unit[1]);
    double diffusive[2] = {pow(fine->dx, 2) / problem_diffusivity(p), pow(coarse->dx, 2) / problem_diffusivity(p)};
    if (in_time && !clock && drift(c, diffusive[0], diffusive[1]) < c->drift) {
        memcpy(c->unit, diffusive, sizeof diffusive);
        c->name = DIFFUSIVE;
        c->drift = drift(c, c->unit[0], c->unit[1]);
    }
    if (c->fault.kind == FAULT_WALL_TIME && drift(c, 1, 1) < c->drift) { /* a phase */
        c->unit[0] = c->unit[1] = 1;
        c->name = "s";
        c->drift = drift(c, 1, 1);
    }
    double due = c->fault.kind == FAULT_NEAR_WALL ? 0.5 : 1, found = c->fine.size / c->unit[0] / due;
    int whole = fault_is_whole(c->fault.kind) || c->fault.kind == FAULT_NEAR_WALL || c->fault.kind == FAULT_SAMPLES;
    if (whole && !(fabs(found - 1) <= STEADY)) c->drift = INFINITY;
    if (c->fault.kind == FAULT_MEAN && !(found > LEAST_MEAN && found < 1 + STEADY)) c->drift = INFINITY;
}

/* About POINTS points of a rung, evenly spaced in its order; `drop` frees the arrays. */
static struct diagnosis_rung sample(const struct diagnosis_rung *r, struct field *f) {
    size_t stride = r->field->n / POINTS + 1;
    if (stride > 1) stride |= 1; /* so that the stride does not select columns of a lattice */
    size_t n = (r->field->n + stride - 1) / stride;
    double *exact = xcalloc(n, sizeof *exact);
    field_alloc(f, r->field->dim, n);
    f->weight = r->field->weight ? xcalloc(n, sizeof *f->weight) : NULL;
    for (size_t i = 0; i < n; i++) {
        double x[DIM_MAX];
        field_put(f, i, field_place(r->field, i * stride, x));
        if (f->weight) f->weight[i] = r->field->weight[i * stride];
        f->T[i] = r->field->T[i * stride];
        exact[i] = r->exact[i * stride];
    }
    return (struct diagnosis_rung){f, exact, r->dx, r->dt, r->mean};
}

static void drop(struct diagnosis_rung *r, struct field *f) {
    free((void *)r->exact);
    field_free(f);
}

/* Two rungs, the fine one first, and the data for the responses to faults. */
struct looked_at {
    const struct problem *p;
    const struct response_lattice *l;
    const struct diagnosis_rung *rung;
    struct fit_errors errors[2];
    double *base[2], *response;
};

/* Both fits of a fault with its response at that size (0: a small size).  Returns 0, or -1 if there is no
 * response. */
static int fit_at(const struct looked_at *at, struct fault fault, double size, struct fit fit[2]) {
    struct response r = {.size = 0};
    int corner = fault.kind == FAULT_CORNER, near = fault.kind == FAULT_NEAR_WALL, failed = 0;
    if (!corner && !near) failed = response_take(at->p, at->l, fault, size, &r);
    for (int k = 0; k < 2 && !failed; k++) {
        const struct field *f = at->rung[k].field;
        if (near) response_free(&r);
        if (near) failed = response_take(at->p, at->l, fault, at->rung[k].dx / 2, &r); /* the size is then known */
        if (failed) break;
        if (corner)
            failed = response_at_corner(at->p, at->rung[k].dx, fault, f, at->response);
        else
            response_at(&r, at->l, f, at->base[k], at->response);
        if (!failed) fit[k] = fit_fault(&at->errors[k], at->response);
    }
    response_free(&r);
    return failed;
}

/* The response to a coefficient is not linear.  It is therefore evaluated again at the size s of the previous fit,
 * which gives a size f(s), until the two agree.  The next s follows from the secant through the last two f: for a
 * wall of almost no resistance f = -(1 + s), for which the fixed-point iteration s = f would not converge. */
static int fit_bent(const struct looked_at *at, struct fault fault, struct fit fit[2]) {
    enum { ROUNDS = 6 };
    static const double LARGE = 0.05, MOST = 3, SAME = 0.01, LIKELY = 0.5, STEEP = 0.9;
    const double least = fault.kind == FAULT_COEFFICIENT ? -1 : -0.9; /* b may be 0, k and rho c may not */
    int failed = fit_at(at, fault, 0, fit);
    double before[2] = {0, fit[0].size}, s = before[1];
    for (int round = 0; round < ROUNDS && !failed && fault_bends(fault.kind); round++) {
        if (!(fit[0].share > LIKELY && fit[0].part > FIT_MOST && fabs(s) > LARGE)) break;
        s = fmin(fmax(s, least), MOST);
        failed = fit_at(at, fault, s, fit);
        double found = fit[0].size, slope = (found - before[1]) / (s - before[0]);
        if (failed || fabs(found - s) <= SAME * fabs(found)) break;
        before[0] = s, before[1] = found;
        s = slope < STEEP ? (found - slope * s) / (1 - slope) : found;
    }
    return failed;
}

static int fit_all(const struct problem *p, const struct diagnosis_rung *rung, struct candidate_fault *c) {
    struct response_lattice l;
    struct fault list[FAULTS];
    int n = 0, faults = list_faults(p, list);
    if (response_lattice_create(p, &l)) return 0;
    struct looked_at at = {.p = p, .l = &l, .rung = rung};
    for (int k = 0; k < 2; k++) {
        double dx2 = pow(rung[k].dx / l.dx, 2);
        at.errors[k] = fit_errors(p, &l, &rung[k]);
        at.base[k] = xcalloc(rung[k].field->n, sizeof **at.base);
        for (size_t i = 0; i < rung[k].field->n; i++) at.base[k][i] = at.errors[k].g[i] / dx2 + rung[k].exact[i];
    }
    at.response = xcalloc(rung[0].field->n + rung[1].field->n, sizeof *at.response);
    for (int i = 0; i < faults; i++) {
        struct fit fit[2];
        if (fit_bent(&at, list[i], fit) || !fault_can_be(p, list[i].kind, fit[0].size)) continue;
        c[n] = (struct candidate_fault){.fault = list[i], .fine = fit[0], .coarse = fit[1]};
        follow(p, &c[n++], &rung[0], &rung[1]);
    }
    for (int k = 0; k < 2; k++) {
        free(at.base[k]);
        fit_errors_free(&at.errors[k]);
    }
    free(at.response);
    response_lattice_free(&l);
    return n;
}

static int stays(const struct candidate_fault *c) {
    return c->drift <= log(1 + STEADY) && c->coarse.share >= FIT_SHARE - INDISTINCT;
}

/* Faults that a more common fault often explains as well: a clock with the same offset at every spacing (T depends
 * on kappa t only: a conductivity), and a coefficient of arbitrary size (one in the place of another). */
static int is_rare(const struct candidate_fault *c) {
    int end = c->fault.kind == FAULT_CLOCK && strcmp(c->name, "s") == 0;
    return end || c->fault.kind == FAULT_AXIS || c->fault.kind == FAULT_RHO_C;
}

/* 1 if a is preferred to b: its size is more nearly constant or, if both are equally constant, it explains more. */
static int is_better(const struct candidate_fault *a, const struct candidate_fault *b) {
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
 * geometric mean by half of their distance.  A size is known to half of STEADY: nearer means are not distinguished.
 */
static int mean_of(const struct problem *p, double found) {
    double a = p->material[0].k[0], b = p->material[1].k[0], harmonic = (1 / a + 1 / b) / 2;
    double geometric = (1 / sqrt(a * b) - harmonic) / (2 / (a + b) - harmonic);
    double way = (found - geometric) / (1 - geometric); /* 0: geometric, 1: arithmetic */
    if (1 - geometric < STEADY / 2) return MEAN_IS_EITHER;
    return way > 0.5 ? MEAN_IS_ARITHMETIC : way > -0.5 ? MEAN_IS_GEOMETRIC : MEAN_IS_OTHER;
}

static void name(const struct problem *p, const struct candidate_fault *c, const struct diagnosis_rung *fine,
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
static int is_off_at_one(const struct candidate_fault *c, struct diagnosis *d) {
    if (c->fault.kind != FAULT_CLOCK || strcmp(c->name, "steps") != 0) return 0;
    for (int k = 0; k < 2; k++) {
        const struct fit *off = k ? &c->coarse : &c->fine;
        double steps = c->steps[k];
        if (fabs(fabs(steps) - 1) > STEADY || fabs(c->steps[1 - k]) > STEADY || off->share < FIT_SHARE ||
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
    struct candidate_fault c[FAULTS];
    struct field field[2];
    struct diagnosis_rung sampled[2] = {sample(fine, &field[0]), sample(coarse, &field[1])};
    int n = fit_all(p, sampled, c), best = -1;
    double most = 0;
    for (int i = 0; i < 2; i++) drop(&sampled[i], &field[i]);
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

/* The size of *d at spacing dx, in the unit of its fault. */
static double size_at(const struct problem *p, const struct diagnosis *d, double dx) {
    double diffusive = dx * dx / problem_diffusivity(p);
    if (strcmp(d->unit, "cells") == 0) return d->size * dx;
    if (strcmp(d->unit, "%") == 0) return d->size / 100;
    if (strcmp(d->unit, "steps") == 0) return d->size * d->fourier * diffusive;
    if (strcmp(d->unit, DIFFUSIVE) == 0) return d->size * diffusive;
    return *d->unit ? d->size : 1;
}

double diagnosis_effect(const struct problem *p, const struct diagnosis *d, double dx, double zero) {
    struct response_lattice l;
    struct response r;
    struct fault fault = d->fault;
    double size = size_at(p, d, dx), sum = 0, whole = 0;
    if (fault.kind == FAULT_MEAN) fault.axis = 0;
    if (fault.kind == FAULT_CORNER || fault.kind == FAULT_SAMPLES || response_lattice_create(p, &l)) return NAN;
    int failed = response_take(p, &l, fault, fault_bends(fault.kind) || fault.kind == FAULT_NEAR_WALL ? size : 0, &r);
    if (!failed) {
        struct field f;
        field_alloc_lattice(&f, p->dim, l.n);
        for (int a = 0; a < p->dim; a++)
            for (int i = 0; i < l.n[a]; i++) f.x[a][i] = p->lo[a] + (i + 0.5) * l.dx;
        response_at(&r, &l, &f, l.T, f.T);
        for (size_t i = 0; i < f.n; i++) sum += fabs(size * f.T[i]), whole += fabs(l.T[i] - zero);
        field_free(&f);
        response_free(&r);
    }
    response_lattice_free(&l);
    return failed ? NAN : sum / whole;
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
