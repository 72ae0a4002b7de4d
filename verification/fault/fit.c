/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least squares of the error field e with the response f of one fault at a time, in addition to the discretization
 * errors of second-order differences at the same spacing: in space g, in time (Euler's, at mesh Fourier number 1) h,
 *
 *     e = size f + b g + c h + d m,    |b| <= 2,  |c| <= 1/2,  |d| <= 2
 *
 * since a faulty code has discretization errors too. m = dx^2/24 laplace(T) is the difference between a cell mean
 * and the value at its centre.  The numbers of a code are values (d = 0), cell means (1), or linear elements with
 * projected initial data (-2 at their nodes, 2 with a lumped mass). d is constant in time, because d m evolves like
 * T, unless a source adds values to means.  An answer at the start determines d (diagnosis_mean), and its part is
 * subtracted from e.  Without one, if m resembles the fault (for one material without a source it is dx^2/(24 kappa)
 * dT/dt, a clock that is fast by a sixth of a step at F = 1/4), no fit can separate them, and d = 1/2, between
 * values and means, is used.  For data with jumps, where means are values on faces, g already includes it: d = 0.
 *
 * A fault with |size f| below twice |g + h/5| or three times |m|, more than any of these d differ from 1/2, is not
 * reported: that is the size of a correct code's error.  The 5 % of the points with the largest g (discontinuous
 * corners) are excluded. */
#include "verification/fault/fit.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/fault/diagnosis.h"
#include "verification/fault/response.h"
#include "verification/text/output.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 20000, E = 0, SIZE = 1 };

/* Minimizes |sum of x v|^2 over the coefficients from `first` on, in turn until they converge: at most four numbers,
 * three of them bounded.  Returns what is left. */
static double least(const struct fit *s, int first, double x[FIT_FIELDS]) {
    static const double most[FIT_FIELDS] = {1, INFINITY, FIT_MOST, 0.5, FIT_MOST};
    double left = 0, moved = 1;
    for (int round = 0; round < ROUNDS && moved > 1e-14; round++) {
        moved = 0;
        for (int k = first; k < s->numbers; k++) {
            double rest = 0, before = x[k];
            for (int l = 0; l < FIT_FIELDS; l++) rest -= l == k ? 0 : s->product[k][l] * x[l];
            x[k] = s->product[k][k] > 0 ? fmax(-most[k], fmin(most[k], rest / s->product[k][k])) : 0;
            moved = fmax(moved, fabs(x[k] - before) / fmax(fabs(before), 1e-9));
        }
    }
    for (int k = 0; k < FIT_FIELDS; k++)
        for (int l = 0; l < FIT_FIELDS; l++) left += x[k] * s->product[k][l] * x[l];
    return left;
}

struct fit fit_fault(const struct fit_errors *s, const double *f) {
    struct fit fit = {.size = 0};
    double(*a)[FIT_FIELDS] = fit.product;
    for (size_t i = 0; i < s->field->n; i++) {
        double w = s->field->weight ? s->field->weight[i] : 1;
        const double v[FIT_FIELDS] = {s->e[i], f[i], s->g[i], s->h[i], s->m[i]};
        if (!isfinite(v[E])) continue;
        for (int k = 0; k < FIT_FIELDS; k++)
            for (int l = 0; l < FIT_FIELDS; l++) a[k][l] += w * v[k] * v[l];
    }
    if (!(a[E][E] > 0 && a[SIZE][SIZE] > 0)) return (struct fit){.size = 0};
    double x[FIT_FIELDS] = {-1, 0, 0, 0, s->is_mean ? 0.5 : 0}; /* x.v is the residual */
    fit.numbers = s->is_mean && a[1][4] * a[1][4] < FIT_SHARE * a[1][1] * a[4][4] ? FIT_FIELDS : FIT_FIELDS - 1;
    double left = least(&fit, SIZE, x), natural = a[2][2] + 0.4 * a[2][3] + 0.04 * a[3][3] + 2.25 * a[4][4];
    fit.mean = x[4];
    fit.size = x[SIZE], fit.share = 1 - left / a[E][E];
    fit.part = fabs(x[SIZE]) * sqrt(a[SIZE][SIZE] / fmax(natural, 1e-300));
    return fit;
}

double fit_share(const struct fit *fit, double size) {
    double x[FIT_FIELDS] = {-1, size, 0, 0, fit->mean};
    return fit->product[E][E] > 0 ? 1 - least(fit, SIZE + 1, x) / fit->product[E][E] : 0;
}

/* At a front a correct code has the error of a front dx/4 away on average, 2 g, and up to dx/2. */
static void front_errors(const struct problem *p, const struct response_lattice *l, const struct diagnosis_rung *r,
                         const double *base, double *g) {
    struct response moved;
    memset(g, 0, r->field->n * sizeof *g);
    if (response_take(p, l, (struct fault){FAULT_START_SHIFT, 0}, l->dx, &moved)) return;
    response_at(&moved, l, r->field, base, g);
    for (size_t i = 0; i < r->field->n; i++) g[i] *= r->dx / 8;
    response_free(&moved);
}

struct fit_errors fit_errors(const struct problem *p, const struct response_lattice *l,
                             const struct diagnosis_rung *r, double *base) {
    const struct field *f = r->field;
    const int melts = p->k_law == K_PHASES;
    const int is_mean = p->jumps[0] + p->jumps[1] + p->jumps[2] == 0 && p->materials == 1 && !melts;
    struct fit_errors s = {.field = f, .is_mean = is_mean};
    double **const owned[] = {&s.e, &s.g, &s.h, &s.m};
    for (int k = 0; k < 4; k++) *owned[k] = xcalloc(f->n, sizeof(double));
    double *size = xcalloc(f->n, sizeof *size), dx2 = pow(r->dx / l->dx, 2);
    response_base(p, l, f, base, s.h);
    struct response clock;
    if (melts) {
        front_errors(p, l, r, base, s.g);
    } else if (p->materials == 1) {
        response_laplacian(p, l, f, s.m);
    } else if (!response_take(p, l, (struct fault){FAULT_CLOCK, 0}, 0, &clock)) {
        response_at(&clock, l, f, base, s.m);
        response_free(&clock);
    }
    double kappa = p->materials == 1 ? 1 : problem_diffusivity(p);
    for (size_t i = 0; i < f->n; i++) s.m[i] *= r->dx * r->dx / (24 * kappa);
    for (size_t i = 0; i < f->n; i++) {
        if (!melts) s.g[i] = dx2 * (base[i] - r->exact[i]);
        s.h[i] *= dx2;
        size[i] = isfinite(s.g[i]) ? fabs(s.g[i]) : INFINITY;
    }
    gsl_sort(size, 1, f->n);
    double largest = size[f->n - 1 - f->n / 20];
    for (size_t i = 0; i < f->n; i++) {
        s.e[i] = fabs(s.g[i]) <= largest ? f->T[i] - r->exact[i] : NAN;
        if (!s.is_mean || !isfinite(r->mean)) continue;
        s.e[i] -= r->mean * s.m[i];
        s.m[i] = 0;
    }
    free(size);
    return s;
}

void fit_errors_free(struct fit_errors *s) {
    free(s->e);
    free(s->g);
    free(s->h);
    free(s->m);
}

/* ---- Sizes from spacing to spacing ---- */

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

/* |log| of the change of the size from rung to rung in these units. */
static double drift(const struct fault_fit *c, const double unit[2]) {
    double ratio = c->rung[1].size / unit[1] / (c->rung[0].size / unit[0]);
    return ratio > 0 ? fabs(log(ratio)) : INFINITY;
}

const char *const *fit_unit_names(enum fault_kind kind) {
    static const char *const part[] = {"%", NULL}, *const length[] = {"cells", NULL}, *const kelvin[] = {"K", NULL},
                             *const time[] = {"s", FIT_DIFFUSIVE, "steps", NULL},
                             *const end[] = {"s", FIT_DIFFUSIVE, "steps", "%", NULL},
                             *const range[] = {"K", "%", NULL};
    const enum fault_unit unit = fault_rows[kind].unit;
    if (kind == FAULT_CLOCK) return end;
    if (kind == FAULT_RANGE) return range;
    return unit == UNIT_TIME ? time : unit == UNIT_LENGTH ? length : unit == UNIT_KELVIN ? kelvin : part;
}

double fit_unit(const struct fault_fit *c, const char *name, int rung) {
    const enum fault_unit unit = fault_rows[c->fault.kind].unit;
    if (unit == UNIT_TIME && strcmp(name, "steps") == 0) return c->step[rung];
    if (unit == UNIT_TIME && strcmp(name, FIT_DIFFUSIVE) == 0) return c->diffusive[rung];
    if ((unit == UNIT_TIME || unit == UNIT_KELVIN) && *name == '%') return c->whole;
    return unit == UNIT_LENGTH || c->fault.kind == FAULT_SAMPLES ? c->cell[rung] : 1;
}

unsigned fit_pace(enum fault_kind kind, const char *unit) {
    return kind == FAULT_CONDUCTIVITY                      ? PACE_CONDUCTIVITY
           : kind == FAULT_HEAT_CAPACITY                   ? PACE_CAPACITY
           : kind == FAULT_CLOCK && strcmp(unit, "%") == 0 ? PACE_END
                                                           : 0;
}

/* Takes the named unit if the size is more nearly constant in it. */
static void prefer(struct fault_fit *c, const char *name) {
    const double unit[2] = {fit_unit(c, name, 0), fit_unit(c, name, 1)};
    if (!(unit[0] > 0 && unit[1] > 0) || !(drift(c, unit) < c->drift)) return;
    memcpy(c->unit, unit, sizeof unit);
    c->name = name;
    c->drift = drift(c, unit);
}

/* One field cannot distinguish faults with similar responses (without a source T depends on kappa t alone).  The
 * dependence of the size on the spacing can: a clock is wrong by a number of steps, a position by a number of cells,
 * a coefficient by a fraction of itself.  If a program does not report its time steps, they may have a fixed length
 * or be a fraction of dx^2/kappa. */
static void find_unit(const struct problem *p, struct fault_fit *c, const struct diagnosis_rung *rung) {
    static const double LEAST_MEAN = 0.3; /* least fraction of the arithmetic mean's effect to detect another mean */
    static const double HALVES = 0.06;    /* cells */
    static const double FRONT = 0.1;      /* by the place of a front in its cell */
    const struct fault_row *row = &fault_rows[c->fault.kind];
    for (int k = 0; k < 2; k++) {
        c->cell[k] = c->fault.kind == FAULT_SAMPLES ? displacement(p, c->fault.at, &rung[k]) : rung[k].dx;
        c->step[k] = rung[0].dt > 0 && rung[1].dt > 0 ? rung[k].dt : 0;
        c->diffusive[k] = rung[k].dx * rung[k].dx / problem_diffusivity(p);
    }
    int in_steps = row->unit == UNIT_TIME && c->step[0] > 0;
    c->name = in_steps ? "steps" : fit_unit_names(c->fault.kind)[0];
    for (int k = 0; k < 2; k++) c->unit[k] = fit_unit(c, c->name, k);
    c->drift = drift(c, c->unit);
    if (row->unit == UNIT_TIME && !in_steps) prefer(c, FIT_DIFFUSIVE);
    if (c->fault.kind == FAULT_WALL_TIME) prefer(c, "s"); /* a phase */
    c->sides = fault_sides(p, c->fault);
    c->whole = fault_whole(p, c->fault);
    if (p->materials == 2) { /* effects at a contact are proportional to 1/k - 1/harmonic */
        double a = p->material[0].k[0], b = p->material[1].k[0], harmonic = (1 / a + 1 / b) / 2;
        c->geometric = (1 / sqrt(a * b) - harmonic) / (2 / (a + b) - harmonic);
    }
    if (p->k_law == K_PHASES && c->drift < FRONT) c->drift = 0;
    double due = row->is & FAULT_CELL ? row->cells : 1, found = c->rung[0].size / c->unit[0] / due;
    if ((row->unit == UNIT_WHOLE || row->is & FAULT_CELL) && !(fabs(found - 1) <= FIT_STEADY)) c->drift = INFINITY;
    double half = nearbyint(2 * found) / 2;
    if (row->is & FAULT_HALF && !(half != 0 && fabs(found - half) <= HALVES)) c->drift = INFINITY;
    if (c->fault.kind == FAULT_MEAN && !(found > LEAST_MEAN && found < 1 + FIT_STEADY)) c->drift = INFINITY;
}

const struct fault_fit *fit_first(const struct evidence *e, enum fault_kind kind) {
    for (int i = 0; e && i < e->n; i++)
        if (e->fit[i].fault.kind == kind) return &e->fit[i];
    return NULL;
}

/* A fit takes numbers for halfway between values and means, from which they differ by up to 5/2 dx^2/24 laplace(T), a
 * clock of 5/48 dx^2/kappa.  The coarse rung may be off by no more than a correct code's own error. */
double fit_whole_steps(const struct evidence *e, int at, double most) {
    static const double UNSURE = 5.0 / 48;
    const struct fault_fit *c = fit_first(e, FAULT_CLOCK);
    for (int k = 0; c && k < 2; k++) {
        const double off = (at == STEPS_LATE ? 1 : -1) * c->rung[k].size / c->diffusive[k];
        if (c->rung[k].share < FIT_SHARE && (k == 0 || c->rung[k].part >= FIT_MOST)) return 0;
        if (off < -UNSURE || off > most + UNSURE) return 0;
    }
    return c ? c->rung[0].share : 0;
}

/* A correct code's own error and the unknown mean, which take a clock less than half a step off, scale as dx^2, as
 * steps do: between the rungs whole steps are left. */
double fit_some_steps(const struct evidence *e, int way, int off[2]) {
    const struct fault_fit *c = fit_first(e, FAULT_CLOCK);
    double steps[2];
    off[0] = off[1] = 0;
    if (!c || !(c->step[0] > 0)) return 0;
    for (int k = 0; k < 2; k++) {
        steps[k] = way * c->rung[k].size / c->step[k];
        off[k] = steps[k] > 0.5;
        if (!(steps[k] > -0.5 && steps[k] < 1.5)) return 0;
        if (c->rung[k].share < FIT_SHARE && c->rung[k].part >= FIT_MOST) return 0;
    }
    if (fabs(steps[0] - steps[1] - off[0] + off[1]) > FIT_STEADY) return 0;
    return c->rung[off[1] && !off[0]].share;
}

/* ---- All faults at two rungs ---- */

enum { POINTS = 20000 };

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

/* Both fits of a fault with its response at that size (0: a small size).  Returns 0, or -1 if there is no response,
 * or after an interrupt: its row has no verdict, and the many responses may take half a minute. */
static int fit_at(const struct looked_at *at, struct fault fault, double size, struct fit fit[2]) {
    static const double UNLIKELY = 0.3;
    struct response r = {.size = 0};
    if (output_noted()) return -1;
    const struct fault_row *row = &fault_rows[fault.kind];
    const int on_cells = row->is & FAULT_RUNG, in_cells = row->is & FAULT_CELL;
    int failed = on_cells || in_cells ? 0 : response_take(at->p, at->l, fault, size, &r);
    for (int k = 1; k >= 0 && !failed; k--) {
        const struct field *f = at->rung[k].field;
        fit[k] = (struct fit){.size = 0};
        if (on_cells && k == 0 && fit[1].share < UNLIKELY) break; /* the fine rung takes most of the time */
        if (in_cells) response_free(&r);
        if (in_cells) failed = response_take(at->p, at->l, fault, row->cells * at->rung[k].dx, &r);
        if (failed) break;
        if (on_cells)
            failed = response_on_cells(at->p, at->rung[k].dx, fault, f, at->response);
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
static int fit_from(const struct looked_at *at, struct fault fault, double start, struct fit fit[2]) {
    enum { STEPS = 6 };
    static const double LARGE = 0.05, MOST = 3, SAME = 0.01, LIKELY = 0.5, STEEP = 0.9;
    const int phase = fault.kind == FAULT_WALL_TIME, bends = fault_rows[fault.kind].is & FAULT_BENDS;
    const double unit = fault_scale(at->p, fault) / (phase ? 4 : 1);
    const double lowest = phase                             ? -MOST
                          : fault.kind == FAULT_COEFFICIENT ? -1
                                                            : -0.9; /* b may be 0, k and rho c not */
    int failed = fit_at(at, fault, start, fit);
    double before[2] = {start, fit[0].size}, s = before[1];
    for (int round = 0; round < STEPS && !failed && bends; round++) {
        if (!(fit[0].share > LIKELY && fit[0].part > FIT_MOST && fabs(s) > LARGE * unit)) break;
        s = fmin(fmax(s, lowest * unit), MOST * unit);
        failed = fit_at(at, fault, s, fit);
        double found = fit[0].size, slope = (found - before[1]) / (s - before[0]);
        if (failed || fabs(found - s) <= SAME * fabs(found)) break;
        before[0] = s, before[1] = found;
        s = slope < STEEP ? (found - slope * s) / (1 - slope) : found;
    }
    return failed;
}

/* From a small size and, if that explains too little, from a large one. */
static int fit_bent(const struct looked_at *at, struct fault fault, struct fit fit[2]) {
    const double far = fault_rows[fault.kind].far * fault_scale(at->p, fault);
    struct fit there[2];
    if (fit_from(at, fault, 0, fit)) return -1;
    if (far == 0 || fit[0].share >= FIT_SHARE || fit[0].part < FIT_MOST) return 0;
    if (!fit_from(at, fault, far, there) && there[0].share > fit[0].share) memcpy(fit, there, sizeof there);
    return 0;
}

static void fit_each(struct looked_at *at, struct evidence *c) {
    for (int kind = 0; kind < FAULT_KINDS; kind++)
        for (int place = 0; place < fault_places((enum fault_kind)kind) && c->n < FIT_ALL; place++) {
            struct fault_fit *fit = &c->fit[c->n];
            *fit = (struct fault_fit){.fault = {(enum fault_kind)kind, place}};
            if (!fault_applies(at->p, fit->fault) || fit_bent(at, fit->fault, fit->rung)) continue;
            if (!fault_can_be(at->p, fit->fault, fit->rung[0].size)) continue;
            find_unit(at->p, fit, at->rung);
            c->n++;
        }
}

static struct evidence *fit_sample(const struct problem *p, const struct diagnosis_rung *rung) {
    struct response_lattice l;
    if (response_lattice_create(p, &l)) return NULL;
    struct looked_at at = {.p = p, .l = &l, .rung = rung};
    struct evidence *c = xcalloc(1, sizeof *c);
    c->melts = p->k_law == K_PHASES;
    for (int k = 0; k < 2; k++) {
        at.base[k] = xcalloc(rung[k].field->n, sizeof **at.base);
        at.errors[k] = fit_errors(p, &l, &rung[k], at.base[k]);
    }
    at.response = xcalloc(rung[0].field->n + rung[1].field->n, sizeof *at.response);
    fit_each(&at, c);
    for (int k = 0; k < 2; k++) {
        free(at.base[k]);
        fit_errors_free(&at.errors[k]);
    }
    free(at.response);
    response_lattice_free(&l);
    return c;
}

struct evidence *fit_all(const struct problem *p, const struct diagnosis_rung *rung) {
    struct field field[2];
    struct diagnosis_rung sampled[2] = {sample(&rung[0], &field[0]), sample(&rung[1], &field[1])};
    struct evidence *c = fit_sample(p, sampled);
    for (int i = 0; i < 2; i++) drop(&sampled[i], &field[i]);
    return c;
}
