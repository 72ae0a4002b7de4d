/* A settled cloud: particles that repel each other, as codes that move their particles leave them (particle shifting:
 * Xu, Stansby & Laurence 2009; Lind et al. 2012).
 *
 * One sweep moves every particle down the gradient of the sum of kernels, mirror images beyond the walls among them,
 *   v_i <- 0.8 v_i - 0.2 s sum_j w'(r_ij/H) e_ij / w(0),   x_i <- x_i + v_i,   e_ij = (x_i - x_j)/r_ij,
 * with Wendland's kernel, H = 1.2 s and s the spacing: its Fourier transform is positive, so that particles do not
 * pair (Dehnen & Aly 2012).  No move is longer than 0.1 s.  Settled: the root mean square of a sweep's moves is below
 * SETTLED s.  In the plane grains of a hexagonal lattice are left, with disorder between them, which a longer
 * relaxation moves but does not remove; on a rod even spacing, but for waves that are long. */
#include "solver/space/relax.h"
#include "solver/space/kernel.h"
#include "solver/space/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 1.2, SETTLED = 3e-3, LONGEST = 0.1, STEP = 0.2, KEPT = 0.8;
enum { NEAR_MAX = 256 };

struct medium {
    const struct problem *p;
    const struct options *o;
    double spacing; /* m */
    struct cloud c; /* particles and their images: positions alone */
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

/* The move of particle i, its nearest neighbour (m) and the sum of kernels around it. */
static void push(const struct medium *m, const struct neighbours *cells, size_t i, double *nearest, double *density) {
    const struct cloud *c = &m->c;
    uint32_t near[NEAR_MAX];
    double H = REACH * m->spacing, sum[2] = {0, 0};
    size_t found = neighbours_find(cells, i, near, NEAR_MAX);
    *nearest = HUGE_VAL, *density = kernel_value(KERNEL_WENDLAND, c->dim, 0);
    for (size_t k = 0; k < found && k < NEAR_MAX; k++) {
        double d[2] = {c->x[i] - c->x[near[k]], c->y[i] - c->y[near[k]]}, r = hypot(d[0], d[1]);
        double slope = r > 0 ? -kernel_slope(KERNEL_WENDLAND, c->dim, r / H) / r : 0;
        for (int a = 0; a < c->dim; a++) sum[a] += slope * d[a];
        *nearest = fmin(*nearest, r);
        *density += kernel_value(KERNEL_WENDLAND, c->dim, r / H);
    }
    double unit = STEP * m->spacing / kernel_value(KERNEL_WENDLAND, c->dim, 0);
    double *v = &m->move[2 * i], most = LONGEST * m->spacing;
    for (int a = 0; a < 2; a++) v[a] = KEPT * v[a] + unit * sum[a];
    double length = hypot(v[0], v[1]);
    for (int a = 0; a < 2 && length > most; a++) v[a] *= most / length;
}

/* What moves all, and into *s its size, over the spacing, and the state before it. */
static void sweep(struct medium *m, struct settling *s) {
    struct cloud *c = &m->c;
    struct neighbours cells;
    double *density = xcalloc(c->n, sizeof *density), *nearest = xcalloc(c->n, sizeof *nearest);
    int threads = m->o->threads > 1 ? m->o->threads : 1;
    mirror_all(m);
    neighbours_create(&cells, c, KERNEL_SUPPORT * REACH * m->spacing);
#pragma omp parallel for num_threads(threads)
    for (size_t i = 0; i < c->n; i++) push(m, &cells, i, &nearest[i], &density[i]);
    neighbours_free(&cells);
    double mean = 0, square = 0;
    s->moved = 0, s->nearest = HUGE_VAL;
    for (size_t i = 0; i < c->n; i++) {
        double move2 = m->move[2 * i] * m->move[2 * i] + m->move[2 * i + 1] * m->move[2 * i + 1];
        s->moved += move2 / (m->spacing * m->spacing * (double)c->n);
        s->nearest = fmin(s->nearest, nearest[i] / m->spacing);
        mean += density[i] / (double)c->n;
    }
    for (size_t i = 0; i < c->n; i++) square += (density[i] / mean - 1) * (density[i] / mean - 1) / (double)c->n;
    s->spread = sqrt(square), s->moved = sqrt(s->moved);
    free(density);
    free(nearest);
}

static void displace(struct medium *m) {
    for (size_t i = 0; i < m->c.n; i++) {
        m->c.x[i] += m->move[2 * i];
        if (m->c.dim == 2) m->c.y[i] += m->move[2 * i + 1];
    }
}

int relax_cloud(const struct problem *p, const struct options *o, double spacing, struct cloud *c,
                struct failure *why) {
    struct medium m = {.p = p, .o = o, .spacing = spacing, .c = {.dim = c->dim, .n = c->n}};
    struct settling *s = &c->settling;
    m.c.x = xcalloc(4 * c->n, sizeof *m.c.x);
    m.c.y = xcalloc(4 * c->n, sizeof *m.c.y);
    m.move = xcalloc(2 * c->n, sizeof *m.move);
    memcpy(m.c.x, c->x, c->n * sizeof *c->x);
    memcpy(m.c.y, c->y, c->n * sizeof *c->y);
    for (s->sweeps = 0;; s->sweeps++) {
        sweep(&m, s);
        if (s->moved <= SETTLED || s->sweeps == o->sweeps) break;
        displace(&m);
    }
    memcpy(c->x, m.c.x, c->n * sizeof *c->x);
    memcpy(c->y, m.c.y, c->n * sizeof *c->y);
    free(m.c.x);
    free(m.c.y);
    free(m.move);
    if (s->moved <= SETTLED) return STATUS_OK;
    return refuse(
        why, STATUS_NUMERICAL,
        "--layout relaxed: not settled after %d sweeps (--sweeps): a move is %.2g dx (root mean square), of at most "
        "%.2g; the nearest particles are %.3g dx apart, the density spreads by %.2g %%",
        s->sweeps, s->moved, SETTLED, s->nearest, 100 * s->spread);
}
