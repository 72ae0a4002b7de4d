/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies by a mean (Adami, Hu & Adams 2012, J. Comput. Phys. 231:7057): with <.> the Shepard mean at the dummy,
 *   Dirichlet  T_d = 2 T_w - <T>
 *   Neumann    T_d = <T> + (d_d + <d>) q/k,   d the distances from the wall, q the flux into the body
 * The particles in reach of a dummy lie at other distances than it does: T_d is off by (d_d - <d>) dT/dn for a held
 * wall, O(dx), which costs an order; a flux meets the slope, and is off by O(dx^2). */
#include "solver/particles/walls.h"

#include "solver/space/kernel.h"

#include <math.h>

static void place(const struct wall_site *site, double x[2]) {
    x[0] = site->x[0], x[1] = site->x[1];
}

struct shepard {
    struct wall_sum *out;
    double depth; /* m, <d> */
};

static int attempt(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct shepard *m = with;
    double sum = 0;
    (void)why;
    m->out->n = near->nb.n, m->depth = 0;
    for (size_t j = 0; j < near->nb.n; j++) {
        double W = kernel_value(w->o->kernel, near->nb.dim, hypot(near->d[j][0], near->d[j][1]) / near->nb.h);
        m->out->from[j] = near->from[j], m->out->share[j] = W;
        sum += W;
    }
    if (!(sum > 0)) return refuse(why, STATUS_NUMERICAL, "a dummy sees no particle with a positive weight");
    for (size_t j = 0; j < near->nb.n; j++) {
        m->out->share[j] /= sum;
        double x[2] = {w->c->x[near->from[j]], w->c->y[near->from[j]]};
        m->depth += m->out->share[j] * shape_depth(w->p, x);
    }
    return STATUS_OK;
}

/* A corner goes by the wall that it is farther beyond. */
static int fill(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    int n = site->walls == 2 && site->away[1] > site->away[0];
    struct shepard m = {out, 0};
    if (walls_near(w, d, 1, attempt, &m, why)) return why->status;
    if (w->p->side[site->side[n]] == NEUMANN) {
        out->offset = (site->away[n] + m.depth) * site->value[n] / site->k[n];
        return STATUS_OK;
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] = -out->share[j];
    out->offset = 2 * site->value[n];
    return STATUS_OK;
}

const struct wall_treatment walls_average = {
    .name = "average",
    .about = "dummies by the mean of the particles around (Adami, Hu & Adams 2012)",
    .kinds = 1u << DIRICHLET | 1u << NEUMANN,
    .place = place,
    .fill = fill};
