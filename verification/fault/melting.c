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

/* K, of a cell with H: at the melting point, or in a range about it, while it takes its latent heat. */
static double temperature_at(const struct faulty *f, double H) {
    const struct problem *p = &f->problem;
    const double *rho_c = p->phase_rho_c, *range = f->range;
    const double solid = -rho_c[0] * range[0], liquid = p->latent + rho_c[1] * range[1];
    if (H >= liquid) return p->k_ref + (H - p->latent) / rho_c[1];
    if (H <= solid || f->front == FRONT_LOOSE) return p->k_ref + H / rho_c[0];
    return p->k_ref - range[0] + (range[0] + range[1]) * (H - solid) / (liquid - solid);
}

struct melting {
    const struct faulty *f;
    int n;
    double dx;
    double *H, *T, *theta; /* theta[1 + i] of cell i, between those of the sides */
};

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

/* The change of theta from point i to the next; no heat passes a cell at the melting point if it is locked. */
static double rise(const struct melting *m, int i) {
    const double *theta = m->theta + i;
    const int locked = m->f->front == FRONT_LOCKED && i > 0 && i < m->n && (theta[0] == 0 || theta[1] == 0);
    return locked ? 0 : theta[1] - theta[0];
}

static void step(struct melting *m, double t, double dt) {
    const struct problem *p = &m->f->problem;
    const int last = m->n;
    const double to = dt / (m->dx * m->dx);
    for (int i = 0; i < m->n; i++)
        m->T[i] = temperature_at(m->f, m->H[i]), m->theta[1 + i] = kirchhoff_theta(p, m->T[i]);
    for (int hi = 0; hi < 2; hi++) { /* a side is half a cell away: twice its theta less that of the cell */
        const int inner = hi ? last : 1, outer = hi ? last + 1 : 0;
        const double value = p->wall(p, hi ? X_HI : X_LO, hi ? p->hi : p->lo, t);
        m->theta[outer] = p->side[hi] == NEUMANN ? m->theta[inner] + value * m->dx
                                                 : 2 * kirchhoff_theta(p, value) - m->theta[inner];
    }
    double below = rise(m, 0);
    for (int i = 0; i < m->n; i++) {
        double above = rise(m, i + 1);
        m->H[i] += to * (above - below);
        below = above;
    }
}

/* Steps of at most 1/3 of dx^2/kappa are monotone beside a side; kappa of either k and either rho c. */
void melting_solve(const struct faulty *f, double dx, struct field *out) {
    static const double FOURIER = 0.3;
    const struct problem *p = &f->problem;
    const double kappa = fmax(p->phase_k[0], p->phase_k[1]) / fmin(p->phase_rho_c[0], p->phase_rho_c[1]);
    const int n = (int)lround((p->hi[0] - p->lo[0]) / dx), shape[DIM_MAX] = {n, 1, 1};
    field_alloc_lattice(out, 1, shape, NULL);
    struct melting m = {.f = f, .n = n, .dx = dx, .T = out->T};
    m.H = xcalloc((size_t)n, sizeof *m.H);
    m.theta = xcalloc((size_t)n + 2, sizeof *m.theta);
    start(&m);
    const double steps = ceil(p->t_end * kappa / (FOURIER * dx * dx)), dt = p->t_end / steps;
    for (double k = 0; k < steps; k++) step(&m, k * dt, dt);
    for (int i = 0; i < n; i++) m.T[i] = temperature_at(f, m.H[i]);
    free(m.H);
    free(m.theta);
}
