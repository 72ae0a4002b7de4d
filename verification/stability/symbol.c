/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numerical von Neumann analysis: the stencil, its discrete Fourier transform, and the critical wave number.
 *
 * A grid of N = 128 phases along each axis (48 in space) locates each minimum of the limit to 2 pi/N.  There the
 * limit differs from the minimum by a relative error of about (2 pi/N)^2/8 reach^2 (3 % for a reach of 10; in space,
 * 2 % for 3), so the least point of the grid need not be next to the least minimum: a compass search from every
 * minimum of the grid within 10 % of the least one reduces the error to round-off.  All weights are included, also
 * odd ones: lambda is complex in general, and real for the even stencils of this suite. */
#include "verification/stability/symbol.h"

#include "solver/time/stepper.h"
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { IMPULSE = 11 }; /* one step of the finite differences reaches 2 of the 5 cells on either side */

/* Phases along each axis. */
static int phases_of(int dim) {
    return dim == 3 ? 48 : 128;
}

static size_t weight_index(const struct symbol *s, int i, int j, int k) {
    const int *r = s->reach;
    return (size_t)(((k + r[2]) * (2 * r[1] + 1) + j + r[1]) * (2 * r[0] + 1) + i + r[0]);
}

static void reserve(struct symbol *s, int dim, const int reach[DIM_MAX]) {
    *s = (struct symbol){dim, {reach[0], reach[1], reach[2]}, NULL};
    s->w = xcalloc(weight_index(s, reach[0], reach[1], reach[2]) + 1, sizeof *s->w);
}

/* Loops over all offsets of a stencil. */
#define OFFSETS(s, i, j, k)                                                                                          \
    for (int k = -(s)->reach[2]; k <= (s)->reach[2]; k++)                                                            \
        for (int j = -(s)->reach[1]; j <= (s)->reach[1]; j++)                                                        \
            for (int i = -(s)->reach[0]; i <= (s)->reach[0]; i++)

static int from_scheme(struct symbol *s, const struct model_problem *b, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    double *octant;
    int r[DIM_MAX];
    if (operator_stencil(&p, &b->options, b->method->scheme, 1, p.material[0].k, r, &octant, why)) return why->status;
    reserve(s, b->dim, r);
    OFFSETS(s, i, j, k) s->w[weight_index(s, i, j, k)] = octant[operator_offset(r, abs(i), abs(j), abs(k))];
    free(octant);
    return STATUS_OK;
}

/* (T_1 - T_0) / dt around an impulse; mirrored, since T at -j is the weight of the neighbour at +j. */
static int from_impulse(struct symbol *s, const struct model_problem *given, struct failure *why) {
    struct model_problem b = *given;
    struct field f;
    b.n = IMPULSE;
    if (b.method->scheme) b.n = 2 * (int)ceil(b.method->scheme->sweeps * 2 * b.options.h) + 1;
    const int middle = b.n / 2;
    struct problem p = model_problem_setup(&b, MODEL_IMPULSE, 0);
    struct options o = b.options;
    o.stepper = stepper_auto(1, 1, 0),
    o.layout = LAYOUT_LATTICE; /* as many unknowns for any treatment of the walls */
    p.t_end = o.dt = 1.0 / 64;
    if (method_solve(b.method, &p, &o, &f, why)) return why->status;
    int reach[DIM_MAX] = {0};
    for (int a = 0; a < b.dim; a++) reach[a] = middle;
    reserve(s, b.dim, reach);
    for (size_t m = 0; m < f.n; m++) { /* in the order of the method */
        double x[DIM_MAX];
        int at[DIM_MAX] = {0};
        field_place(&f, m, x);
        for (int a = 0; a < b.dim; a++) at[a] = (int)floor(x[a]) - middle;
        s->w[weight_index(s, -at[0], -at[1], -at[2])] = (f.T[m] - (!at[0] && !at[1] && !at[2])) / o.dt;
    }
    field_free(&f);
    return STATUS_OK;
}

int symbol_create(struct symbol *s, const struct model_problem *b, struct failure *why) {
    return b->method->scheme && b->field == 0 ? from_scheme(s, b, why) : from_impulse(s, b, why);
}

void symbol_free(struct symbol *s) {
    free(s->w);
    *s = (struct symbol){0};
}

double symbol_weight(const struct symbol *s, int i, int j, int k) {
    const int *r = s->reach;
    return abs(i) > r[0] || abs(j) > r[1] || abs(k) > r[2] ? 0 : s->w[weight_index(s, i, j, k)];
}

double complex symbol_at(const struct symbol *s, const double *theta) {
    const int reach = s->reach[0];
    double re = 0, im = 0, across[2] = {s->dim > 1 ? theta[1] : 0, s->dim > 2 ? theta[2] : 0};
    /* the same in every row */
    double *cosine = xcalloc(2 * (size_t)reach + 2, sizeof *cosine), *sine = cosine + reach + 1;
    for (int i = 1; i <= reach; i++) cosine[i] = cos(i * theta[0]), sine[i] = sin(i * theta[0]);
    for (int k = -s->reach[2]; k <= s->reach[2]; k++)
        for (int j = -s->reach[1]; j <= s->reach[1]; j++) {
            const double *w = &s->w[weight_index(s, 0, j, k)];
            double row_re = w[0], row_im = 0;
            for (int i = 1; i <= reach; i++) {
                row_re += (w[i] + w[-i]) * cosine[i];
                row_im += (w[i] - w[-i]) * sine[i];
            }
            double angle = j * across[0] + k * across[1], c = cos(angle), d = sin(angle);
            re += row_re * c - row_im * d, im += row_re * d + row_im * c;
        }
    free(cosine);
    return re + I * im;
}

/* k modulo n, also for negative k */
static int wrapped(int k, int n) {
    return (k % n + n) % n;
}

/* lambda at the phases 2 pi k/n along each axis: transform of the stencil, zero-padded and wrapped. */
static fftw_complex *transform(const struct symbol *s, size_t *count) {
    int n = phases_of(s->dim), sizes[DIM_MAX] = {n, n, n};
    *count = 1;
    for (int a = 0; a < s->dim; a++) *count *= (size_t)n;
    fftw_complex *z = xcheck(fftw_malloc(sizeof *z * *count), *count, sizeof *z);
    fftw_plan plan;
#pragma omp critical(fftw_planner)
    plan = fftw_plan_dft(s->dim, sizes, z, z, FFTW_BACKWARD, FFTW_ESTIMATE);
    for (size_t i = 0; i < *count; i++) z[i] = 0;
    OFFSETS(s, i, j, k) z[(wrapped(k, n) * n + wrapped(j, n)) * n + wrapped(i, n)] += s->w[weight_index(s, i, j, k)];
    fftw_execute(plan);
#pragma omp critical(fftw_planner)
    fftw_destroy_plan(plan);
    return z;
}

/* Stability limit of one wave; infinite if it neither grows nor decays beyond round-off. */
static double allowed(const struct amplification *step, double reach, double floor, double complex lambda) {
    return cabs(lambda) <= floor ? INFINITY : amplification_limit(step, reach, lambda);
}

/* Moves e->theta to the least limit around it. */
static void descend(const struct symbol *s, const struct amplification *step, double reach, double floor,
                    struct symbol_extreme *e) {
    for (double size = 2 * M_PI / phases_of(s->dim); size > 1e-9;) {
        int moved = 0;
        for (int d = 0; d < 2 * s->dim; d++) {
            double theta[DIM_MAX];
            memcpy(theta, e->theta, sizeof theta);
            theta[d / 2] += d % 2 ? size : -size;
            double complex lambda = symbol_at(s, theta);
            double limit = allowed(step, reach, floor, lambda);
            e->radius = fmax(e->radius, cabs(lambda));
            if (!(limit < e->limit)) continue;
            e->limit = limit, moved = 1;
            memcpy(e->theta, theta, sizeof theta);
        }
        if (!moved) size /= 2;
    }
}

/* 1 if no neighbour of phase k along an axis has a smaller limit. */
static int is_lowest(const struct symbol *s, const double *limit, size_t k) {
    size_t n = (size_t)phases_of(s->dim), stride = 1;
    for (int a = 0; a < s->dim; a++, stride *= n) {
        size_t i = k / stride % n, low = i ? k - stride : k + (n - 1) * stride;
        size_t high = i + 1 < n ? k + stride : k - (n - 1) * stride;
        if (limit[low] < limit[k] || limit[high] < limit[k]) return 0;
    }
    return 1;
}

/* Starts from every minimum of the grid within NEAR of the least one; of images by symmetry, which have the same
 * limit, from the first. */
static void search_minima(const struct symbol *s, const struct amplification *step, double reach, double floor,
                          const double *limit, size_t count, struct symbol_extreme *e) {
    enum { STARTS_MAX = 64 };
    static const double NEAR = 0.1, SAME = 1e-9;
    const double least = e->limit;
    double started[STARTS_MAX];
    int starts = 0;
    for (size_t k = 0; k < count && starts < STARTS_MAX; k++) {
        int is_new = limit[k] <= (1 + NEAR) * least && is_lowest(s, limit, k);
        for (int m = 0; m < starts && is_new; m++) is_new = fabs(limit[k] - started[m]) > SAME * least;
        if (!is_new) continue;
        struct symbol_extreme here = {.limit = limit[k], .radius = e->radius};
        size_t n = (size_t)phases_of(s->dim);
        for (size_t a = 0, rest = k; a < DIM_MAX; a++, rest /= n)
            here.theta[a] = 2 * M_PI / (double)n * (double)(rest % n);
        started[starts++] = limit[k];
        descend(s, step, reach, floor, &here);
        e->radius = fmax(e->radius, here.radius);
        if (!(here.limit < e->limit)) continue;
        e->limit = here.limit;
        memcpy(e->theta, here.theta, sizeof e->theta);
    }
}

struct symbol_extreme symbol_extreme(const struct symbol *s, const struct amplification *step) {
    size_t count, least = 0;
    fftw_complex *z = transform(s, &count);
    struct symbol_extreme e = {.limit = INFINITY, .growth = -INFINITY};
    double reach = amplification_reach(step), *limit = xcalloc(count, sizeof *limit);
    for (size_t k = 0; k < count; k++) e.radius = fmax(e.radius, cabs(z[k]));
    double floor = 1e-12 * e.radius; /* round-off of a sum of weights */
    for (size_t k = 0; k < count; k++) {
        limit[k] = allowed(step, reach, floor, z[k]);
        e.growth = fmax(e.growth, creal(z[k]));
        if (limit[k] < limit[least]) least = k;
    }
    e.limit = limit[least];
    for (size_t a = 0, rest = least, n = (size_t)phases_of(s->dim); a < DIM_MAX; a++, rest /= n)
        e.theta[a] = 2 * M_PI / (double)n * (double)(rest % n);
    fftw_free(z);
    if (e.limit > 0 && isfinite(e.limit)) search_minima(s, step, reach, floor, limit, count, &e);
    free(limit);
    return e;
}

double symbol_lowest(const struct symbol *s) {
    double lowest = INFINITY, centre = fabs(symbol_weight(s, 0, 0, 0));
    OFFSETS(s, i, j, k)
    if (i || j || k) lowest = fmin(lowest, symbol_weight(s, i, j, k) / centre);
    return lowest;
}
