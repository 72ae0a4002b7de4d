/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A settled cloud: particles repel each other, as in codes that move their particles (particle shifting: Xu, Stansby
 * & Laurence 2009; Lind et al. 2012).
 *
 * One sweep moves every particle down the gradient of the sum of kernels, including mirror images beyond the walls,
 *   v_i <- 0.8 v_i - 0.2 s sum_j w'(r_ij/H) e_ij / w(0),   x_i <- x_i + v_i,   e_ij = (x_i - x_j)/r_ij,
 * with Wendland's kernel, H = 1.2 s and the spacing s.  The kernel's Fourier transform is positive, which prevents
 * pairing (Dehnen & Aly 2012).  No displacement exceeds 0.1 s.  The cloud has settled when the root mean square
 * displacement of a sweep is below SETTLED s.  In the plane the result consists of grains of a hexagonal lattice
 * with disorder between them, which longer relaxation moves but does not remove; on a rod it is uniform except for
 * long waves. */
#include "solver/space/layout.h"
#include "solver/space/kernel.h"
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 1.2, SETTLED = 3e-3, LONGEST = 0.1, STEP = 0.2, KEPT = 0.8;

struct medium {
    const struct problem *p;
    double spacing; /* m */
    struct cloud c; /* particles and their images: positions only */
    double *move;   /* m, 2 each */
};

/* The images of all particles within the kernel's support of a wall; room for three each. */
static void mirror_all(struct medium *m) {
    double reach = KERNEL_SUPPORT * REACH * m->spacing;
    struct cloud *c = &m->c;
    c->total = c->n;
    for (size_t i = 0; i < c->n; i++)
        for (int image = 1; image < (c->dim == 2 ? 4 : 2); image++) {
            double x[2] = {c->x[i], c->y[i]};
            int near = 1;
            for (int a = 0; a < c->dim; a++) {
                if (!(image >> a & 1)) continue;
                double wall = x[a] - m->p->lo[a] < m->p->hi[a] - x[a] ? m->p->lo[a] : m->p->hi[a];
                near = near && fabs(x[a] - wall) < reach;
                x[a] = 2 * wall - x[a];
            }
            if (!near) continue;
            c->x[c->total] = x[0], c->y[c->total++] = x[1];
        }
}

/* Positions in the order of the cells, so that the points around a point are contiguous. */
struct sorted {
    struct neighbours cells;
    double *at; /* m, 2 each */
};

static void sort_cells(struct medium *m, struct sorted *s) {
    struct cloud *c = &m->c;
    mirror_all(m);
    neighbours_create(&s->cells, c, KERNEL_SUPPORT * REACH * m->spacing);
    s->at = xcalloc(2 * c->total, sizeof *s->at);
    for (size_t k = 0; k < c->total; k++) {
        s->at[2 * k] = c->x[s->cells.point[k]];
        s->at[2 * k + 1] = c->y[s->cells.point[k]];
    }
}

static void free_cells(struct sorted *s) {
    neighbours_free(&s->cells);
    free(s->at);
}

/* Displacement of particle i.  With u = max(0, 1 - r/(2 H)), -w'(s) e_ij/w(0) is (x_i - x_j)/H times 5 u^3, or 3 u^2
 * on a rod. u + |u| = 2 u avoids a branch, since half of the points in the cells are beyond the support. */
static void push(const struct medium *m, const struct sorted *s, size_t i) {
    const double x = m->c.x[i], y = m->c.y[i], H = REACH * m->spacing, half = 1 / (2 * H);
    const int plane = m->c.dim == 2;
    double sum[2] = {0, 0};
    uint32_t begin[NEIGHBOURS_RUNS], end[NEIGHBOURS_RUNS];
    int runs = neighbours_runs(&s->cells, i, begin, end);
    for (int r = 0; r < runs; r++)
        for (uint32_t k = begin[r]; k < end[r]; k++) {
            double dx = x - s->at[2 * k], dy = y - s->at[2 * k + 1], u = 1 - half * sqrt(dx * dx + dy * dy);
            u += fabs(u);
            double slope = u * u * (plane ? u : 1);
            sum[0] += slope * dx;
            sum[1] += slope * dy;
        }
    double *v = &m->move[2 * i], unit = STEP * m->spacing / H * (plane ? 5.0 / 8 : 3.0 / 4),
           most = LONGEST * m->spacing;
    for (int a = 0; a < 2; a++) v[a] = KEPT * v[a] + unit * sum[a];
    double length = sqrt(v[0] * v[0] + v[1] * v[1]);
    for (int a = 0; a < 2 && length > most; a++) v[a] *= most / length;
}

enum { SHARE = 1000 }; /* particles per thread, with some twenty neighbours each, that justify a thread */

/* Computes all displacements; returns their root mean square in units of the spacing. */
static double sweep(struct medium *m, int threads) {
    struct sorted s;
    double moved = 0;
    sort_cells(m, &s);
#pragma omp parallel for num_threads(threads)
    for (size_t i = 0; i < m->c.n; i++) push(m, &s, i);
    free_cells(&s);
    for (size_t i = 0; i < 2 * m->c.n; i++) moved += m->move[i] * m->move[i];
    return sqrt(moved / (double)m->c.n) / m->spacing;
}

static void displace(struct medium *m) {
    for (size_t i = 0; i < m->c.n; i++) {
        m->c.x[i] += m->move[2 * i];
        if (m->c.dim == 2) m->c.y[i] += m->move[2 * i + 1];
    }
}

int relax_cloud(const struct problem *p, const struct options *o, double spacing, struct cloud *c,
                struct failure *why) {
    struct medium m = {.p = p, .spacing = spacing, .c = {.dim = c->dim, .n = c->n}};
    m.c.x = xcalloc(4 * c->n, sizeof *m.c.x);
    m.c.y = xcalloc(4 * c->n, sizeof *m.c.y);
    m.move = xcalloc(2 * c->n, sizeof *m.move);
    memcpy(m.c.x, c->x, c->n * sizeof *c->x);
    memcpy(m.c.y, c->y, c->n * sizeof *c->y);
    size_t worth = c->n / SHARE;
    int threads = o->threads < 2 || worth < 2 ? 1 : worth < (size_t)o->threads ? (int)worth : o->threads;
    int sweeps = 0;
    double moved = sweep(&m, threads);
    for (; moved > SETTLED && sweeps < o->sweeps; sweeps++) {
        displace(&m);
        moved = sweep(&m, threads);
    }
    memcpy(c->x, m.c.x, c->n * sizeof *c->x);
    memcpy(c->y, m.c.y, c->n * sizeof *c->y);
    free(m.c.x);
    free(m.c.y);
    free(m.move);
    if (moved <= SETTLED) return STATUS_OK;
    return refuse(
        why, STATUS_NUMERICAL,
        "--layout relaxed: not settled after %d sweeps: displacement %.2g dx (root mean square), at most %.2g; "
        "use more --sweeps",
        sweeps, moved, SETTLED);
}
