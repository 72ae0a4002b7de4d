/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Norms of the error (Song 2018, eq. 46); range, variation and heat of a field. */
#include "verification/judge/norms.h"

#include "references/mapping.h"
#include "references/snapshot.h"
#include "solver/method.h"
#include "solver/shape.h"
#include "solver/time/transform.h"
#include "verification/text/number.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double weight(const struct field *f, size_t i) {
    return f->weight ? f->weight[i] : 1;
}

enum { CHUNK = 2000 }; /* points per evaluation */

/* Exact values at the n points from `first` on. */
static void exact_chunk(const struct snapshot *now, const struct field *f, size_t first, size_t n, struct exact *e) {
    double at[DIM_MAX], x[DIM_MAX][CHUNK];
    for (size_t i = 0; i < n; i++) {
        field_place(f, first + i, at);
        for (int a = 0; a < DIM_MAX; a++) x[a][i] = at[a];
    }
    snapshot_at_points(now, n, x[0], f->dim > 1 ? x[1] : NULL, f->dim > 2 ? x[2] : NULL, e);
}

/* Many points are evaluated by many threads; the sums are in the order of the points and do not depend on their
 * number. */
double norms_exact(const struct scene *s, const struct problem *p, const struct field *f, double *T) {
    double bound = 0, whole = 0;
    struct snapshot now = snapshot_take(s, p, f->time);
#pragma omp parallel for ordered schedule(dynamic, 1) if (f->n >= NORMS_MANY)
    for (size_t first = 0; first < f->n; first += CHUNK) {
        size_t n = f->n - first < CHUNK ? f->n - first : CHUNK;
        struct exact *e = xcalloc(n, sizeof *e);
        exact_chunk(&now, f, first, n, e);
#pragma omp ordered
        for (size_t k = 0, i = first; k < n; k++, i++) {
            T[i] = e[k].no_value ? NORMS_NO_VALUE : isfinite(e[k].temperature) ? e[k].temperature : NAN;
            if (e[k].no_value) continue;
            bound += weight(f, i) * e[k].error_bound;
            whole += weight(f, i) * fabs(T[i]);
        }
        free(e);
    }
    snapshot_free(&now);
    return bound / whole;
}

int norms_check(const struct field *f, const double *exact, struct failure *why) {
    size_t without = 0;
    for (size_t i = 0; i < f->n; i++) {
        if (exact[i] != 0 && exact[i] != NORMS_NO_VALUE) return STATUS_OK;
        without += exact[i] == NORMS_NO_VALUE;
    }
    if (without == f->n)
        return refuse(why, STATUS_INPUT,
                      "the exact solution has no value at any of the points (%zu, all in corners between "
                      "different temperatures); use points away from the corners",
                      f->n);
    return refuse(
        why, STATUS_INPUT,
        "the exact solution, to which E1 is relative, is 0 K at all points at t = %g s; use other temperatures "
        "(--set) or an earlier end (--t-end)",
        f->time);
}

unsigned char *norms_near(const struct problem *p, const struct field *f, double distance) {
    unsigned char *near = xcalloc(f->n, 1);
#pragma omp parallel for if (f->n >= NORMS_MANY)
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX];
        near[i] = shape_depth(p, field_place(f, i, x)) < distance;
    }
    return near;
}

enum part { ALL, INTERIOR, BOUNDARY };

/* 1 if point i belongs to the part and has an exact value. */
static int counts(const double *exact, enum part part, const unsigned char *near, size_t i) {
    return exact[i] != NORMS_NO_VALUE && (part == ALL || (near && near[i] == (part == BOUNDARY)));
}

/* The largest power of 2 up to x, by which division is exact; 1 for 0, infinity and NaN. */
static double power_below(double x) {
    return x > 0 && isfinite(x) ? scalbn(1, ilogb(x)) : 1;
}

/* (sum w |T - Te|^p / sum w |Te|^p)^(1/p), p = 1 (Song 2018, eq. 46) or 2.  Errors, temperatures and weights are
 * scaled by their maximum first, so that no sum overflows or underflows. */
static double relative(int p, enum part part, const struct field *f, const double *exact, const unsigned char *near) {
    double most[3] = {0}, unit[3], sum[2] = {0};
    for (size_t i = 0; i < f->n; i++) {
        if (!counts(exact, part, near, i)) continue;
        most[0] = fmax(most[0], fabs(f->T[i] - exact[i]));
        most[1] = fmax(most[1], fabs(exact[i]));
        most[2] = fmax(most[2], weight(f, i));
    }
    for (int k = 0; k < 3; k++) unit[k] = power_below(most[k]);
    for (size_t i = 0; i < f->n; i++) {
        if (!counts(exact, part, near, i)) continue;
        double e = fabs(f->T[i] - exact[i]) / unit[0], T = fabs(exact[i]) / unit[1], w = weight(f, i) / unit[2];
        sum[0] += w * (p == 1 ? e : e * e);
        sum[1] += w * (p == 1 ? T : T * T);
    }
    double ratio = sum[0] / sum[1];
    return (p == 1 ? ratio : sqrt(ratio)) * (unit[0] / unit[1]);
}

double norms_l1(const struct field *f, const double *exact, const unsigned char *near) {
    return relative(1, ALL, f, exact, near);
}

double norms_l2(const struct field *f, const double *exact, const unsigned char *near) {
    return relative(2, ALL, f, exact, near);
}

double norms_interior(const struct field *f, const double *exact, const unsigned char *near) {
    return relative(1, INTERIOR, f, exact, near);
}

double norms_boundary(const struct field *f, const double *exact, const unsigned char *near) {
    return relative(1, BOUNDARY, f, exact, near);
}

/* max |T - Te|, K */
double norms_linf(const struct field *f, const double *exact, const unsigned char *near) {
    double most = -INFINITY;
    for (size_t i = 0; i < f->n; i++) {
        if (!counts(exact, ALL, near, i)) continue;
        double e = fabs(f->T[i] - exact[i]);
        if (!(e <= most)) most = e; /* a NaN replaces it, */
        if (isnan(e)) break;        /* and stays */
    }
    return most >= 0 ? most : NAN;
}

void norms_all(const struct field *f, const double *exact, const unsigned char *near, double error[NORM_QUANTITY]) {
    static double (*const of[])(const struct field *f, const double *exact, const unsigned char *near) = {
#define NORM(NAME, word, title, column, key, of) norms_##of,
#include "verification/case/norms.def"
#undef NORM
    };
#pragma omp parallel for schedule(dynamic, 1) if (f->n >= NORMS_MANY)
    for (int k = 0; k < NORM_QUANTITY; k++) error[k] = of[k](f, exact, near);
}

size_t norms_left_out(const struct field *f, const double *exact) {
    size_t n = 0;
    for (size_t i = 0; i < f->n; i++) n += exact[i] == NORMS_NO_VALUE;
    return n;
}

/* Widens [lo, hi] by the temperatures of Dirichlet walls and of the air at Robin walls, at the foot of each
 * point. */
static void widen(const struct problem *p, const struct field *f, double *lo, double *hi) {
    double coldest = *lo, hottest = *hi;
    for (int s = 0; s < 2 * p->dim; s++) {
        if (!shape_has_wall(p, s) || !problem_has_wall_temperature(p, s)) continue;
        size_t n = p->dim == 1 ? 1 : f->n;
#pragma omp parallel for reduction(min : coldest) reduction(max : hottest) if (n >= NORMS_MANY)
        for (size_t i = 0; i < n; i++) {
            double x[DIM_MAX];
            struct foot foot = shape_foot(p, s, field_place(f, i, x));
            problem_wall_range(p, (enum side)s, foot.x, &coldest, &hottest);
        }
    }
    *lo = coldest, *hi = hottest;
}

/* On a rod sum |T_{i+1} - T_i|; else the sums along each axis times the spacings of the others. */
static double variation(const struct field *f) {
    if (f->shape[0] == 0) return NAN;
    double sum = 0;
    size_t stride = 1;
    for (int a = 0; a < f->dim; a++) {
        size_t block = f->dim == 1 ? f->n : stride * (size_t)f->shape[a]; /* walls may cut a rod */
        double along = 0, across = 1;
        for (size_t first = 0; first < f->n; first += block)
            for (size_t i = first; i + stride < first + block; i++) along += fabs(f->T[i + stride] - f->T[i]);
        for (int b = 0; b < f->dim; b++) across *= b == a ? 1 : f->spacing[b];
        sum += along * across;
        stride = block;
    }
    return sum;
}

struct norms_shape norms_shape(const struct problem *p, const struct field *f, double *exact) {
    struct norms_shape shape = {.min = INFINITY, .max = -INFINITY};
    double lo = f->range[0], hi = f->range[1], sum = 0;
    for (size_t i = 0; i < f->n; i++) {
        shape.min = fmin(shape.min, f->T[i]);
        shape.max = fmax(shape.max, f->T[i]);
        sum += f->T[i];
    }
    if (isnan(sum)) shape.min = shape.max = NAN; /* fmin and fmax skip a NaN */
    if (!(shape.min >= lo && shape.max <= hi)) widen(p, f, &lo, &hi);
    shape.overshoot = shape.max <= hi ? 0 : shape.max - hi;
    shape.undershoot = shape.min >= lo ? 0 : lo - shape.min;
    shape.variation = variation(f);
    shape.checkerboard = norms_checkerboard(p, f, exact);
    return shape;
}

double norms_heat_drift(const struct field *f) {
    return (f->heat[1] - f->heat[0]) / fabs(f->heat[0]);
}

/* Rounding to a unit u has a mean error of u/4.  A program prints T of the case; mapping to the scene and back adds
 * rounding errors of the largest T or of the offset. */
double norms_digits(const struct field *f, const struct mapping *map, int *digits) {
    enum { POINTS = 500 };
    size_t stride = f->n / POINTS + 1, n = 0;
    double T[POINTS], sum = 0, scale = mapping_scale(map);
    double off = mapping_is_none(map) ? 0 : 4 * DBL_EPSILON * (scale * field_largest(f) + fabs(map->offset));
    for (size_t i = 0; i < f->n; i += stride) {
        T[n++] = mapping_temperature(map, f->T[i]);
        sum += scale * fabs(f->T[i]);
    }
    double units = number_units(T, n, off, digits);
    return sum > 0 ? units / 4 / sum : 0;
}

/* ---- Checkerboard ---- */

/* Amplitude of the checkerboard in a field, by a sine or cosine transform along each axis.
 *
 * The transform is that of the error T - Te, not of T, so that short wavelengths of the exact solution (such as a
 * jump) do not count as oscillations.
 *
 * Its modes vanish on a Dirichlet wall and are flat on a Neumann wall, like the error.  Cosines on a Dirichlet wall
 * would have a kink: a slope of s K/m at the wall leaks s (hi - lo) / (pi k)^2 into mode k, more than the amplitudes
 * of interest.
 *
 * The upper half of the band, 2 to 4 points per wavelength along some axis, is searched, not only the highest mode
 * (-1)^j.  That mode is odd about the middle of an even number of points, so a symmetric scene never excites it; its
 * neighbours carry the checkerboard. */

/* The lattice (solver/space/layout.h) of a field: points half a spacing inside the walls, or on them, without those
 * on a Dirichlet wall and with those on a Neumann wall. */
static struct lattice lattice_of(const struct problem *p, const struct field *f) {
    struct lattice l = {.dim = f->dim, .n = {1, 1, 1}};
    for (int a = 0; a < f->dim; a++) l.n[a] = f->shape[a];
    for (int s = 0; s < 2 * f->dim; s++) {
        const double *x = f->x[s / 2];
        int half = fabs((x[0] - p->lo[s / 2]) / f->spacing[s / 2] - 0.5) < 0.25;
        l.sign[s] = p->side[s] == DIRICHLET ? -1 : 1;
        l.shift[s] = half ? 0 : l.sign[s];
    }
    return l;
}

/* The transform of a mode of amplitude c is c times the number of spacings, twice that at the ends of the band. */
static double doubled(double theta) {
    return theta <= 0 || theta >= M_PI ? 2 : 1;
}

/* Past dim theta is long and not at an end. */
static double largest(const struct lattice *l, const double *Y) {
    double most = 0, spacings = transform_scale(l) / (1 << l->dim), *theta[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) {
        theta[a] = xcalloc((size_t)l->n[a], sizeof **theta);
        for (int k = 0; k < l->n[a]; k++) theta[a][k] = a < l->dim ? transform_angle(l, a, k) : M_PI / 4;
    }
    for (int k = 0; k < l->n[2]; k++)
        for (int j = 0; j < l->n[1]; j++) {
            double highest = fmax(theta[1][j], theta[2][k]),
                   times = spacings * doubled(theta[1][j]) * doubled(theta[2][k]);
            for (int i = 0; i < l->n[0]; i++, Y++) {
                double amplitude = fabs(*Y) / (times * doubled(theta[0][i]));
                if (highest < M_PI / 2 && theta[0][i] < M_PI / 2) continue;
                if (!(amplitude <= most) && !isnan(most)) most = amplitude;
            }
        }
    for (int a = 0; a < DIM_MAX; a++) free(theta[a]);
    return most;
}

double norms_checkerboard(const struct problem *p, const struct field *f, double *exact) {
    for (int a = 0; a < f->dim; a++)
        if (f->shape[a] < 2) return NAN;
    struct lattice l = lattice_of(p, f);
    struct transform *t = transform_create(&l);
    for (size_t i = 0; i < f->n; i++) exact[i] = exact[i] == NORMS_NO_VALUE ? 0 : f->T[i] - exact[i];
    transform_forward(t, exact);
    double amplitude = largest(&l, exact);
    transform_free(t);
    return amplitude;
}
