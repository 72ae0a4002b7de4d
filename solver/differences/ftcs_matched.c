/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The matched run of the finite differences.  With a steady source Euler's error is
 *
 *     -(dt/2) T_tt = -(dt/2) (kappa^2 T_xxxx + kappa G_xx/rho_c).
 *
 * At kappa dt/dx^2 = 2A its first part cancels the spatial error A kappa dx^2 T_xxxx.  The source G + A dx^2 G_xx
 * cancels the second part, and the spatial error of the steady state. */
#include "solver/differences/ftcs_matched.h"

#include "solver/problem.h"
#include "solver/status.h"

#include <math.h>

int ftcs_matched_points(const struct ftcs_grid *g, const struct problem *p, int *m, struct failure *why) {
    double size = 0, jump[JUMP_MAX + 2];
    int jumps = 0, slopes = 0;
    for (int i = 0; i < g->n[0]; i++)
        size = fmax(size, fabs(p->initial(p, (double[2]){g->origin[0] + i * g->d[0], 0})));
    for (int k = 0; k < p->jumps[0]; k++)
        if (p->jump[0][k] > p->lo[0] && p->jump[0][k] < p->hi[0]) jump[jumps++] = p->jump[0][k];
    for (int s = X_LO; s <= X_HI; s++) {
        double foot[2] = {s == X_HI ? p->hi[0] : p->lo[0], 0},
               apart = p->initial(p, foot) - p->wall(p, (enum side)s, foot, 0);
        if (p->side[s] == DIRICHLET && fabs(apart) > 1e-9 * fmax(size, fabs(apart))) jump[jumps++] = foot[0];
    }
    for (int k = 0; k < jumps; k++) {
        double cells = (jump[k] - g->origin[0]) / g->d[0] + 0.5;
        if (fabs(cells - nearbyint(cells)) > 1e-6)
            return refuse(why, STATUS_NOT_APPLICABLE,
                          "--stepper matched: the initial data jump at x = %g m, not midway between two points; use "
                          "--sampling spline",
                          jump[k]);
    }
    for (int i = 0; i + 1 < g->n[0]; i++) {
        double x = g->origin[0] + i * g->d[0], next = x + g->d[0];
        int across = 0;
        for (int k = 0; k < jumps; k++) across |= x < jump[k] && jump[k] < next;
        slopes |= !across && p->initial(p, (double[2]){x, 0}) != p->initial(p, (double[2]){next, 0});
    }
    if (jumps && slopes)
        return refuse(why, STATUS_NOT_APPLICABLE,
                      "--stepper matched: the initial data jump and vary between the jumps; use --sampling spline");
    *m = jumps ? -1 : 0;
    return STATUS_OK;
}

double ftcs_matched_source(const struct ftcs_grid *g, const struct problem *p, const double x[2]) {
    double lo[2] = {x[0] - g->d[0], x[1]}, hi[2] = {x[0] + g->d[0], x[1]};
    return (g->with_fluxes ? 1. / 3 : 1. / 12) * (p->source(p, lo) - 2 * p->source(p, x) + p->source(p, hi));
}
