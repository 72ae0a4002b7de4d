/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Published dummies of lower order, for the study of walls; in other runs use `fit`. d is the distance from the
 * wall.
 *
 * fixed     T_d = T_w (Pamplona 2019, Fig. 3).  The effective wall is at the dummies, up to dx from its true
 * position: first
 *           order.
 * distance  Morris, Fox & Zhu 1997, J. Comput. Phys. 136:214, for each pair of a particle i and a dummy d:
 *           T_d = T_w - (d_d/d_i) (T_i - T_w),   1 + d_d/d_i at most 1.5. Exact for linear T across the wall unless
 * the bound is active. It is for most pairs, d_d > d_i/2, which weakens the wall by a fraction independent of dx.
 * average   Adami, Hu & Adams 2012, J. Comput. Phys. 231:7057, with the Shepard mean <.> at the dummy:
 *           Dirichlet  T_d = 2 T_w - <T>,   Neumann  T_d = <T> + (d_d + <d>) q/k,   q the flux into the body.
 *           The particles near a dummy have other distances from the wall. At a Dirichlet wall the error of T_d is
 *           (d_d - <d>) dT/dn = O(dx), which costs an order; a flux has the right slope and an error of O(dx^2).
 * image     Marrone et al. 2011, Comput. Methods Appl. Mech. Engrg. 200:1526, with T_m at the mirror point by
 * linear moving
 *           least squares: Dirichlet  T_d = 2 T_w - T_m,   Neumann  T_d = T_m + 2 d q/k,
 *           Robin  T_d = f T_m + (1 - f) T_a,   f = (k - b d)/(k + b d), as for images of particles.
 *           At a corner one reflection follows the other. The error of T_m is O(dx^2), and so is that of mirroring at
 * a curved wall. */
#include "solver/particles/walls.h"

#include "solver/space/kernel.h"

#include <math.h>

/* ---- fixed, distance ---- */

static int hold(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    (void)w, (void)d, (void)why;
    out->offset = 0;
    for (int n = 0; n < site->walls; n++) out->offset += site->value[n] / site->walls;
    return STATUS_OK;
}

const struct wall_treatment walls_fixed = {.kinds = 1u << DIRICHLET, .fill = hold};

const struct wall_treatment walls_distance = {.kinds = 1u << DIRICHLET, .pairs = 1, .fill = hold};

/* ---- average ---- */

static void at_dummy(const struct wall_site *site, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = site->x[a];
}

struct shepard {
    struct wall_sum *out;
    double depth; /* m, <d> */
};

static int average(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct shepard *m = with;
    double sum = 0;
    (void)why;
    m->out->n = near->nb.n, m->depth = 0;
    for (size_t j = 0; j < near->nb.n; j++) {
        double W = kernel_value(w->o->kernel, near->nb.dim, neighbourhood_distance(&near->nb, j) / near->nb.h);
        m->out->from[j] = near->from[j], m->out->share[j] = W;
        sum += W;
    }
    if (!(sum > 0)) return refuse(why, STATUS_NUMERICAL, "a dummy has no neighbour with a positive weight");
    for (size_t j = 0; j < near->nb.n; j++) {
        m->out->share[j] /= sum;
        double x[DIM_MAX];
        layout_cloud_place(w->c, near->from[j], x);
        m->depth += m->out->share[j] * shape_depth(w->p, x);
    }
    return STATUS_OK;
}

/* At an edge or a corner the wall at the larger distance determines the dummy. */
static int fill_average(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                        struct failure *why) {
    int n = 0;
    for (int k = 1; k < site->walls; k++)
        if (site->away[k] > site->away[n]) n = k;
    struct shepard m = {out, 0};
    if (walls_near(w, d, 1, average, &m, why)) return why->status;
    if (w->p->side[site->side[n]] == NEUMANN) {
        out->offset = (site->away[n] + m.depth) * site->value[n] / site->k[n];
        return STATUS_OK;
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] = -out->share[j];
    out->offset = 2 * site->value[n];
    return STATUS_OK;
}

const struct wall_treatment walls_average = {
    .kinds = 1u << DIRICHLET | 1u << NEUMANN, .place = at_dummy, .fill = fill_average};

/* ---- image ---- */

static void at_image(const struct wall_site *site, double x[DIM_MAX]) {
    at_dummy(site, x);
    for (int n = 0; n < site->walls; n++)
        for (int a = 0; a < DIM_MAX; a++) x[a] -= 2 * site->away[n] * site->normal[n][a];
}

static int interpolate(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct wall_sum *out = with;
    double P[NEIGHBOURS_MAX][FIT_TERMS_MAX], target[DIM_MAX + 1] = {1};
    for (size_t j = 0; j < near->nb.n; j++) {
        P[j][0] = 1;
        for (int a = 0; a < DIM_MAX; a++) P[j][a + 1] = near->d[j][a] / near->nb.h;
        out->from[j] = near->from[j];
    }
    out->n = near->nb.n;
    return ssph_fit(&near->nb, w->o->kernel, w->p->dim + 1, P, NULL, target, out->share, why);
}

static int fill_image(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                      struct failure *why) {
    double factor = 1;
    static const size_t least[] = {0, 3, 5, 9};
    double x[DIM_MAX];
    if (walls_near(w, d, least[w->p->dim], interpolate, out, why)) return why->status;
    out->offset = 0;
    at_dummy(site, x);
    for (int n = 0; n < site->walls; n++) {
        enum side s = site->side[n];
        double f = layout_robin_factor(w->p, (int)s, site->k[n], site->away[n]);
        if (w->p->side[s] == DIRICHLET) f = -1;
        double q = w->p->side[s] == NEUMANN ? 2 * site->away[n] / site->k[n] : 1 - f;
        struct foot foot = shape_foot(w->p, (int)s, x);
        out->offset += factor * q * w->p->wall(w->p, s, foot.x, 0);
        factor *= f;
        for (int a = 0; a < DIM_MAX; a++) x[a] = 2 * foot.x[a] - x[a];
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] *= factor;
    return STATUS_OK;
}

const struct wall_treatment walls_image = {
    .kinds = 1u << DIRICHLET | 1u << NEUMANN | 1u << ROBIN, .place = at_image, .fill = fill_image};
