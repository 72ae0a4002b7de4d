/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The grid of the finite volumes: volumes and faces of its cells, initial data and source. */
#include "solver/differences/ftcs.h"

#include "solver/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double *reserve(struct ftcs_grid *g, ptrdiff_t count) {
    g->held += (size_t)count;
    return xcalloc((size_t)count, sizeof(double));
}

/* ---- Cells ---- */

ptrdiff_t ftcs_at(const struct ftcs_grid *g, const int i[DIM_MAX]) {
    return g->corner + i[0] + i[1] * g->stride[1] + i[2] * g->stride[2];
}

int ftcs_next(const struct ftcs_grid *g, int i[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) {
        if (++i[a] < g->n[a]) return 1;
        i[a] = 0;
    }
    return 0;
}

void ftcs_point(const struct ftcs_grid *g, const double u[DIM_MAX], double x[DIM_MAX]) {
    if (!g->round) {
        memcpy(x, u, DIM_MAX * sizeof *x);
        return;
    }
    const int ball = g->p->dim == 3;
    double from_axis = ball ? u[0] * sin(u[1]) : u[0];
    x[0] = from_axis * cos(u[2]), x[1] = from_axis * sin(u[2]), x[2] = ball ? u[0] * cos(u[1]) : 0;
}

void ftcs_place(const struct ftcs_grid *g, const int i[DIM_MAX], double x[DIM_MAX]) {
    double u[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) u[a] = g->first[a] + i[a] * g->d[a];
    ftcs_point(g, u, x);
}

/* m^dim */
double ftcs_volume(const struct ftcs_grid *g, const int i[DIM_MAX]) {
    if (g->round) return ftcs_round_volume(g, i);
    double volume = g->d[0] * g->d[1] * g->d[2];
    for (int a = 0; a < g->p->dim; a++) {
        if (i[a] == 0) volume *= g->end_cell[2 * a];
        if (i[a] == g->n[a] - 1) volume *= g->end_cell[2 * a + 1];
    }
    return volume;
}

/* J m^-3 K^-1, of the cells of one column */
static double rho_c(const struct ftcs_grid *g, int column) {
    const double x = g->first[0] + column * g->d[0];
    return g->p->materials == 2 ? ftcs_face_rho_c(g->p, g->d[0], x) : g->rho_c;
}

/* J m^(dim-3) */
double ftcs_heat(const struct ftcs_grid *g) {
    long double sum = 0;
    int i[DIM_MAX] = {0};
    do sum += ftcs_volume(g, i) * rho_c(g, i[0]) * g->T[ftcs_at(g, i)];
    while (ftcs_next(g, i));
    return (double)sum;
}

/* ---- Faces ---- */

/* W K^-1, of the face below cell i along the axis; of the last cell's upper face with i one further */
static double conductance(const struct ftcs_grid *g, int axis, const int i[DIM_MAX]) {
    const struct problem *p = g->p;
    if (g->round) return p->material[0].k[0] * ftcs_round_face(g, axis, i);
    const double x = g->first[0] + i[0] * g->d[0], area = g->d[0] * g->d[1] * g->d[2] / g->d[axis];
    double k = i[0] < g->n[0] ? ftcs_face_k(p, g->o->mean, axis, axis ? g->d[0] : -g->d[0], x)
                              : ftcs_face_k(p, g->o->mean, axis, g->d[0], x - g->d[0]);
    return k * area / g->d[axis];
}

/* Conductances and weights: of two materials by column, in a round body by ring and band, with k(T) by cell. */
static void faces_make(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    const int by_cell = p->k_law != K_CONSTANT, bands = g->round ? g->n[1] : 1;
    if (by_cell) {
        memcpy(g->along, g->stride, sizeof g->along);
        g->base = g->corner;
    } else
        g->along[0] = 1, g->along[1] = g->round ? g->n[0] + 1 : 0;
    const ptrdiff_t size = by_cell ? (ptrdiff_t)g->size : (ptrdiff_t)(g->n[0] + 1) * (bands + 1);
    g->weight = reserve(g, size);
    for (int a = 0; a < DIM_MAX; a++)
        if (a < p->dim || g->round) g->C[a] = reserve(g, size);
    int i[DIM_MAX] = {0};
    do {
        const ptrdiff_t at = g->base + i[0] + i[1] * g->along[1] + i[2] * g->along[2];
        if (i[2] && !g->along[2]) break;
        if (i[1] && !g->along[1]) continue;
        g->weight[at] = 1 / (ftcs_volume(g, i) * rho_c(g, i[0]));
        for (int a = 0; a < DIM_MAX && !by_cell; a++) {
            int upper[DIM_MAX] = {i[0] + (a == 0), i[1] + (a == 1), i[2] + (a == 2)};
            if (!g->C[a]) continue;
            g->C[a][at] = conductance(g, a, i);
            if (upper[a] == g->n[a] && g->along[a]) g->C[a][at + g->along[a]] = conductance(g, a, upper);
        }
    } while (ftcs_next(g, i));
}

/* ---- Initial data and source ---- */

static void arrays_make(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    const enum stepper_name stepper = g->o->stepper;
    const int kirchhoff = !p->k_frozen && g->o->mean != MEAN_HARMONIC && g->o->mean != MEAN_ARITHMETIC;
    const int states = stepper == STEPPER_RKL2 ? 3 : stepper == STEPPER_RK2 ? 2 : 1;
    const ptrdiff_t size = (ptrdiff_t)g->size, cells = (ptrdiff_t)g->n[0] * g->n[1] * g->n[2];
    g->T = reserve(g, size);
    for (int k = 0; k < states; k++) g->state[k] = reserve(g, size);
    if (p->k_law) g->law = reserve(g, size);
    if (g->round || p->materials == 2 || (p->k_law && !kirchhoff)) faces_make(g);
    if (g->round) ftcs_round_make(g);
    if (states == 3) g->row = reserve(g, g->n[0]);
    for (int s = g->round && p->radius[0] == 0 ? X_HI : X_LO; s < 2 * (g->round ? 1 : p->dim); s++)
        ftcs_wall_make(g, (enum side)s);
    if (problem_has_cross(p)) ftcs_cross_make(g);
    if (p->source || p->source_at) g->heating = reserve(g, cells);
    const int terms = p->source_at ? 3 : p->source_rate ? 2 : 0;
    for (int k = 0; k < terms; k++) g->warming[k] = reserve(g, cells);
}

/* In the matched run Euler's steps add A dx^2/kappa of diffusion to the source: its correction, W m^-3, is A D^2 G
 * (ftcs_plan.c). */
static double source_at(const struct ftcs_grid *g, const double x[DIM_MAX]) {
    const struct problem *p = g->p;
    double G = p->source(p, x), lo[DIM_MAX] = {x[0] - g->d[0], x[1]}, hi[DIM_MAX] = {x[0] + g->d[0], x[1]};
    if (!options_is_matched(g->o)) return G;
    return G + (g->reach == 2 ? 1. / 3 : 1. / 12) * (p->source(p, lo) - 2 * G + p->source(p, hi));
}

/* The range of a stable run is that of the data and the possible effect of source and fluxes, widened by half of
 * itself. */
static void set_bound(struct ftcs_grid *g) {
    g->middle = 0.5 * (g->data[0] + g->data[1]);
    g->bound = fmax(g->data[1] - g->data[0] + g->inflow, 1e-6 * fabs(g->middle));
}

void ftcs_fill(struct ftcs_grid *g) {
    const struct problem *p = g->p;
    double source = 0, x[DIM_MAX];
    int i[DIM_MAX] = {0};
    ptrdiff_t cell = 0;
    arrays_make(g);
    g->range[0] = INFINITY, g->range[1] = -INFINITY;
    do {
        ftcs_place(g, i, x);
        double *T = &g->T[ftcs_at(g, i)];
        *T = g->round ? p->initial(p, x) : ftcs_sample(p, x, g->d, g->o->sampling);
        g->range[0] = fmin(g->range[0], *T), g->range[1] = fmax(g->range[1], *T);
        *T = ftcs_face_state(p, *T);
        source = fmax(source, fmax(fabs(problem_source(p, x, 0)), fabs(problem_source(p, x, p->t_end))));
        if (p->source) {
            *T += g->start * p->source(p, x) / rho_c(g, i[0]);
            g->heating[cell] = source_at(g, x) / rho_c(g, i[0]);
        }
        if (p->source_rate)
            g->warming[0][cell] = g->heating[cell], g->warming[1][cell] = p->source_rate(p, x) / rho_c(g, i[0]);
        if (p->source_at) g->warming[0][cell] = p->source_at(p, x, 0) / rho_c(g, i[0]);
        cell++;
    } while (ftcs_next(g, i));
    for (int k = 0; k < 2; k++) g->data[k] = ftcs_face_state(p, g->range[k]);
    g->inflow = source * p->t_end / g->rho_c;
    if (p->k_frozen) ftcs_face_refresh(g, g->T);
    ftcs_wall_data(g, 0);
    set_bound(g);
}

void ftcs_set_time(struct ftcs_grid *g, double t) {
    const ptrdiff_t cells = (ptrdiff_t)g->n[0] * g->n[1] * g->n[2];
    const double since = t - g->since, *const *w = (const double *const *)g->warming;
    if (g->p->wall_rate || g->p->source_at) ftcs_wall_data(g, t);
    for (ptrdiff_t k = 0; k < cells && w[0]; k++)
        g->heating[k] = w[0][k] + since * (w[1][k] + (w[2] ? since * w[2][k] : 0));
    set_bound(g);
}

void ftcs_set_step(struct ftcs_grid *g, double t) {
    const struct problem *p = g->p;
    const double last = t - g->since, dt = g->dt;
    double x[DIM_MAX], *const *w = g->warming;
    int i[DIM_MAX] = {0}, more = p->source_at != NULL;
    for (ptrdiff_t k = 0; more; more = ftcs_next(g, i), k++) {
        ftcs_place(g, i, x);
        const double before = w[0][k], now = before + last * (w[1][k] + last * w[2][k]);
        const double end = p->source_at(p, x, t + dt) / rho_c(g, i[0]), slope = (end - now) / dt;
        w[0][k] = now;
        w[2][k] = last > 0 ? (slope - (now - before) / last) / (dt + last) : 0;
        w[1][k] = slope - dt * w[2][k];
        g->inflow = fmax(g->inflow, fmax(fabs(now), fabs(end)) * p->t_end);
    }
    if (p->source_at) g->since = t;
}

void ftcs_free(struct ftcs_grid *g, int keep_T) {
    ftcs_round_free(g);
    g->held = g->size;
    for (int s = 0; s < SIDES; s++) free(g->side[s].sign), g->side[s].sign = g->side[s].offset = NULL;
    double **spent[] = {&g->C[0],     &g->C[1],       &g->C[2],       &g->weight,     &g->law,
                        &g->state[0], &g->state[1],   &g->state[2],   &g->before,     &g->row,
                        &g->heating,  &g->warming[0], &g->warming[1], &g->warming[2], &g->cross};
    for (size_t k = 0; k < sizeof spent / sizeof *spent; k++) free(*spent[k]), *spent[k] = NULL;
    for (int a = 0; a < DIM_MAX; a++) {
        free(g->flux[a]), g->flux[a] = NULL;
        for (int b = 0; b < DIM_MAX; b++) free(g->K[a][b]), g->K[a][b] = NULL;
    }
    if (!keep_T) free(g->T);
}
