/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dummies by their mirror points (Marrone et al. 2011, Comput. Methods Appl. Mech. Engrg. 200:1526): with T_m at the
 * mirror point by linear moving least squares and d the distance from the wall,
 *   Dirichlet  T_d = 2 T_w - T_m,   Neumann  T_d = T_m + 2 d q/k,   q the flux into the body
 *   Robin      T_d = f T_m + (1 - f) T_a,   f = (k - b d)/(k + b d), as for images of particles
 * At a corner the reflections follow each other.  T_m is off by O(dx^2), and so is the mirror of a wall that bends.
 */
#include "solver/particles/walls.h"

#include <math.h>

static void place(const struct wall_site *site, double x[2]) {
    x[0] = site->x[0], x[1] = site->x[1];
    for (int n = 0; n < site->walls; n++)
        for (int a = 0; a < 2; a++) x[a] -= 2 * site->away[n] * site->normal[n][a];
}

static int attempt(const struct walls_fill *w, const struct wall_near *near, void *with, struct failure *why) {
    struct wall_sum *out = with;
    double P[NEIGHBOURS_MAX][SSPH_TERMS_MAX], target[3] = {1, 0, 0};
    for (size_t j = 0; j < near->nb.n; j++) {
        P[j][0] = 1, P[j][1] = near->d[j][0] / near->nb.h, P[j][2] = near->d[j][1] / near->nb.h;
        out->from[j] = near->from[j];
    }
    out->n = near->nb.n;
    return ssph_fit(&near->nb, w->o->kernel, w->p->dim + 1, P, NULL, target, out->share, &out->condition, why);
}

static int fill(const struct walls_fill *w, size_t d, const struct wall_site *site, struct wall_sum *out,
                struct failure *why) {
    double factor = 1;
    if (walls_near(w, d, w->p->dim == 2 ? 5 : 3, attempt, out, why)) return why->status;
    out->offset = 0;
    double x[2] = {site->x[0], site->x[1]};
    for (int n = 0; n < site->walls; n++) {
        enum side s = site->side[n];
        double f = layout_robin_factor(w->p, (int)s, site->k[n], site->away[n]);
        if (w->p->side[s] == DIRICHLET) f = -1;
        double q = w->p->side[s] == NEUMANN ? 2 * site->away[n] / site->k[n] : 1 - f;
        struct foot foot = shape_foot(w->p, (int)s, x);
        out->offset += factor * q * w->p->wall(w->p, s, foot.x);
        factor *= f;
        for (int a = 0; a < 2; a++) x[a] = 2 * foot.x[a] - x[a];
    }
    for (size_t j = 0; j < out->n; j++) out->share[j] *= factor;
    return STATUS_OK;
}

const struct wall_treatment walls_image = {
    .name = "image",
    .about = "dummies by linear least squares at their mirror points (Marrone et al. 2011)",
    .kinds = 1u << DIRICHLET | 1u << NEUMANN | 1u << ROBIN,
    .place = place,
    .fill = fill};
