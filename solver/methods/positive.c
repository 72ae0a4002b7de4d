/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Positive stencils (Seibold 2008, Comput. Methods Appl. Mech. Engrg. 198:592).  Among all weights w_j >= 0 that
 * are exact for quadratics, sum w_j d_j = 0 and sum w_j d_j d_j^T = 2 diag(kappa), a linear programme for
 * each particle selects those with minimal sum_j w_j r_j^2/W_j.
 *
 * The solution of a linear programme, unlike that of least squares with w >= 0, is a vertex: at most five neighbours
 * for the five conditions in the plane (two on a rod, nine in space), the nearest that suffice.  If there is no
 * solution, its first phase proves it.  On a lattice the result is the five-point difference: sum w r^2 is given, and
 * the nearest neighbours have the largest W.  Exact for quadratics: O(dx) of random sign at a particle, second order
 * in T on any cloud (as so_ssph). The maximum principle holds for steps below 1/max sum w; no mode grows, by
 * Gershgorin.  Heat is not conserved, since w_ij and w_ji differ.
 *
 * A neighbour in each of the eight sectors of 45 degrees about a particle is sufficient (his theorem 4.2), not
 * necessary.  The default h/dx is therefore 1.75, with 36 neighbours; no cloud of jitter up to 0.5 was seen without
 * a solution.  In space it is 1.5, with 112 neighbours: of 32000 particles of jitter 0.5 none lacks a solution
 * at 1.3, one at 1.1. k_x != k_y requires neighbours near the axis of the larger one: h grows with sqrt(k ratio).
 *
 * The programme is solved by the simplex method on five or nine rows with the inverse of the basis (Dantzig's rule;
 * after a while Bland's, which cannot cycle), in units of h. */
#include "solver/particles/particles.h"
#include "solver/space/kernel.h"

#include <math.h>
#include <string.h>

enum { ROWS = 9 };

struct programme { /* min cost.w, sum_j column[j] w_j = right, w >= 0; columns j >= n are artificial, one per row */
    int rows;
    size_t n;
    double column[(NEIGHBOURS_MAX + ROWS) * ROWS], cost[NEIGHBOURS_MAX + ROWS], right[ROWS];
    size_t basis[ROWS];
    unsigned char basic[NEIGHBOURS_MAX + ROWS]; /* 1: in the basis */
    double inverse[ROWS][ROWS], value[ROWS];    /* inverse of the basis; values of its weights */
};

static double default_h(const struct problem *p) {
    const double *k = p->material[0].k;
    double ratio = 1;
    for (int a = 0; a < p->dim; a++)
        for (int b = 0; b < a; b++) ratio = fmax(ratio, fmax(k[a] / k[b], 1 / (k[a] / k[b])));
    return p->dim == 1 ? 1.1 : (p->dim == 2 ? 1.75 : 1.5) * sqrt(ratio);
}

static void fill(const struct neighbourhood *nb, enum kernel_name kernel, struct programme *lp) {
    lp->rows = nb->dim * (nb->dim + 3) / 2, lp->n = nb->n;
    memset(lp->basic, 0, nb->n);
    for (size_t j = 0; j < nb->n; j++) {
        double x = nb->d[j][0] / nb->h, y = nb->d[j][1] / nb->h, z = nb->d[j][2] / nb->h;
        double all[ROWS] = {x, x * x, y, y * y, x * y, z, z * z, x * z, y * z}, r2 = x * x + y * y + z * z,
               W = kernel_value(kernel, nb->dim, sqrt(r2));
        for (int k = 0; k < lp->rows; k++) lp->column[j * (size_t)lp->rows + (size_t)k] = all[k];
        lp->cost[j] = W > 0 && r2 > 0 ? r2 / W : INFINITY; /* never used */
    }
    double right[ROWS] = {0, 2 * nb->kappa[0], 0, 2 * nb->kappa[1], 0, 0, 2 * nb->kappa[2]};
    for (int k = 0; k < lp->rows; k++) {
        lp->right[k] = lp->value[k] = right[k] / (nb->h * nb->h);
        lp->basis[k] = nb->n + (size_t)k;
        for (int l = 0; l < lp->rows; l++)
            lp->column[lp->basis[k] * (size_t)lp->rows + (size_t)l] = lp->inverse[k][l] = k == l;
    }
}

/* Cost of a column; in the first phase only artificial columns have a cost. */
static double cost_of(const struct programme *lp, size_t j, int phase) {
    return j >= lp->n ? phase == 1 : phase == 1 ? 0 : lp->cost[j];
}

/* The entering column: the one with the smallest reduced cost, or the first with a negative one; lp->n if there is
 * none.  The reduced cost of a basic column is zero up to the rounding of the inverse, which may exceed the
 * tolerance. */
static size_t entering(const struct programme *lp, int phase, int first) {
    const int rows = lp->rows;
    double y[ROWS] = {0}, least = phase == 1 ? -1e-11 : -1e-10;
    size_t best = lp->n;
    for (int k = 0; k < rows; k++)
        for (int l = 0; l < rows; l++) y[l] += cost_of(lp, lp->basis[k], phase) * lp->inverse[k][l];
    for (size_t j = 0; j < lp->n; j++) {
        double reduced = cost_of(lp, j, phase), size = reduced;
        if (!isfinite(lp->cost[j])) continue;
        const double *column = lp->column + j * (size_t)rows;
        for (int l = 0; l < rows; l++) reduced -= y[l] * column[l], size += fabs(y[l] * column[l]);
        if (!(reduced < least * size) || lp->basic[j]) continue;
        best = j, least = reduced / size;
        if (first) break;
    }
    return best;
}

/* The leaving row for a column u = B^-1 a_j; -1 if unbounded.  Artificial columns at 0 leave first. */
static int leaving(const struct programme *lp, const double *u, int phase) {
    int best = -1;
    double least = INFINITY;
    for (int k = 0; k < lp->rows; k++) {
        double ratio = u[k] > 1e-9 ? lp->value[k] / u[k] : INFINITY;
        if (phase == 2 && lp->basis[k] >= lp->n && fabs(u[k]) > 1e-9) ratio = 0;
        if (ratio < least || (ratio == least && best >= 0 && ratio < INFINITY && lp->basis[k] > lp->basis[best]))
            best = k, least = ratio;
    }
    return best;
}

static void exchange(struct programme *lp, int row, size_t j, const double *u) {
    double pivot = 1 / u[row];
    lp->value[row] *= pivot;
    for (int l = 0; l < lp->rows; l++) lp->inverse[row][l] *= pivot;
    for (int k = 0; k < lp->rows; k++) {
        if (k == row) continue;
        lp->value[k] -= u[k] * lp->value[row];
        if (lp->value[k] < 0) lp->value[k] = 0; /* by round-off */
        for (int l = 0; l < lp->rows; l++) lp->inverse[k][l] -= u[k] * lp->inverse[row][l];
    }
    lp->basic[lp->basis[row]] = 0, lp->basic[j] = 1;
    lp->basis[row] = j;
}

/* Exchanges columns until none reduces the cost. */
static int minimise(struct programme *lp, int phase) {
    enum { DANTZIG = 60, MOST = 2000 };
    for (int step = 0; step < MOST; step++) {
        double u[ROWS] = {0};
        size_t j = entering(lp, phase, step > DANTZIG);
        if (j == lp->n) return 0;
        for (int k = 0; k < lp->rows; k++)
            for (int l = 0; l < lp->rows; l++)
                u[k] += lp->inverse[k][l] * lp->column[j * (size_t)lp->rows + (size_t)l];
        int row = leaving(lp, u, phase);
        if (row < 0) return -1;
        exchange(lp, row, j, u);
    }
    return -1;
}

/* Residual of the conditions after the first phase, relative to their size. */
static double unmet(const struct programme *lp) {
    double left = 0, all = 0;
    for (int k = 0; k < lp->rows; k++) {
        all += fabs(lp->right[k]);
        if (lp->basis[k] >= lp->n) left += lp->value[k];
    }
    return left / all;
}

/* The weights of the final basis, solved directly from the conditions. */
static void basis_weights(const struct programme *lp, double *w) {
    for (size_t j = 0; j < lp->n; j++) w[j] = 0;
    for (int k = 0; k < lp->rows; k++) {
        double value = 0;
        for (int l = 0; l < lp->rows; l++) value += lp->inverse[k][l] * lp->right[l];
        if (lp->basis[k] < lp->n) w[lp->basis[k]] = fmax(0, value);
    }
}

static int weights(const struct problem *p, const struct options *o, const struct neighbourhood *nb, double *w[],
                   struct failure *why) {
    (void)p;
    char place[PLACE_TEXT];
    struct programme lp;
    fill(nb, o->kernel, &lp);
    int stuck = minimise(&lp, 1);
    if (stuck || unmet(&lp) > 1e-9)
        return refuse(why, STATUS_NUMERICAL,
                      "no weights >= 0 are exact for quadratics: particle %zu at %s has %zu neighbours, "
                      "and %.2g of the second moments cannot be met; use a larger --h (a neighbour in each "
                      "sector of 45 degrees about it is enough) or less --jitter",
                      nb->i, problem_place(nb->dim, nb->x, place), nb->n, unmet(&lp));
    if (minimise(&lp, 2))
        return refuse(why, STATUS_NUMERICAL, "particle %zu at %s: its linear programme does not end", nb->i,
                      problem_place(nb->dim, nb->x, place));
    basis_weights(&lp, w[0]);
    return STATUS_OK;
}

static const struct scheme scheme = {.name = "positive", .sweeps = 1, .h = default_h, .weights = weights};

const struct method method_positive = {
    .name = "positive",
    .about = "weights >= 0, exact for quadratics, by linear programmes (Seibold 2008): no mode grows",
    .accepts = PARTICLES_OPTIONS PARTICLES_WALLS,
    .scheme = &scheme,
    .solve = particles_solve,
};
