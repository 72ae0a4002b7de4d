/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite differences, forward in time and central in space: an independent check of every particle method.  By
 * design the two share not one line of code.
 *
 *   direct       dT_i/dt = kappa_x (T_{i+1} - 2 T_i + T_{i-1}) / dx^2 + the same along y and z + G / rho_c
 *                (Song 2018, eq. 5; Pamplona 2019, eq. 16)
 *   with fluxes  q_i = -kappa_x (T_{i+1} - T_{i-1}) / (2 dx),  dT_i/dt = -(q_{i+1} - q_{i-1}) / (2 dx) + ...
 *                (Song 2018, eq. 6 and Fig. 1d); the stencil (T_{i+2} - 2 T_i + T_{i-2}) / (4 dx^2), which is blind
 * to the checkerboard mode
 *
 * The symbols along one axis are -(4/dx^2) sin^2(xi dx/2) and -(1/dx^2) sin^2(xi dx), both -xi^2 + A dx^2
 * xi^4 + O(dx^4), with A = 1/12 and 1/3.  Euler's error, -(dt/2) kappa^2 xi^4, cancels A at kappa dt/dx^2 = 2A: the
 * matched run on a rod, of fourth order (with fluxes for smooth data only).  In the plane and in space this would
 * need an isotropic stencil.
 *
 * Restrictions: uniform grid, dx = dy = dz.  The direct form also treats two materials (ftcs_layers.h) and round
 * bodies (ftcs_polar.h). */
#include "solver/differences/ftcs_grid.h"
#include "solver/differences/ftcs_loops.h"
#include "solver/differences/ftcs_plan.h"
#include "solver/method.h"
#include "solver/work.h"
#include "solver/problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHECK_EVERY = 32 };

/* ---- One step ---- */

/* The rows of a plane or a box, and of two materials. */
static void step_rows(struct ftcs_grid *g, const double F[DIM_MAX]) {
    const struct ftcs_loops *loops = g->loops;
    const int nx = g->n[0];
    const ptrdiff_t up = g->stride[1], over = g->stride[2];
    const double *heating = g->heating;
    for (ptrdiff_t k = 0; k < g->n[2]; k++) {
        const double *T = g->T + g->corner + k * over;
        double *next = g->next + g->corner + k * over;
        for (int j = 0; j < g->n[1]; j++, T += up, next += up) {
            if (g->layers[3])
                loops->layers_row(nx, g->dt, g->layers[1], g->layers[2], g->layers[3], T, T - up, T + up, next);
            else if (g->layers[0])
                loops->layers(nx, g->dt, g->layers[1], g->layers[2], T, next);
            else if (g->dim == 2)
                loops->row(nx, F[0], F[1], T, T - up, T + up, next);
            else
                loops->box(nx, F, T, up, over, next);
            if (g->layers[4]) loops->lateral(nx, g->dt, g->layers[4], T, over, next);
            if (heating) loops->accumulate(nx, g->dt, heating, next), heating += nx;
        }
    }
}

static void step_direct(struct ftcs_grid *g) {
    double F[DIM_MAX];
    for (int a = 0; a < g->dim; a++) F[a] = g->kappa[a] * g->dt / (g->d[a] * g->d[a]);
    if (g->dim == 1 && !g->layers[0]) {
        g->loops->rod(g->n[0], F[0], g->T + g->corner, g->next + g->corner);
        if (g->heating) g->loops->accumulate(g->n[0], g->dt, g->heating, g->next + g->corner);
    } else
        step_rows(g, F);
    double *old = g->T;
    g->T = g->next;
    g->next = old;
}

/* One plane of step_fluxes, in place: q_y of rows j - 1, j and j + 1 is stored, that of row j + 1 computed before T
 * of row j changes.  `qz` has q_z of the planes below and above, in this order. */
static void step_plane(struct ftcs_grid *g, ptrdiff_t k, const double *const qz[2]) {
    const struct ftcs_loops *loops = g->loops;
    const int nx = g->n[0], flat = g->dim > 1;
    const ptrdiff_t up = g->stride[1];
    double *qx = g->q, *qy = qx + nx + 2, half[DIM_MAX];
    for (int a = 0; a < DIM_MAX; a++) half[a] = 0.5 / g->d[a];
    for (ptrdiff_t j = flat ? -2 : 0; j < g->n[1]; j++) {
        double *T = g->T + g->corner + j * up + k * g->stride[2];
        if (flat) loops->difference(nx, -g->kappa[1] * half[1], T + 2 * up, T, 0, qy + (j + 3) % 3 * nx);
        if (j < 0) continue;
        loops->difference(nx + 2, -g->kappa[0] * half[0], T, T - 2, 0, qx);
        loops->difference(nx, -g->dt * half[0], qx + 2, qx, 1, T);
        if (flat) loops->difference(nx, -g->dt * half[1], qy + (j + 3) % 3 * nx, qy + (j + 1) % 3 * nx, 1, T);
        if (qz[0]) loops->difference(nx, -g->dt * half[2], qz[1] + j * nx, qz[0] + j * nx, 1, T);
        if (g->heating) loops->accumulate(nx, g->dt, g->heating + (k * g->n[1] + j) * nx, T);
    }
}

/* As step_plane, with planes for rows. */
static void step_fluxes(struct ftcs_grid *g) {
    const ptrdiff_t nx = g->n[0], ny = g->n[1], plane = nx * ny, over = g->stride[2];
    const double *qz[2] = {NULL, NULL};
    for (ptrdiff_t k = g->dim == 3 ? -2 : 0; k < g->n[2]; k++) {
        if (g->dim == 3) {
            double *q = g->q + nx + 2 + 3 * nx, *ahead = q + (k + 3) % 3 * plane;
            const double *T = g->T + g->corner + k * over;
            for (ptrdiff_t j = 0; j < ny; j++, T += g->stride[1])
                g->loops->difference(g->n[0], -g->kappa[2] * (0.5 / g->d[2]), T + 2 * over, T, 0, ahead + j * nx);
            qz[0] = q + (k + 4) % 3 * plane, qz[1] = ahead;
        }
        if (k >= 0) step_plane(g, k, qz);
    }
}

/* dt sum of kappa/dx^2; stable up to 1/2, with fluxes up to 2. */
static double fourier_sum(const struct ftcs_grid *g) {
    double rate = 0;
    for (int a = 0; a < DIM_MAX; a++) rate += g->kappa[a] / (g->d[a] * g->d[a]);
    for (int i = 0; g->layers[0] && i < g->n[0]; i++) {
        double here = (g->layers[1][i] + g->layers[2][i]) / 2;
        for (int a = 1; a < g->dim; a++) here += g->layers[2 + a][i];
        rate = fmax(rate, here);
    }
    return g->dt * rate;
}

/* Refuses at the first point outside the reach; a NaN is outside. */
static int check_stable(const struct ftcs_grid *g, long long step, struct failure *why) {
    int i[DIM_MAX] = {0};
    for (i[2] = 0; i[2] < g->n[2]; i[2]++)
        for (i[1] = 0; i[1] < g->n[1]; i[1]++) {
            const double *row = g->T + ftcs_grid_at(g, i);
            if (g->loops->outside(g->n[0], g->middle, g->reach, row) == 0) continue;
            double x[DIM_MAX];
            char place[120] = "";
            while (fabs(row[i[0]] - g->middle) <= g->reach) i[0]++;
            ftcs_grid_place(g, i, x);
            for (int a = 0; a < g->dim; a++) {
                size_t used = strlen(place);
                snprintf(place + used, sizeof place - used, "%s%c = %g m", a ? ", " : "", 'x' + a, x[a]);
            }
            return refuse(why, STATUS_UNSTABLE,
                          "%s: unstable at step %lld of %lld, t = %g s: T = %g K at %s; "
                          "sum of kappa dt/dx^2 is %g, stable up to %g",
                          g->method, step, g->steps, g->start + (double)step * g->dt, row[i[0]], place,
                          fourier_sum(g), g->with_fluxes ? 2 : 0.5);
        }
    return STATUS_OK;
}

/* ---- The methods ---- */

extern const struct method method_ftcs_flux;

static double heat(const struct ftcs_grid *g) {
    const ptrdiff_t n = ftcs_grid_points(g);
    int i[DIM_MAX] = {0};
    long double sum = 0;
    for (ptrdiff_t k = 0; k < n; k++, ftcs_grid_next(g, i))
        sum += ftcs_grid_cell(g, i) * ftcs_grid_rho_c(g, i[0]) * g->T[ftcs_grid_at(g, i)];
    return (double)sum;
}

static int has_whole_cells(const struct ftcs_grid *g) {
    double share = 1;
    for (int s = 0; s < SIDES; s++) share *= g->end_cell[s];
    return share == 1;
}

/* T changes hands and closes its gaps, from the first unknown to the last. */
static void hand_over(struct ftcs_grid *g, struct field *f) {
    const ptrdiff_t n = ftcs_grid_points(g);
    int i[DIM_MAX] = {0};
    size_t held = g->held * sizeof *g->T;
    ftcs_grid_keep_T(g);
    field_alloc_lattice(f, g->dim, g->n, g->T);
    g->T = NULL;
    f->cost.bytes = held;
    if (!has_whole_cells(g)) f->weight = xcalloc((size_t)n, sizeof *f->weight);
    for (ptrdiff_t k = 0; k < n; k++, ftcs_grid_next(g, i)) {
        double x[DIM_MAX];
        ftcs_grid_place(g, i, x);
        for (int a = 0; a < g->dim; a++) f->x[a][i[a]] = x[a];
        f->T[k] = f->T[ftcs_grid_at(g, i)];
        if (f->weight) f->weight[k] = ftcs_grid_cell(g, i);
    }
    f->T = xcheck(realloc(f->T, f->n * sizeof *f->T), f->n, sizeof *f->T);
}

static int run(struct ftcs_grid *g, const struct problem *p, struct failure *why) {
    const double mean = g->dt;
    for (long long step = 1; step <= g->steps; step++) {
        g->dt = mean * (step % 2 ? 1 + g->alternation : 1 - g->alternation);
        if (p->wall_rate) ftcs_edge_data(g, p, (double)(step - 1) * mean);
        ftcs_edge_walls(g);
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
    const double n = (double)ftcs_grid_points(g);
    const int pieces = o->sampling == SAMPLING_SPLINE ? 4 : 1, nodes = o->sampling == SAMPLING_POINT ? 1 : 4 * pieces;
    f->dim = g->dim, f->n = (size_t)n;
    f->dt = g->dt, f->steps = g->steps, f->stages = 1;
    f->cost.updates = g->steps * ftcs_grid_points(g);
    f->cost.interactions = f->cost.updates * (g->with_fluxes ? 4 : 2) * g->dim;
    f->cost.work = WORK_SCALAR * n * (WORK_PLACE + WORK_SAMPLE * pow(nodes, g->dim));
    f->cost.work += (double)f->cost.interactions + 2 * (double)f->cost.updates;
    f->cost.work += WORK_SCALAR * WORK_GHOST * ((double)g->size - n) * (double)g->steps;
}

static int solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why) {
    if (p->shape && m != &method_ftcs_flux) return ftcs_polar_solve(m->name, p, o, f, why);
    if (p->k_law && m != &method_ftcs_flux) return ftcs_nonlinear_solve(m->name, p, o, f, why);
    struct ftcs_grid g;
    double called = field_clock();
    int status = ftcs_grid_make(&g, m->name, m == &method_ftcs_flux, p, o, why);
    if (status) return status;
    double before = heat(&g), stepping = field_clock();
    status = run(&g, p, why);
    double stepped = field_clock();
    if (status == STATUS_OK) {
        double after = heat(&g);
        hand_over(&g, f);
        count(&g, o, f);
        for (int a = 0; a < p->dim; a++) f->spacing[a] = g.d[a];
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
