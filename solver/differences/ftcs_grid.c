/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arrays of the finite differences (ftcs.c) on the grid of ftcs_plan.c: initial data, source and ghosts,
 *
 *   Dirichlet  T_ghost = 2 T_wall - T_mirror + d^2 T_nn, or T_wall (`fixed`, Pamplona 2019; first order)
 *   Neumann    T_ghost = T_mirror + 2 d (k dT/dn) / k + d^3/3 T_nnn
 *   Robin      T_ghost = T_mirror + 2 d b (T_a - T_mirror) / (k + b d): k dT/dn = b (T_a - T) midway (second order)
 *
 * at the distance d from the wall.  The boundary data are steady, so on the wall k_n T_nn + k_t T_tt + G = 0, with
 * the normal derivative k_n T_nnn + k_t T_ntt + G_n = 0.  T_tt, T_ntt and G_n follow from the boundary data and the
 * source by central differences over d, with errors of d^4 and d^5.  Each ghost is a multiple of one unknown plus a
 * constant, so the steps need no cases for the kind of a side. */
#include "solver/differences/ftcs_grid.h"

#include "solver/differences/ftcs_layers.h"
#include "solver/differences/ftcs_matched.h"
#include "solver/differences/ftcs_plan.h"
#include "solver/method.h"
#include "solver/problem.h"

#include <math.h>
#include <stdlib.h>

static double *reserve(struct ftcs_grid *g, ptrdiff_t count) {
    g->held += (size_t)count;
    return xcalloc((size_t)count, sizeof(double));
}

/* Correction of a ghost at the distance d for varying boundary data and the source, times k_n, K W m^-1 K^-1. k and
 * k_along are the conductivities across and along the side. */
static double beyond(const struct problem *p, enum side s, const double foot[2], double d, double k, double k_along) {
    int a = (int)s / 2, b = 1 - a;
    double in[2] = {foot[0], foot[1]}, out[2] = {foot[0], foot[1]}, lo[2] = {foot[0], foot[1]},
           hi[2] = {foot[0], foot[1]};
    double bend = 0, outwards = s % 2 ? d : -d;
    in[a] -= outwards, out[a] += outwards, lo[b] -= d, hi[b] += d;
    if (p->dim == 2) bend = k_along * (p->wall(p, s, lo, 0) - 2 * p->wall(p, s, foot, 0) + p->wall(p, s, hi, 0));
    if (p->side[s] == DIRICHLET) return -bend - (p->source ? d * d * p->source(p, foot) : 0);
    return -bend / k * d / 3 - (p->source ? d * d / 6 * (p->source(p, out) - p->source(p, in)) : 0);
}

/* Conductivity, W m^-1 K^-1, along the axis in the cell at this place of the side. */
static double conducts(const struct ftcs_grid *g, const struct problem *p, enum side s, int place, int axis) {
    if (s == X_LO || s == X_HI) return p->material[s == X_HI ? p->materials - 1 : 0].k[axis];
    double x = g->origin[0] + place * g->d[0];
    return axis == 1 ? ftcs_layers_across(p, g->d[0], x) : p->material[p->materials == 2 && x >= p->interface].k[0];
}

/* Ghost m mirrors unknown m + shift.  The wall is half a spacing outside the first unknown (shift 0), on it (1), or
 * on ghost 0 (-1). */
static void edge_make(struct ftcs_grid *g, const struct problem *p, const struct options *o, enum side s) {
    int a = (int)s / 2, b = 1 - a, length = g->n[b], given = p->side[s] == DIRICHLET;
    int shift = o->layout == LAYOUT_NODE ? (given ? -1 : 1) : 0;
    struct ftcs_edge *e = &g->edge[s];
    e->offset = reserve(g, FTCS_LAYERS * length);
    for (int m = 0; m < FTCS_LAYERS && p->side[s] == PERIODIC; m++) {
        e->mirror[m] = g->n[a] - 1 - m; /* at the opposite end; offsets stay 0 */
        e->sign[m] = 1;
    }
    for (int m = 0; m < FTCS_LAYERS && p->side[s] != PERIODIC; m++) {
        int held = given && (o->walls == WALLS_FIXED || m + shift < 0);
        double apart = (2 * m + 1 + shift) * g->d[a], x[2];
        e->mirror[m] = m + shift < 0 ? 0 : m + shift;
        e->sign[m] = held ? 0 : given ? -1 : 1;
        double taken = 0;
        if (p->side[s] == ROBIN) {
            double k = conducts(g, p, s, 0, a);
            taken = 2 / (1 + k / (p->robin[s] * apart / 2)); /* 0 to 2 for any b */
            e->sign[m] = 1 - taken;
        }
        for (int i = 0; i < length; i++) {
            x[a] = s % 2 ? p->hi[a] : p->lo[a];
            x[b] = g->origin[b] + i * g->d[b];
            double value = p->wall(p, s, x, 0), k = conducts(g, p, s, i, a);
            if (p->side[s] == ROBIN) {
                e->offset[m * length + i] = taken * value;
                continue;
            }
            e->offset[m * length + i] = held ? value
                                             : (given ? 2 * value : value / k * apart) +
                                                   beyond(p, s, x, apart / 2, k, conducts(g, p, s, i, b)) / k;
        }
    }
}

/* Coefficients for two materials. */
static void layers_make(struct ftcs_grid *g, const struct problem *p, const struct options *o) {
    for (int k = 0; k < 2 + p->dim; k++) g->layers[k] = reserve(g, g->n[0]);
    for (int i = 0; i < g->n[0]; i++) {
        double x = g->origin[0] + i * g->d[0];
        g->layers[0][i] = ftcs_layers_rho_c(p, g->d[0], x);
        for (int hi = 0; hi < 2; hi++)
            g->layers[1 + hi][i] = ftcs_layers_conductivity(p, o->mean, x, hi ? g->d[0] : -g->d[0]) /
                                   (g->layers[0][i] * g->d[0] * g->d[0]);
        if (p->dim == 2) g->layers[3][i] = ftcs_layers_across(p, g->d[0], x) / (g->layers[0][i] * g->d[1] * g->d[1]);
    }
}

/* Range of a stable run: that of the data and the possible effect of source and fluxes, widened by half of itself. */
static void bound(struct ftcs_grid *g, const struct problem *p, double source) {
    double lowest = g->lowest, highest = g->highest, more = source * p->t_end / g->rho_c;
    for (int s = 0; s < 2 * p->dim; s++) {
        double extent = p->hi[s / 2] - p->lo[s / 2];
        for (int i = 0; i < g->n[1 - s / 2]; i++) {
            double foot[2] = {g->origin[0] + i * g->d[0], g->origin[1] + i * g->d[1]};
            foot[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
            double value = p->wall(p, (enum side)s, foot, 0), flux = p->side[s] == NEUMANN ? fabs(value) : 0;
            double k = conducts(g, p, (enum side)s, i, s / 2);
            more = fmax(more, flux * (extent / k + p->t_end / g->rho_c / extent));
            if (p->side[s] != NEUMANN) lowest = fmin(lowest, value), highest = fmax(highest, value);
        }
    }
    g->middle = 0.5 * (lowest + highest);
    g->reach = fmax(highest - lowest + more, 1e-6 * fabs(g->middle));
}

static void fill(struct ftcs_grid *g, const struct problem *p, const struct options *o) {
    int nx = g->n[0], ny = g->n[1];
    ptrdiff_t size = (ptrdiff_t)g->size;
    double source = 0;
    for (int s = 0; s < 2 * p->dim; s++) edge_make(g, p, o, (enum side)s);
    if (p->materials == 2) layers_make(g, p, o);
    g->T = reserve(g, size);
    if (g->with_fluxes)
        g->q = reserve(g, nx + 2 + (p->dim == 2 ? 3 * nx : 0));
    else
        g->next = reserve(g, size);
    if (p->source) g->heating = reserve(g, (ptrdiff_t)nx * ny);
    for (int k = 0; k < 2 && p->source_rate; k++) g->warming[k] = reserve(g, (ptrdiff_t)nx * ny);
    g->lowest = INFINITY;
    g->highest = -INFINITY;
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            double x[2] = {g->origin[0] + i * g->d[0], g->origin[1] + j * g->d[1]};
            double T = ftcs_sample(p, x, g->d, o->sampling);
            g->T[g->corner + j * g->stride + i] = T;
            g->lowest = fmin(g->lowest, T);
            g->highest = fmax(g->highest, T);
            if (!p->source) continue;
            double G = p->source(p, x), rate = p->source_rate ? p->source_rate(p, x) : 0, last = G + p->t_end * rate;
            source = fmax(source, fmax(fabs(G), fabs(last)));
            g->T[g->corner + j * g->stride + i] += g->start * G / ftcs_grid_rho_c(g, i);
            if (options_is_matched(o)) G += ftcs_matched_source(g, p, x);
            ptrdiff_t at = (ptrdiff_t)j * nx + i;
            g->heating[at] = G / ftcs_grid_rho_c(g, i);
            if (p->source_rate) g->warming[0][at] = g->heating[at], g->warming[1][at] = rate / ftcs_grid_rho_c(g, i);
        }
    bound(g, p, source);
}

void ftcs_grid_source(struct ftcs_grid *g, double t) {
    ptrdiff_t n = (ptrdiff_t)g->n[0] * g->n[1];
    for (ptrdiff_t k = 0; k < n; k++) g->heating[k] = g->warming[0][k] + t * g->warming[1][k];
}

void ftcs_grid_walls(const struct ftcs_grid *g) {
    const struct ftcs_edge *w = &g->edge[X_LO], *e = &g->edge[X_HI], *s = &g->edge[Y_LO], *n = &g->edge[Y_HI];
    int nx = g->n[0], ny = g->n[1];
    double *T = g->T + g->corner;
    for (int j = 0; j < ny; j++)
        for (int m = 0; m < FTCS_LAYERS; m++) {
            double *row = T + j * g->stride;
            row[-1 - m] = w->sign[m] * row[w->mirror[m]] + w->offset[m * ny + j];
            row[nx + m] = e->sign[m] * row[nx - 1 - e->mirror[m]] + e->offset[m * ny + j];
        }
    for (int m = 0; m < (g->dim == 2 ? FTCS_LAYERS : 0); m++) {
        const double *lo = T + s->mirror[m] * g->stride, *hi = T + (ny - 1 - n->mirror[m]) * g->stride;
        double *below = T - (1 + m) * g->stride, *above = T + (ny + m) * g->stride;
        for (int i = 0; i < nx; i++) below[i] = s->sign[m] * lo[i] + s->offset[m * nx + i];
        for (int i = 0; i < nx; i++) above[i] = n->sign[m] * hi[i] + n->offset[m * nx + i];
    }
}

double ftcs_grid_cell(const struct ftcs_grid *g, int i, int j) {
    return g->d[0] * g->d[1] * (i == 0 ? g->end_cell[X_LO] : 1) * (i == g->n[0] - 1 ? g->end_cell[X_HI] : 1) *
           (j == 0 ? g->end_cell[Y_LO] : 1) * (j == g->n[1] - 1 ? g->end_cell[Y_HI] : 1);
}

double ftcs_grid_rho_c(const struct ftcs_grid *g, int i) {
    return g->layers[0] ? g->layers[0][i] : g->rho_c;
}

void ftcs_grid_keep_T(struct ftcs_grid *g) {
    g->held = g->size;
    for (int s = 0; s < 4; s++) free(g->edge[s].offset), g->edge[s].offset = NULL;
    double **spent[] = {&g->next,      &g->q,         &g->heating,   &g->warming[0], &g->warming[1],
                        &g->layers[0], &g->layers[1], &g->layers[2], &g->layers[3]};
    for (size_t k = 0; k < sizeof spent / sizeof *spent; k++) free(*spent[k]), *spent[k] = NULL;
}

void ftcs_grid_free(struct ftcs_grid *g) {
    ftcs_grid_keep_T(g);
    free(g->T);
}

int ftcs_grid_make(struct ftcs_grid *g, const char *method, int with_fluxes, const struct problem *p,
                   const struct options *o, struct failure *why) {
    if (ftcs_plan(g, method, with_fluxes, p, o, why)) return why->status;
    fill(g, p, o);
    return STATUS_OK;
}
