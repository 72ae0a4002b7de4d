/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numerical von Neumann analysis: the stencil, its discrete Fourier transform, and the critical wave number.
 *
 * A grid of N = 128 phases along each axis locates the critical one to 2 pi/N.  There the limit differs from its
 * extreme by a relative error of about (2 pi/N)^2/8 reach^2 (3 % for a reach of 10), which a compass search then
 * reduces to round-off.  All weights are included, also odd ones: lambda is complex in general, and real for the
 * even stencils of this suite. */
#include "verification/stability/symbol.h"

#include "solver/time/stepper.h"
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PHASES = 128, IMPULSE = 11 }; /* one step of the finite differences reaches 2 of the 5 cells on either side */

static size_t place(const struct symbol *s, int i, int j) {
    return (size_t)(j + s->reach[1]) * (size_t)(2 * s->reach[0] + 1) + (size_t)(i + s->reach[0]);
}

static void reserve(struct symbol *s, int dim, int rx, int ry) {
    *s = (struct symbol){dim, {rx, ry}, xcalloc((size_t)(2 * rx + 1) * (size_t)(2 * ry + 1), sizeof(double))};
}

static int from_scheme(struct symbol *s, const struct model_problem *b, struct failure *why) {
    struct problem p = model_problem_setup(b, MODEL_NOISE, 0);
    const double kappa[2] = {1, model_problem_kappa_y(b)};
    double *quadrant;
    int r[DIM_MAX];
    if (operator_stencil(&p, &b->options, b->method->scheme, 1, kappa, r, &quadrant, why)) return why->status;
    reserve(s, b->dim, r[0], r[1]);
    for (int j = -r[1]; j <= r[1]; j++)
        for (int i = -r[0]; i <= r[0]; i++) s->w[place(s, i, j)] = quadrant[abs(j) * (r[0] + 1) + abs(i)];
    free(quadrant);
    return STATUS_OK;
}

/* (T_1 - T_0) / dt around an impulse; mirrored, since T at -j is the weight of the neighbour at +j. */
static int from_impulse(struct symbol *s, const struct model_problem *given, struct failure *why) {
    struct model_problem b = *given;
    struct field f;
    b.n = IMPULSE;
    struct problem p = model_problem_setup(&b, MODEL_IMPULSE, 0);
    struct options o = b.options;
    o.stepper = stepper_auto(1, 1, 0),
    o.layout = LAYOUT_LATTICE; /* IMPULSE unknowns for any treatment of the walls */
    p.t_end = o.dt = 1.0 / 64;
    if (method_solve(b.method, &p, &o, &f, why)) return why->status;
    int r = IMPULSE / 2, ry = b.dim == 2 ? r : 0;
    reserve(s, b.dim, r, ry);
    for (int j = -ry; j <= ry; j++)
        for (int i = -r; i <= r; i++)
            s->w[place(s, -i, -j)] = (f.T[(j + ry) * IMPULSE + i + r] - (i == 0 && j == 0)) / o.dt;
    field_free(&f);
    return STATUS_OK;
}

int symbol_create(struct symbol *s, const struct model_problem *b, struct failure *why) {
    return b->method->scheme ? from_scheme(s, b, why) : from_impulse(s, b, why);
}

void symbol_free(struct symbol *s) {
    free(s->w);
    *s = (struct symbol){0};
}

double symbol_weight(const struct symbol *s, int i, int j) {
    return abs(i) > s->reach[0] || abs(j) > s->reach[1] ? 0 : s->w[place(s, i, j)];
}

double complex symbol_at(const struct symbol *s, const double theta[2]) {
    double re = 0, im = 0;
    for (int j = -s->reach[1]; j <= s->reach[1]; j++) {
        const double *w = &s->w[place(s, 0, j)];
        double row_re = w[0], row_im = 0;
        for (int i = 1; i <= s->reach[0]; i++) {
            row_re += (w[i] + w[-i]) * cos(i * theta[0]);
            if (w[i] != w[-i]) row_im += (w[i] - w[-i]) * sin(i * theta[0]);
        }
        double c = cos(j * theta[1]), d = sin(j * theta[1]);
        re += row_re * c - row_im * d, im += row_re * d + row_im * c;
    }
    return re + I * im;
}

/* k modulo n, also for negative k */
static int wrapped(int k, int n) {
    return (k % n + n) % n;
}

/* lambda at the phases 2 pi k/PHASES: transform of the stencil, zero-padded and wrapped. */
static fftw_complex *transform(const struct symbol *s, int ny) {
    fftw_complex *z = xcheck(fftw_malloc(sizeof *z * (size_t)(PHASES * ny)), (size_t)(PHASES * ny), sizeof *z);
    fftw_plan plan;
#pragma omp critical(fftw_planner)
    plan = s->dim == 2 ? fftw_plan_dft_2d(ny, PHASES, z, z, FFTW_BACKWARD, FFTW_ESTIMATE)
                       : fftw_plan_dft_1d(PHASES, z, z, FFTW_BACKWARD, FFTW_ESTIMATE);
    memset(z, 0, sizeof *z * (size_t)(PHASES * ny));
    for (int j = -s->reach[1]; j <= s->reach[1]; j++)
        for (int i = -s->reach[0]; i <= s->reach[0]; i++)
            z[wrapped(j, ny) * PHASES + wrapped(i, PHASES)] += s->w[place(s, i, j)];
    fftw_execute(plan);
#pragma omp critical(fftw_planner)
    fftw_destroy_plan(plan);
    return z;
}

/* Stability limit of one wave; infinite if it neither grows nor decays beyond round-off. */
static double allowed(const struct amplification *step, double reach, double floor, double complex lambda) {
    return cabs(lambda) <= floor ? INFINITY : amplification_limit(step, reach, lambda);
}

static void search(const struct symbol *s, const struct amplification *step, double reach, double floor,
                   struct symbol_extreme *e) {
    for (double size = 2 * M_PI / PHASES; size > 1e-9;) {
        int moved = 0;
        for (int d = 0; d < 2 * s->dim; d++) {
            double theta[2] = {e->theta[0], e->theta[1]};
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

struct symbol_extreme symbol_extreme(const struct symbol *s, const struct amplification *step) {
    int ny = s->dim == 2 ? PHASES : 1;
    fftw_complex *z = transform(s, ny);
    struct symbol_extreme e = {.limit = INFINITY, .growth = -INFINITY};
    double reach = amplification_reach(step), unit = 2 * M_PI / PHASES;
    for (int k = 0; k < PHASES * ny; k++) e.radius = fmax(e.radius, cabs(z[k]));
    double floor = 1e-12 * e.radius; /* round-off of a sum of weights */
    for (int k = 0; k < PHASES * ny; k++) {
        double limit = allowed(step, reach, floor, z[k]);
        e.growth = fmax(e.growth, creal(z[k]));
        if (!(limit < e.limit)) continue;
        e.limit = limit;
        e.theta[0] = unit * (k % PHASES), e.theta[1] = unit * (k / PHASES);
    }
    fftw_free(z);
    if (e.limit > 0 && isfinite(e.limit)) search(s, step, reach, floor, &e);
    return e;
}

double symbol_lowest(const struct symbol *s) {
    double lowest = INFINITY, centre = fabs(symbol_weight(s, 0, 0));
    for (int j = -s->reach[1]; j <= s->reach[1]; j++)
        for (int i = -s->reach[0]; i <= s->reach[0]; i++)
            if (i || j) lowest = fmin(lowest, symbol_weight(s, i, j) / centre);
    return lowest;
}
