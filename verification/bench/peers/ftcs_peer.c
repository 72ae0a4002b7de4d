/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A peer for --solver: finite differences, forward in time and central in space, at kappa dt/dx^2 = 1/6 (or the next
 * smaller that takes whole steps), tuned by hand.
 *
 *     ftcs CASE OUT
 *
 * Two arrays with a rim of ghosts take turns; a row is one loop that vectorises; where there are threads, they keep
 * their rows and meet once a step.  kappa_x = kappa_y. */
#include "verification/bench/peers/peer_rectangle.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* The rim of the rows [from, to), and of the lines below and above where those are the body's: ghost = 2 wall - T. */
static void rim(const struct rectangle *p, double *T, int from, int to) {
    int nx = p->n[0], ny = p->n[1], width = nx + 2;
    for (int j = from; j < to; j++) {
        double *row = T + (size_t)(j + 1) * (size_t)width + 1;
        row[-1] = 2 * p->side[0] - row[0];
        row[nx] = 2 * p->side[1] - row[nx - 1];
    }
    double *first = T + width + 1, *last = T + (size_t)ny * (size_t)width + 1;
    if (from == 0)
        for (int i = 0; i < nx; i++) first[i - width] = 2 * p->side[2] - first[i];
    if (to == ny)
        for (int i = 0; i < nx; i++) last[i + width] = 2 * p->side[3] - last[i];
}

static void row_step(int n, double F, double rest, const double *restrict below, const double *restrict row,
                     const double *restrict above, double *restrict next) {
#pragma omp simd
    for (int i = 0; i < n; i++) next[i] = rest * row[i] + F * ((row[i - 1] + row[i + 1]) + (below[i] + above[i]));
}

static void march(const struct rectangle *p, double *T, double *next, long steps) {
    double F = p->kappa[0] * p->t_end / (double)steps / (p->dx * p->dx);
    size_t width = (size_t)p->n[0] + 2;
#pragma omp parallel num_threads(p->threads) if (p->n[0] * p->n[1] >= RECTANGLE_FEW)
    {
        int k = omp_get_thread_num(), of = omp_get_num_threads();
        int from = (int)((long)p->n[1] * k / of), to = (int)((long)p->n[1] * (k + 1) / of);
        double *a = T, *b = next;
        rim(p, a, from, to);
        for (long s = 0; s < steps; s++) {
#pragma omp barrier
            for (int j = from; j < to; j++) {
                const double *row = a + (size_t)(j + 1) * width + 1;
                row_step(p->n[0], F, 1 - 4 * F, row - width, row, row + width, b + (row - a));
            }
            rim(p, b, from, to);
            double *swap = a;
            a = b;
            b = swap;
        }
    }
}

/* T and next: with a rim of one point. */
static void solve(const struct rectangle *p, long steps, double *body, double *T, double *next) {
    size_t nx = (size_t)p->n[0], ny = (size_t)p->n[1], width = nx + 2;
    rectangle_start(p, body);
    for (size_t j = 0; j < ny; j++) memcpy(T + (j + 1) * width + 1, body + j * nx, nx * sizeof *body);
    march(p, T, next, steps);
    const double *end = steps % 2 ? next : T;
    for (size_t j = 0; j < ny; j++) memcpy(body + j * nx, end + (j + 1) * width + 1, nx * sizeof *body);
}

int main(int argc, char **argv) {
    if (argc != 3) rectangle_die("usage: ftcs CASE OUT");
    struct rectangle p = rectangle_read(argv[1]);
    if (p.kappa[0] != p.kappa[1]) rectangle_die("ftcs: one kappa");
    size_t nx = (size_t)p.n[0], ny = (size_t)p.n[1], size = (nx + 2) * (ny + 2);
    double *body = malloc(nx * ny * sizeof *body), *T = calloc(size, sizeof *T), *next = calloc(size, sizeof *T);
    if (!body || !T || !next) rectangle_die("out of memory");
    long steps = (long)ceil(6 * p.kappa[0] * p.t_end / (p.dx * p.dx) * (1 - 1e-12));
    double start = omp_get_wtime(), begin, seconds;
    do {
        begin = omp_get_wtime();
        solve(&p, steps, body, T, next);
        seconds = omp_get_wtime() - begin;
    } while (begin - start < RECTANGLE_WARM);
    rectangle_write(&p, body, argv[2], seconds, steps);
    free(body);
    free(T);
    free(next);
    return 0;
}
