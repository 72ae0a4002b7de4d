/* Least squares of the error field e with the response f of one fault at a time, beside what differences of second
 * order leave at the same spacing: in space g, in time (Euler's, of mesh Fourier number 1) h,
 *
 *     e = size f + b g + c h + d m,    |b| <= 2,  |c| <= 1/2,  |d| <= 2
 *
 * since a faulty code has its errors of discretization too.  m = dx^2/24 laplace(T) is what the mean over a cell has
 * more than the value at its centre.  A code's numbers are values (d = 0), means over cells (1), linear elements that
 * start from a projection (-2 at their nodes, 2 with a lumped mass): what is so at the start stays so, since d m goes
 * through time as T does, unless a source adds values to means.  An answer at the start tells d (diagnosis_mean), and
 * its part is taken off e.  Without one, where m looks like the fault (of one material without a source it is
 * dx^2/(24 kappa) dT/dt, a clock that is fast by a sixth of a step at F = 1/4) no fit can tell, and d = 1/2, between
 * values and means, is taken.  From data that jump, where means are values on faces, g has it already: d = 0.  A
 * fault whose part |size f| is not at least twice |g + h/5| and three times |m|, which is more than any of these d
 * are from 1/2, is none: that is the size of a correct code's error.  The twentieth of the points where g is largest
 * (corners whose sides disagree) is left out.
 *
 * One field cannot tell faults of like response apart (without a source T depends on kappa t alone): how the size
 * goes with the spacing can.  A clock is wrong by steps, a place by cells, a coefficient by a part of itself. */
#include "verification/diagnosis/diagnosis.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/diagnosis/response.h"
#include "verification/diagnosis/wording.h"
#include "verification/text/json.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SHARE = 0.9;   /* of the squared error that a fault must explain to be named */
static const double ALIKE = 0.02;  /* shares that differ by less tell nothing apart */
static const double STEADY = 0.25; /* relative change of a size from rung to rung that still counts as none */
static const double MOST = 2;      /* of what differences of second order leave: a correct code's own error */
enum { POINTS = 20000, FAULTS = 32, ROUNDS = 20000 };

struct fit {
    double size, share;
    double part; /* |size f| / sqrt(|g + h/5|^2 + |3/2 m|^2) */
};

/* A rung: its errors, and what differences of second order leave. */
struct errors {
    const struct field *field;
    double *e, *g, *h; /* K, owned; e is NAN at a point that is left out */
    double *m;         /* K, owned: dx^2/24 laplace(T); of two materials dx^2/(24 kappa) dT/dt of the faster */
    int is_mean;       /* 1: a mean over a cell may stand for a value */
};

struct candidate_fault {
    struct fault fault;
    struct fit fine, coarse;
    double unit[2];   /* of the size at the fine and the coarse rung: a step, a cell, or 1 */
    double drift;     /* |log| of the change of the size in its unit; INFINITY where it does not stay */
    const char *name; /* of the unit */
};

static double clamp(double x, double most) {
    return fmax(-most, fmin(most, x));
}

/* Minimum over size, b, c and d, one after the other until they stay: four numbers, three of them bounded. */
static struct fit fit_error(const struct errors *s, const double *f) {
    enum { N = 5 };
    double a[N][N] = {{0}}; /* products of e, f, g, h, m */
    for (size_t i = 0; i < s->field->n; i++) {
        double w = s->field->weight ? s->field->weight[i] : 1, v[N] = {s->e[i], f[i], s->g[i], s->h[i], s->m[i]};
        if (!isfinite(v[0])) continue;
        for (int k = 0; k < N; k++)
            for (int l = 0; l < N; l++) a[k][l] += w * v[k] * v[l];
    }
    if (!(a[0][0] > 0 && a[1][1] > 0)) return (struct fit){0, 0, 0};
    double x[N] = {-1, 0, 0, 0, s->is_mean ? 0.5 : 0}; /* of e, f, g, h, m: x.v is what is left */
    int free = s->is_mean && a[1][4] * a[1][4] < SHARE * a[1][1] * a[4][4] ? N : N - 1;
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 1; k < free; k++) {
            double rest = 0;
            for (int l = 0; l < N; l++) rest -= l == k ? 0 : a[k][l] * x[l];
            x[k] = a[k][k] > 0 ? rest / a[k][k] : 0;
            if (k == 2 || k == 3) x[k] = clamp(x[k], k == 2 ? MOST : 0.5);
            if (k == 4) x[k] = clamp(x[k], MOST);
        }
    double left = 0, natural = a[2][2] + 0.4 * a[2][3] + 0.04 * a[3][3] + 2.25 * a[4][4];
    for (int k = 0; k < N; k++)
        for (int l = 0; l < N; l++) left += x[k] * a[k][l] * x[l];
    return (struct fit){x[1], 1 - left / a[0][0], fabs(x[1]) * sqrt(a[1][1] / fmax(natural, 1e-300))};
}

static struct errors errors_of(const struct problem *p, const struct response_lattice *l,
                               const struct diagnosis_rung *r) {
    const struct field *f = r->field;
    struct errors s = {.field = f, .is_mean = p->jumps[0] + p->jumps[1] == 0 && p->materials == 1};
    double **const owned[] = {&s.e, &s.g, &s.h, &s.m};
    for (int k = 0; k < 4; k++) *owned[k] = xcalloc(f->n, sizeof(double));
    double *size = xcalloc(f->n, sizeof *size), dx2 = pow(r->dx / l->dx, 2);
    response_base(p, l, f, s.g, s.h);
    if (p->materials == 1)
        response_laplacian(p, l, f, s.m);
    else
        response_at(p, l, (struct fault){FAULT_CLOCK, 0}, f, s.g, s.m);
    double kappa = p->materials == 1 ? 1 : problem_diffusivity(p);
    for (size_t i = 0; i < f->n; i++) s.m[i] *= r->dx * r->dx / (24 * kappa);
    for (size_t i = 0; i < f->n; i++) {
        s.g[i] = dx2 * (s.g[i] - r->exact[i]);
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

static void errors_free(struct errors *s) {
    free(s->e);
    free(s->g);
    free(s->h);
    free(s->m);
}

double diagnosis_mean(const struct problem *p, const struct diagnosis_rung *start) {
    struct response_lattice l;
    double ee = 0, em = 0, mm = 0;
    if (p->materials > 1 || p->jumps[0] + p->jumps[1] > 0 || p->source || response_lattice_create(p, &l)) return NAN;
    struct errors s = errors_of(p, &l, start);
    for (size_t i = 0; i < s.field->n; i++) {
        double w = s.field->weight ? s.field->weight[i] : 1;
        if (isfinite(s.e[i])) ee += w * s.e[i] * s.e[i], em += w * s.e[i] * s.m[i], mm += w * s.m[i] * s.m[i];
    }
    errors_free(&s);
    response_lattice_free(&l);
    return mm > 0 && ee - em * em / mm <= (1 - SHARE) * fmax(ee, mm) ? em / mm : NAN;
}

static int list_faults(const struct problem *p, struct fault *list) {
    static const struct {
        enum fault_kind kind;
        int count; /* of axes, sides or corners */
    } kinds[] = {{FAULT_CLOCK, 1},       {FAULT_CONDUCTIVITY, 1}, {FAULT_SWAP, 1},      {FAULT_TRANSPOSED, 1},
                 {FAULT_SOURCE, 1},      {FAULT_CAPACITY, 1},     {FAULT_INTERFACE, 1}, {FAULT_MEAN, 1},
                 {FAULT_AMPLITUDE, 1},   {FAULT_SOURCE_TIME, 1},  {FAULT_ISOTROPIC, 2}, {FAULT_EXTENT, 3},
                 {FAULT_START_SHIFT, 2}, {FAULT_START_WIDTH, 2},  {FAULT_SAMPLES, 2},   {FAULT_WALL, 5},
                 {FAULT_CORNER, 4}};
    int n = 0;
    struct faulty ignored;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int a = 0; a < kinds[i].count; a++) {
            list[n] = (struct fault){kinds[i].kind, a};
            n += fault_make(p, list[n], 0, &ignored);
        }
    return n;
}

/* How far outwards, m, the jumps of the start lie where it jumps midway between the points next to them along an
 * axis; 0 where they do not agree. */
static double displacement(const struct problem *p, int axis, const struct diagnosis_rung *r) {
    const double *x = axis ? r->field->y : r->field->x;
    double out = 0;
    for (int k = 0; k < p->jumps[axis]; k++) {
        double at = p->jump[axis][k], below = -INFINITY, above = INFINITY;
        for (size_t i = 0; i < r->field->n; i++)
            if (x[i] < at)
                below = fmax(below, x[i]);
            else
                above = fmin(above, x[i]);
        double moved = (2 * k < p->jumps[axis] ? -1 : 1) * ((below + above) / 2 - at);
        if (k && fabs(moved - out) > 1e-6 * r->dx) return 0;
        out = moved;
    }
    return fabs(out) > 1e-6 * r->dx ? out : 0;
}

/* The unit in which the size of a fault stays from rung to rung, and what is left of its change. */
static void follow(const struct problem *p, struct candidate_fault *c, const struct diagnosis_rung *fine,
                   const struct diagnosis_rung *coarse) {
    int place = c->fault.kind == FAULT_EXTENT || c->fault.kind == FAULT_START_SHIFT ||
                c->fault.kind == FAULT_START_WIDTH || c->fault.kind == FAULT_INTERFACE || c->fault.kind == FAULT_MEAN;
    int in_time = c->fault.kind == FAULT_CLOCK || c->fault.kind == FAULT_SOURCE_TIME;
    int clock = in_time && fine->dt > 0 && coarse->dt > 0;
    c->unit[0] = clock ? fine->dt : place ? fine->dx : 1;
    c->unit[1] = clock ? coarse->dt : place ? coarse->dx : 1;
    if (c->fault.kind == FAULT_SAMPLES)
        c->unit[0] = displacement(p, c->fault.axis, fine), c->unit[1] = displacement(p, c->fault.axis, coarse);
    c->name = clock ? "steps" : in_time ? "s" : place ? "cells" : "%";
    double ratio = c->coarse.size / c->unit[1] / (c->fine.size / c->unit[0]);
    c->drift = ratio > 0 ? fabs(log(ratio)) : INFINITY;
    int whole = fault_is_whole(c->fault.kind) || c->fault.kind == FAULT_MEAN || c->fault.kind == FAULT_SAMPLES;
    if (whole && !(fabs(c->fine.size / c->unit[0] - 1) <= STEADY)) c->drift = INFINITY;
}

/* Some POINTS of a rung, evenly along it; owned arrays, to be freed by drop. */
static struct diagnosis_rung sample(const struct diagnosis_rung *r, struct field *f) {
    size_t stride = r->field->n / POINTS + 1;
    if (stride > 1) stride |= 1; /* so that columns of a lattice are not picked out */
    size_t n = (r->field->n + stride - 1) / stride;
    double *exact = xcalloc(n, sizeof *exact);
    field_alloc(f, r->field->dim, n);
    f->weight = r->field->weight ? xcalloc(n, sizeof *f->weight) : NULL;
    for (size_t i = 0; i < n; i++) {
        f->x[i] = r->field->x[i * stride];
        if (f->y) f->y[i] = r->field->y[i * stride];
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

static int fit_all(const struct problem *p, const struct diagnosis_rung *rung, struct candidate_fault *c) {
    struct response_lattice l;
    struct fault list[FAULTS];
    int n = 0, faults = list_faults(p, list);
    if (response_lattice_create(p, &l)) return 0;
    struct errors errors[2] = {errors_of(p, &l, &rung[0]), errors_of(p, &l, &rung[1])};
    double *base[2], *response = xcalloc(rung[0].field->n + rung[1].field->n, sizeof *response);
    for (int k = 0; k < 2; k++) {
        double dx2 = pow(rung[k].dx / l.dx, 2);
        base[k] = xcalloc(rung[k].field->n, sizeof **base);
        for (size_t i = 0; i < rung[k].field->n; i++) base[k][i] = errors[k].g[i] / dx2 + rung[k].exact[i];
    }
    for (int i = 0; i < faults; i++) {
        struct fit fit[2];
        int failed = 0;
        for (int k = 0; k < 2 && !failed; k++) {
            failed = list[i].kind == FAULT_CORNER
                         ? response_at_corner(p, rung[k].dx, list[i], rung[k].field, response)
                         : response_at(p, &l, list[i], rung[k].field, base[k], response);
            if (!failed) fit[k] = fit_error(&errors[k], response);
        }
        if (failed) continue;
        c[n] = (struct candidate_fault){.fault = list[i], .fine = fit[0], .coarse = fit[1]};
        follow(p, &c[n++], &rung[0], &rung[1]);
    }
    for (int k = 0; k < 2; k++) {
        free(base[k]);
        errors_free(&errors[k]);
    }
    free(response);
    response_lattice_free(&l);
    return n;
}

static int stays(const struct candidate_fault *c) {
    return c->drift <= log(1 + STEADY) && c->coarse.share >= SHARE - ALIKE;
}

/* A clock that is off by the same time at every spacing: T depends on kappa t alone, and a conductivity explains the
 * same, as what is usual. */
static int is_end(const struct candidate_fault *c) {
    return c->fault.kind == FAULT_CLOCK && strcmp(c->name, "s") == 0;
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
        if (c[i].fine.part >= MOST) most = fmax(most, c[i].fine.share);
    d->share = most;
    if (most < SHARE) {
        if (most > 0)
            snprintf(d->what, sizeof d->what, "no usual fault explains more than %.0f %% of the error", 100 * most);
        else
            snprintf(d->what, sizeof d->what, "no usual fault: the error is of the size that differences leave");
        return;
    }
    for (int i = 0; i < n; i++) {
        if (c[i].fine.part < MOST || c[i].fine.share < fmax(SHARE, most - ALIKE) || !stays(&c[i])) continue;
        if (best < 0 || is_end(&c[best]) || (!is_end(&c[i]) && c[i].drift < c[best].drift)) best = i;
    }
    if (best < 0) {
        snprintf(d->what, sizeof d->what,
                 "no usual fault: what looks like one has a size that changes with the spacing");
        return;
    }
    int percent = c[best].name[0] == '%';
    d->named = 1;
    d->fault = c[best].fault;
    d->size = c[best].fine.size / c[best].unit[0] * (percent ? 100 : 1);
    d->unit = fault_is_whole(d->fault.kind) || d->fault.kind == FAULT_SAMPLES ? "" : c[best].name;
    d->share = c[best].fine.share;
    wording_fault(d);
}

int diagnosis_repeat(double apart, double largest, struct diagnosis *d) {
    static const double SUMS = 1e-9; /* 1e6 roundings of 1e-16, and a tenfold */
    if (!(apart > SUMS * largest)) return 0;
    *d = (struct diagnosis){.named = 1, .size = apart, .unit = "K", .share = NAN};
    snprintf(d->what, sizeof d->what, "as if threads raced: two runs of the same are %.2g K apart", apart);
    return 1;
}

void diagnosis_json(const struct diagnosis *d, struct json *j) {
    if (!d->named) {
        json_text(j, "diagnosis", NULL);
        return;
    }
    json_object(j, "diagnosis");
    json_text(j, "what", d->what);
    json_number(j, "size", d->size);
    json_text(j, "unit", d->unit);
    json_number(j, "share", d->share);
    json_end(j);
}
