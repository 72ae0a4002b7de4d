/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences, forward in time and central in space: an independent check of every particle method.  By
 * design the two share not one line of code.
 *
 *   direct       dT_i/dt = kappa_x (T_{i+1} - 2 T_i + T_{i-1}) / dx^2 + the same along y + G / rho_c
 *                (Song 2018, eq. 5; Pamplona 2019, eq. 16)
 *   with fluxes  q_i = -kappa_x (T_{i+1} - T_{i-1}) / (2 dx),  dT_i/dt = -(q_{i+1} - q_{i-1}) / (2 dx) + ...
 *                (Song 2018, eq. 6 and Fig. 1d); the stencil (T_{i+2} - 2 T_i + T_{i-2}) / (4 dx^2), which is blind
 * to the checkerboard mode
 *
 * The symbols along one axis are -(4/dx^2) sin^2(xi dx/2) and -(1/dx^2) sin^2(xi dx), both -xi^2 + A dx^2
 * xi^4 + O(dx^4), with A = 1/12 and 1/3.  Euler's error, -(dt/2) kappa^2 xi^4, cancels A at kappa dt/dx^2 = 2A: the
 * matched run on a rod, of fourth order (with fluxes for smooth data only).  In the plane this would need an
 * isotropic stencil.
 *
 * Restrictions: uniform grid, dx = dy.  The direct form also treats two materials (ftcs_layers.h) and round bodies
 * (ftcs_polar.h). */
#include "solver/differences/ftcs_grid.h"
#include "solver/differences/ftcs_loops.h"
#include "solver/differences/ftcs_plan.h"
#include "solver/method.h"
#include "solver/work.h"
#include "solver/problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CHECK_EVERY = 32 };

/* ---- One step ---- */

static void step_direct(struct ftcs_grid *g) {
    double Fx = g->kappa[0] * g->dt / (g->d[0] * g->d[0]), Fy = g->kappa[1] * g->dt / (g->d[1] * g->d[1]);
    for (ptrdiff_t j = 0; j < g->n[1]; j++) {
        const double *T = g->T + g->corner + j * g->stride;
        double *next = g->next + g->corner + j * g->stride;
        if (g->layers[3])
            g->loops->layers_row(g->n[0], g->dt, g->layers[1], g->layers[2], g->layers[3], T, T - g->stride,
                                 T + g->stride, next);
        else if (g->layers[0])
            g->loops->layers(g->n[0], g->dt, g->layers[1], g->layers[2], T, next);
        else if (g->dim == 1)
            g->loops->rod(g->n[0], Fx, T, next);
        else
            g->loops->row(g->n[0], Fx, Fy, T, T - g->stride, T + g->stride, next);
        if (g->heating) g->loops->accumulate(g->n[0], g->dt, g->heating + j * g->n[0], next);
    }
    double *old = g->T;
    g->T = g->next;
    g->next = old;
}

/* In place: q_y of rows j - 1, j and j + 1 is stored, that of row j + 1 computed before T of row j changes. */
static void step_fluxes(struct ftcs_grid *g) {
    const struct ftcs_loops *loops = g->loops;
    int nx = g->n[0];
    double *qx = g->q, *qy = qx + nx + 2;
    double half[2] = {0.5 / g->d[0], 0.5 / g->d[1]};
    for (ptrdiff_t j = g->dim == 2 ? -2 : 0; j < g->n[1]; j++) {
        double *T = g->T + g->corner + j * g->stride;
        if (g->dim == 2)
            loops->difference(nx, -g->kappa[1] * half[1], T + 2 * g->stride, T, 0, qy + (j + 3) % 3 * nx);
        if (j < 0) continue;
        loops->difference(nx + 2, -g->kappa[0] * half[0], T, T - 2, 0, qx);
        loops->difference(nx, -g->dt * half[0], qx + 2, qx, 1, T);
        if (g->dim == 2) loops->difference(nx, -g->dt * half[1], qy + (j + 3) % 3 * nx, qy + (j + 1) % 3 * nx, 1, T);
        if (g->heating) loops->accumulate(nx, g->dt, g->heating + j * nx, T);
    }
}

/* dt sum of kappa/dx^2; stable up to 1/2, with fluxes up to 2. */
static double fourier_sum(const struct ftcs_grid *g) {
    double rate = g->kappa[0] / (g->d[0] * g->d[0]) + g->kappa[1] / (g->d[1] * g->d[1]);
    for (int i = 0; g->layers[0] && i < g->n[0]; i++)
        rate = fmax(rate, (g->layers[1][i] + g->layers[2][i]) / 2 + (g->layers[3] ? g->layers[3][i] : 0));
    return g->dt * rate;
}

/* Refuses at the first point outside the reach; a NaN is outside. */
static int check_stable(const struct ftcs_grid *g, long long step, struct failure *why) {
    for (int j = 0; j < g->n[1]; j++) {
        const double *row = g->T + g->corner + j * g->stride;
        if (g->loops->outside(g->n[0], g->middle, g->reach, row) == 0) continue;
        int i = 0;
        while (fabs(row[i] - g->middle) <= g->reach) i++;
        char y[40] = "";
        if (g->dim == 2) snprintf(y, sizeof y, ", y = %g m", g->origin[1] + j * g->d[1]);
        return refuse(why, STATUS_UNSTABLE,
                      "%s: unstable at step %lld of %lld, t = %g s: T = %g K at x = %g m%s; "
                      "sum of kappa dt/dx^2 is %g, stable up to %g",
                      g->method, step, g->steps, g->start + (double)step * g->dt, row[i], g->origin[0] + i * g->d[0],
                      y, fourier_sum(g), g->with_fluxes ? 2 : 0.5);
    }
    return STATUS_OK;
}

/* ---- The methods ---- */

extern const struct method method_ftcs_flux;

static double heat(const struct ftcs_grid *g) {
    long double sum = 0;
    for (int j = 0; j < g->n[1]; j++)
        for (int i = 0; i < g->n[0]; i++)
            sum += ftcs_grid_cell(g, i, j) * ftcs_grid_rho_c(g, i) * g->T[g->corner + j * g->stride + i];
    return (double)sum;
}

static int has_whole_cells(const struct ftcs_grid *g) {
    return g->end_cell[X_LO] * g->end_cell[X_HI] * g->end_cell[Y_LO] * g->end_cell[Y_HI] == 1;
}

/* Frees everything except T before the field is allocated, which keeps peak memory low. */
static void hand_over(struct ftcs_grid *g, struct field *f) {
    ptrdiff_t nx = g->n[0], n = nx * g->n[1];
    size_t held = g->held * sizeof *g->T;
    ftcs_grid_keep_T(g);
    field_alloc(f, g->dim, (size_t)n);
    f->cost.bytes = held;
    if (!has_whole_cells(g)) f->weight = xcalloc((size_t)n, sizeof *f->weight);
    for (ptrdiff_t k = 0; k < n; k++) {
        int i = (int)(k % nx), j = (int)(k / nx);
        f->x[k] = g->origin[0] + i * g->d[0];
        if (f->y) f->y[k] = g->origin[1] + j * g->d[1];
        f->T[k] = g->T[g->corner + j * g->stride + i];
        if (f->weight) f->weight[k] = ftcs_grid_cell(g, i, j);
    }
}

static int run(struct ftcs_grid *g, struct failure *why) {
    const double mean = g->dt;
    for (long long step = 1; step <= g->steps; step++) {
        g->dt = mean * (step % 2 ? 1 + g->alternation : 1 - g->alternation);
        ftcs_grid_walls(g);
        if (g->warming[0]) ftcs_grid_source(g, (double)(step - 1) * mean);
        if (g->with_fluxes)
            step_fluxes(g);
        else
            step_direct(g);
        if (step % CHECK_EVERY == 0 || step == g->steps) {
            g->dt = mean;
            int status = check_stable(g, step, why);
            if (status) return status;
        }
    }
    return STATUS_OK;
}

/* Counts points, steps and their cost.  Fluxes need two neighbours for q and two for its slope; averages need four
 * quadrature nodes per piece of the spline along each axis. */
static void count(const struct ftcs_grid *g, const struct options *o, struct field *f) {
    const double n = (double)g->n[0] * g->n[1];
    const int pieces = o->sampling == SAMPLING_SPLINE ? 4 : 1, nodes = o->sampling == SAMPLING_POINT ? 1 : 4 * pieces;
    f->dim = g->dim, f->n = (size_t)n;
    f->dt = g->dt, f->steps = g->steps, f->stages = 1;
    f->cost.updates = g->steps * g->n[0] * g->n[1];
    f->cost.interactions = f->cost.updates * (g->with_fluxes ? 4 : 2) * g->dim;
    f->cost.work = WORK_SCALAR * n * (WORK_PLACE + WORK_SAMPLE * pow(nodes, g->dim));
    f->cost.work += (double)f->cost.interactions + 2 * (double)f->cost.updates;
    f->cost.work += WORK_SCALAR * WORK_GHOST * ((double)g->size - n) * (double)g->steps;
}

static int solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why) {
    if (p->shape && m != &method_ftcs_flux) return ftcs_polar_solve(m->name, p, o, f, why);
    struct ftcs_grid g;
    double called = field_clock();
    int status = ftcs_grid_make(&g, m->name, m == &method_ftcs_flux, p, o, why);
    if (status) return status;
    double before = heat(&g), stepping = field_clock();
    status = run(&g, why);
    double stepped = field_clock();
    if (status == STATUS_OK) {
        double after = heat(&g);
        hand_over(&g, f);
        count(&g, o, f);
        f->shape[0] = g.n[0];
        f->shape[1] = g.n[1];
        f->shape[2] = 1;
        f->spacing[0] = g.d[0];
        f->spacing[1] = p->dim == 2 ? g.d[1] : 0;
        f->time = p->t_end;
        f->heat[0] = before;
        f->heat[1] = after;
        f->range[0] = g.lowest;
        f->range[1] = g.highest;
        f->cost.step_seconds = stepped - stepping;
        f->cost.seconds = field_clock() - called;
    }
    ftcs_grid_free(&g);
    return status;
}

const struct method method_ftcs = {
    .name = "ftcs",
    .about = "finite differences, (T[i+1] - 2 T[i] + T[i-1])/dx^2, Euler: Song eq. 5, Pamplona eq. 16",
    .accepts = "stepper layout sampling walls mean",
    .solve = solve,
};

const struct method method_ftcs_flux = {
    .name = "ftcs_flux",
    .about = "finite differences through the heat fluxes, (q[i+1] - q[i-1])/(2 dx), Euler: Song eq. 6",
    .accepts = "stepper layout sampling walls",
    .solve = solve,
};
