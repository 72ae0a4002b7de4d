/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Phases with faults of the front, which no problem of the solver has: H is the enthalpy from the melting point,
 *
 *     dH/dt = lap theta,   theta the integral of k from the melting point
 *
 * by Euler's steps on the cells of a rod, between sides that are held or have a given flux. */
#include "verification/fault/melting.h"

#include "references/kirchhoff.h"
#include "solver/status.h"

#include <math.h>
#include <stdlib.h>

static double heat_at(const struct problem *p, double T) {
    double u = T - p->k_ref;
    return p->phase_rho_c[u > 0] * u + (u > 0 ? p->latent : 0);
}

/* T from H by three lines, u = from + slope (H - at) above the melting point: solid; at the melting point, or in a
 * range about it, while a cell takes its latent heat; liquid. */
struct melting {
    const struct faulty *f;
    int n;
    double dx;
    double solid, liquid; /* J m^-3, where the lines end */
    struct line {
        double at, from, slope; /* J m^-3; K; K m^3 J^-1 */
    } line[3];
    double *H, *theta; /* theta[1 + i] of cell i, between those of the sides */
    double *rise;      /* from theta[i] to the next */
};

static void lines(struct melting *m) {
    const struct problem *p = &m->f->problem;
    const double *rho_c = p->phase_rho_c, *range = m->f->range;
    m->solid = -rho_c[0] * range[0], m->liquid = p->latent + rho_c[1] * range[1];
    m->line[0] = (struct line){0, 0, 1 / rho_c[0]};
    m->line[1] = (struct line){m->solid, -range[0], (range[0] + range[1]) / (m->liquid - m->solid)};
    m->line[2] = (struct line){p->latent, 0, 1 / rho_c[1]};
    if (m->f->front == FRONT_LOOSE) m->line[1] = m->line[0];
}

/* K, above the melting point. */
static inline double above(const struct melting *m, double H) {
    const struct line *l = m->line;
    const double solid = l[0].slope * H, melts = l[1].from + l[1].slope * (H - l[1].at);
    const double liquid = l[2].slope * (H - l[2].at);
    return H >= m->liquid ? liquid : H > m->solid ? melts : solid;
}

/* Means of H over each cell, by as many points: the front is known to half a part. */
static void start(struct melting *m) {
    enum { PARTS = 16 };
    const struct problem *p = &m->f->problem;
    for (int i = 0; i < m->n; i++)
        for (int k = 0; k < PARTS; k++) {
            double x[DIM_MAX] = {p->lo[0] + (i + (k + 0.5) / PARTS) * m->dx};
            m->H[i] += heat_at(p, p->initial(p, x)) / PARTS;
        }
}

static void step(struct melting *m, double t, double dt) {
    const struct problem *p = &m->f->problem;
    const int last = m->n;
    const double to = dt / (m->dx * m->dx), solid = p->phase_k[0], liquid = p->phase_k[1];
    double *restrict H = m->H, *restrict theta = m->theta, *restrict rise = m->rise;
    for (int i = 0; i < m->n; i++) {
        const double u = above(m, H[i]);
        theta[1 + i] = (u > 0 ? liquid : solid) * u;
    }
    for (int hi = 0; hi < 2; hi++) { /* a side is half a cell away: twice its theta less that of the cell */
        const int inner = hi ? last : 1, outer = hi ? last + 1 : 0;
        const double value = p->wall(p, hi ? X_HI : X_LO, hi ? p->hi : p->lo, t);
        theta[outer] =
            p->side[hi] == NEUMANN ? theta[inner] + value * m->dx : 2 * kirchhoff_theta(p, value) - theta[inner];
    }
    for (int i = 0; i <= last; i++) rise[i] = theta[i + 1] - theta[i];
    for (int i = 1; i < last && m->f->front == FRONT_LOCKED; i++) /* no heat passes a cell at the melting point */
        if (theta[i] == 0 || theta[i + 1] == 0) rise[i] = 0;
    for (int i = 0; i < last; i++) H[i] += to * (rise[i + 1] - rise[i]);
}

/* Steps of at most 1/3 of dx^2/kappa are monotone beside a side; kappa of either k and either rho c. */
void melting_solve(const struct faulty *f, double dx, struct field *out) {
    static const double FOURIER = 0.3;
    const struct problem *p = &f->problem;
    const double kappa = fmax(p->phase_k[0], p->phase_k[1]) / fmin(p->phase_rho_c[0], p->phase_rho_c[1]);
    const int n = (int)lround((p->hi[0] - p->lo[0]) / dx), shape[DIM_MAX] = {n, 1, 1};
    field_alloc_lattice(out, 1, shape, NULL);
    struct melting m = {.f = f, .n = n, .dx = dx};
    lines(&m);
    m.H = xcalloc((size_t)n, sizeof *m.H);
    m.theta = xcalloc((size_t)n + 2, sizeof *m.theta);
    m.rise = xcalloc((size_t)n + 1, sizeof *m.rise);
    start(&m);
    const double steps = ceil(p->t_end * kappa / (FOURIER * dx * dx)), dt = p->t_end / steps;
    for (double k = 0; k < steps; k++) step(&m, k * dt, dt);
    for (int i = 0; i < n; i++) out->T[i] = p->k_ref + above(&m, m.H[i]);
    free(m.H);
    free(m.theta);
    free(m.rise);
}
