/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arrays of the finite differences (ftcs.c) on the grid of ftcs_plan.c: initial data and source. */
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

ptrdiff_t ftcs_grid_points(const struct ftcs_grid *g) {
    return (ptrdiff_t)g->n[0] * g->n[1] * g->n[2];
}

ptrdiff_t ftcs_grid_at(const struct ftcs_grid *g, const int i[DIM_MAX]) {
    return g->corner + i[0] + i[1] * g->stride[1] + i[2] * g->stride[2];
}

void ftcs_grid_place(const struct ftcs_grid *g, const int i[DIM_MAX], double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = g->origin[a] + i[a] * g->d[a];
}

void ftcs_grid_next(const struct ftcs_grid *g, int i[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX && ++i[a] == g->n[a]; a++) i[a] = 0;
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
        for (int a = 1; a < p->dim; a++)
            g->layers[2 + a][i] = ftcs_layers_across(p, a, g->d[0], x) / (g->layers[0][i] * g->d[a] * g->d[a]);
    }
}

/* Initial data, source, and the range of a stable run: that of the data and the possible effect of source and fluxes,
 * widened by half of itself. */
static void fill(struct ftcs_grid *g, const struct problem *p, const struct options *o) {
    const ptrdiff_t points = ftcs_grid_points(g), size = (ptrdiff_t)g->size, nx = g->n[0];
    double source = 0;
    int i[DIM_MAX] = {0};
    for (int s = 0; s < 2 * p->dim; s++) ftcs_edge_make(g, p, o, (enum side)s);
    if (p->materials == 2) layers_make(g, p, o);
    g->T = reserve(g, size);
    if (g->with_fluxes)
        g->q = reserve(g, nx + 2 + (p->dim > 1 ? 3 * nx : 0) + (p->dim > 2 ? 3 * nx * g->n[1] : 0));
    else
        g->next = reserve(g, size);
    if (p->source) g->heating = reserve(g, points);
    for (int k = 0; k < 2 && p->source_rate; k++) g->warming[k] = reserve(g, points);
    g->lowest = INFINITY;
    g->highest = -INFINITY;
    for (ptrdiff_t at = 0; at < points; at++, ftcs_grid_next(g, i)) {
        double x[DIM_MAX];
        ftcs_grid_place(g, i, x);
        double T = ftcs_sample(p, x, g->d, o->sampling), *start = &g->T[ftcs_grid_at(g, i)];
        *start = T;
        g->lowest = fmin(g->lowest, T);
        g->highest = fmax(g->highest, T);
        if (!p->source) continue;
        double G = p->source(p, x), rate = p->source_rate ? p->source_rate(p, x) : 0, last = G + p->t_end * rate;
        source = fmax(source, fmax(fabs(G), fabs(last)));
        *start += g->start * G / ftcs_grid_rho_c(g, i[0]);
        if (options_is_matched(o)) G += ftcs_matched_source(g, p, x);
        g->heating[at] = G / ftcs_grid_rho_c(g, i[0]);
        if (p->source_rate) g->warming[0][at] = g->heating[at], g->warming[1][at] = rate / ftcs_grid_rho_c(g, i[0]);
    }
    g->data[0] = g->lowest, g->data[1] = g->highest;
    g->inflow = source * p->t_end / g->rho_c;
    ftcs_edge_data(g, p, 0);
}

void ftcs_grid_source(struct ftcs_grid *g, double t) {
    const ptrdiff_t n = ftcs_grid_points(g);
    for (ptrdiff_t k = 0; k < n; k++) g->heating[k] = g->warming[0][k] + t * g->warming[1][k];
}

double ftcs_grid_cell(const struct ftcs_grid *g, const int i[DIM_MAX]) {
    double cell = g->d[0] * g->d[1] * g->d[2];
    for (int a = 0; a < g->dim; a++) {
        if (i[a] == 0) cell *= g->end_cell[2 * a];
        if (i[a] == g->n[a] - 1) cell *= g->end_cell[2 * a + 1];
    }
    return cell;
}

double ftcs_grid_rho_c(const struct ftcs_grid *g, int i) {
    return g->layers[0] ? g->layers[0][i] : g->rho_c;
}

void ftcs_grid_keep_T(struct ftcs_grid *g) {
    g->held = g->size;
    for (int s = 0; s < SIDES; s++) free(g->edge[s].offset), g->edge[s].offset = NULL;
    for (int k = 0; k < 5; k++) free(g->layers[k]), g->layers[k] = NULL;
    double **spent[] = {&g->next, &g->q, &g->heating, &g->warming[0], &g->warming[1]};
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
