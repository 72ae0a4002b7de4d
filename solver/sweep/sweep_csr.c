/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Updates off the lattice, y = rate (A x + g) + self x + old y + start Y0, with A in compressed rows or as two sweeps
 * of first derivatives, A x + g = div(kappa grad x) + g. */
#include "solver/space/gradient.h"
#include "solver/sweep/flush.h"
#include "solver/sweep/sweep.h"
#include "solver/sweep/wavefront.h"

#include <string.h>

#define INLINE static inline __attribute__((always_inline))

/* Two doubles: what every machine of 64 bits has.  No wider ones, since x is not where a vector could load it.  Of
 * 3840 rows of 15 entries (AVX-512) an entry takes 0.32 ns by pairs of single loads, 0.43 by four of them in one
 * vector of four, 0.60 by gathers of four and 0.53 of eight; of 10^6 rows, which come from memory, 1.40, 1.45, 1.36
 * and 1.31. */
typedef double two __attribute__((vector_size(16)));

INLINE two load(const double *from) {
    two v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* Four partial sums a row: additions that do not wait for each other, in an order that does not change. */
INLINE double row_times(double diagonal, const double *restrict value, const uint32_t *restrict column,
                        const double *restrict x, size_t i, size_t k, size_t end) {
    two even = {diagonal * x[i], 0}, odd = {0, 0};
    for (; k + 4 <= end; k += 4) {
        even += load(value + k) * (two){x[column[k]], x[column[k + 1]]};
        odd += load(value + k + 2) * (two){x[column[k + 2]], x[column[k + 3]]};
    }
    for (; k < end; k++) even[0] += value[k] * x[column[k]];
    return (even[0] + even[1]) + (odd[0] + odd[1]);
}

/* What an update has: x and the sum alone; y too; or source, walls' values or Y0 as well. */
enum form { PLAIN, RECURRENCE, WHOLE };

/* y_i, of sum = (A x)_i. */
INLINE double updated(const double *restrict g, struct update u, enum form form, double sum, const double *x,
                      const double *y, size_t i) {
    if (form == PLAIN) return x[i] + u.rate * sum;
    if (form == WHOLE && g) sum += g[i];
    double to = u.rate * sum + u.self * x[i] + u.old * y[i];
    if (form == WHOLE && u.Y0) to += u.start * u.Y0[i];
    return to;
}

INLINE void update_form(const struct heat_operator *a, struct update u, enum form form, const double *restrict x,
                        double *restrict y, size_t begin, size_t end) {
    const double *restrict diagonal = a->diagonal, *restrict value = a->value, *restrict g = a->g;
    const uint32_t *restrict column = a->column;
    const size_t *restrict row = a->row;
    for (size_t i = begin; i < end; i++)
        y[i] = updated(g, u, form, row_times(diagonal[i], value, column, x, i, row[i], row[i + 1]), x, y, i);
}

static void update_rows(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                        size_t begin, size_t end) {
    if (sweep_is_plain(a, u))
        update_form(a, *u, PLAIN, x, y, begin, end);
    else if (!a->g && !u->Y0)
        update_form(a, *u, RECURRENCE, x, y, begin, end);
    else
        update_form(a, *u, WHOLE, x, y, begin, end);
}

/* ---- Several updates in one sweep over the rows, which are read once for all of them (wavefront.c) ---- */

struct sweep {
    const struct heat_operator *a;
    const struct update *u;
    double *const *Y;
};

static void advance_rows(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    const struct sweep *s = what;
    update_rows(s->a, &s->u[k], s->Y[k % 2], s->Y[1 - k % 2], (size_t)lo, (size_t)hi);
}

static void advance_bands(const void *what, int k, ptrdiff_t lo, ptrdiff_t hi) {
    const struct sweep *s = what;
    int lanes = s->a->lanes ? s->a->lanes : options_lanes_most();
    (lanes == 8   ? sweep_bands_8
     : lanes == 4 ? sweep_bands_4
                  : sweep_bands_2)(s->a, &s->u[k], s->Y[k % 2], s->Y[1 - k % 2], lo, hi);
}

/* A rod has one thread: a step of one is too short to share. */
void sweep_csr(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]) {
    struct sweep s = {a, u, Y};
    struct wavefront w = {advance_rows, &s, (ptrdiff_t)a->n, a->band, 256, 8, a->threads};
    if (a->banded) w.advance = advance_bands, w.together = count, w.threads = 1;
    wavefront_sweep(&w, count);
}

enum { SHARE = 5000 }; /* particles that are worth a thread */

/* ---- Two sweeps: the first leaves q = kappa D x at all points, the second takes D . q at the particles.  A pair
 * that another point keeps is read there: every sum is taken by its own particle, in an order that does not change
 * ---- */

static void fill_ghosts(const struct gradient *g, size_t n, double *x) {
    for (size_t k = 0; k < g->total - n; k++) x[n + k] = g->factor[k] * x[g->source[k]] + g->offset[k];
}

/* sum += F d (T_j - T_i) */
INLINE void add_difference(const struct gradient *g, const double *T, size_t i, size_t j, double F, double sum[2]) {
    double slope = F * (T[j] - T[i]);
    sum[0] += slope * (g->place[2 * j] - g->place[2 * i]);
    sum[1] += slope * (g->place[2 * j + 1] - g->place[2 * i + 1]);
}

static void find_fluxes(const struct gradient *g, const double *T, size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++) {
        const double *C = &g->C[3 * i];
        double sum[2] = {0, 0};
        for (uint32_t k = g->kept[i]; k < g->kept[i + 1]; k++) add_difference(g, T, i, g->other[k], g->F[k], sum);
        for (uint32_t k = g->lent[i]; k < g->lent[i + 1]; k++)
            add_difference(g, T, i, g->keeper[k], g->F[g->pair[k]], sum);
        g->flux[2 * i] = g->kappa[0] * (C[0] * sum[0] + C[1] * sum[1]);
        g->flux[2 * i + 1] = g->kappa[1] * (C[1] * sum[0] + C[2] * sum[1]);
    }
}

/* The part of a pair in D . q, C's entries apart. */
INLINE void add_divergence(const struct gradient *g, size_t i, size_t j, double F, double sum[3]) {
    double dx = F * (g->place[2 * j] - g->place[2 * i]), dy = F * (g->place[2 * j + 1] - g->place[2 * i + 1]);
    double qx = g->flux[2 * j] - g->flux[2 * i], qy = g->flux[2 * j + 1] - g->flux[2 * i + 1];
    sum[0] += dx * qx;
    sum[1] += dy * qx + dx * qy;
    sum[2] += dy * qy;
}

static double divergence(const struct gradient *g, size_t i) {
    const double *C = &g->C[3 * i];
    double sum[3] = {0, 0, 0};
    for (uint32_t k = g->kept[i]; k < g->kept[i + 1]; k++) add_divergence(g, i, g->other[k], g->F[k], sum);
    for (uint32_t k = g->lent[i]; k < g->lent[i + 1]; k++) add_divergence(g, i, g->keeper[k], g->F[g->pair[k]], sum);
    double all = C[0] * sum[0] + C[1] * sum[1] + C[2] * sum[2];
    return g->sum ? all + (g->sum[2 * i] * g->flux[2 * i] + g->sum[2 * i + 1] * g->flux[2 * i + 1]) : all;
}

static void update_particles(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                             size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++) y[i] = updated(a->g, *u, WHOLE, divergence(a->gradient, i), x, y, i);
}

/* Both sweeps over particles begin <= i < end.  The second follows the first at the distance that a pair reaches and
 * meets its entries in a cache: they are read from memory once.  It takes lo <= i < hi, whose neighbours have fluxes
 * here or at ghosts. */
static void sweep_twice(const struct heat_operator *a, const struct update *u, const double *x, double *y,
                        size_t begin, size_t end, size_t lo, size_t hi) {
    enum { STRETCH = 256 };
    size_t reach = a->gradient->reach;
    for (size_t front = begin; front < end;) {
        size_t past = end - front > STRETCH ? front + STRETCH : end;
        find_fluxes(a->gradient, x, front, past);
        size_t follow = past == end ? hi : past > lo + reach ? past - reach : lo;
        if (follow > hi) follow = hi;
        update_particles(a, u, x, y, lo, follow);
        front = past, lo = follow;
    }
}

/* Particles of share t that reach into no other. */
static void share_inner(const struct heat_operator *a, size_t threads, size_t t, size_t inner[2]) {
    size_t begin = a->n * t / threads, end = a->n * (t + 1) / threads, reach = a->gradient->reach;
    inner[0] = t == 0 ? begin : begin + reach < end ? begin + reach : end;
    inner[1] = t + 1 == threads ? end : end > inner[0] + reach ? end - reach : inner[0];
}

/* One update; what reaches into another thread's share waits until all fluxes are there. */
static void update_twice(const struct heat_operator *a, const struct update *u, size_t threads, double *x,
                         double *y) {
    const struct gradient *g = a->gradient;
    size_t n = a->n, ghosts = g->total - n;
    fill_ghosts(g, n, x);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        unsigned mode = flush_begin();
#pragma omp for
        for (size_t t = 0; t < threads; t++)
            find_fluxes(g, x, n + ghosts * t / threads, n + ghosts * (t + 1) / threads);
#pragma omp for
        for (size_t t = 0; t < threads; t++) {
            size_t inner[2];
            share_inner(a, threads, t, inner);
            sweep_twice(a, u, x, y, n * t / threads, n * (t + 1) / threads, inner[0], inner[1]);
        }
#pragma omp for
        for (size_t t = 0; t < threads; t++) {
            size_t inner[2];
            share_inner(a, threads, t, inner);
            update_particles(a, u, x, y, n * t / threads, inner[0]);
            update_particles(a, u, x, y, inner[1], n * (t + 1) / threads);
        }
        flush_end(mode);
    }
}

void sweep_gradient(const struct heat_operator *a, const struct update *u, int count, double *const Y[2]) {
    size_t most = a->n / SHARE, threads = a->threads < 1 ? 1 : (size_t)a->threads;
    if (threads > most) threads = most > 0 ? most : 1;
    for (int k = 0; k < count; k++) update_twice(a, &u[k], threads, Y[k % 2], Y[1 - k % 2]);
}
