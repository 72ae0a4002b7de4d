/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finite volumes, an independent check of every particle method: by design the two share not one line of code.
 *
 *   rho_c V_i dT_i/dt = sum over faces of C_f (T_n - T_i) + G V_i,   C_f = k_f area / distance
 *
 * A rod, a rectangle, a box, a disc, a ring and a ball are grids of the same kind (ftcs.h): cells in rows along three
 * axes, faces between each cell and the next one along an axis (ftcs_grid.c, ftcs_round.c).  One function has the
 * conductance of a face (ftcs_face.c), another the ghost beyond a wall (ftcs_walls.c), and one sweep adds them all up
 * (ftcs_step.c).  A contact resistance is a further term of a conductance, a tensor a further flux of a face
 * (ftcs_cross.c).
 *
 * With C_f of one material in a box this is
 *
 *   direct       dT_i/dt = kappa_x (T_{i+1} - 2 T_i + T_{i-1}) / dx^2 + the same along y and z + G / rho_c
 *                (Song 2018, eq. 5; Pamplona 2019, eq. 16)
 *   with fluxes  q_i = -kappa_x (T_{i+1} - T_{i-1}) / (2 dx),  dT_i/dt = -(q_{i+1} - q_{i-1}) / (2 dx) + ...
 *                (Song 2018, eq. 6 and Fig. 1d): (T_{i+2} - 2 T_i + T_{i-2}) / (4 dx^2), the direct form between
 *                second neighbours, which is blind to the checkerboard mode
 *
 * Restrictions: uniform grid, dx = dy = dz; two materials across x; one isotropic material in a round body and with
 * k(T).  With fluxes: one material in a box. */
#include "solver/differences/ftcs.h"

#include "solver/method.h"
#include "solver/status.h"
#include "solver/work.h"

#include <math.h>
#include <stdlib.h>

extern const struct method method_ftcs_flux;

/* Volumes as weights, if they differ. */
static void weigh(const struct ftcs_grid *g, struct field *f) {
    double share = 1;
    int i[DIM_MAX] = {0};
    for (int s = 0; s < SIDES && !g->round; s++) share *= g->end_cell[s];
    if (!g->round && share == 1) return;
    f->weight = xcalloc(f->n, sizeof *f->weight);
    for (size_t k = 0; k < f->n; k++, ftcs_next(g, i)) f->weight[k] = ftcs_volume(g, i);
}

/* T changes hands and closes its gaps, from the first cell to the last. */
static void hand_over(struct ftcs_grid *g, struct field *f) {
    double x[DIM_MAX];
    int i[DIM_MAX] = {0};
    const size_t cells = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2];
    const size_t bytes = g->held * sizeof *g->T;
    ftcs_free(g, 1);
    if (g->round) {
        field_alloc(f, g->p->dim, cells);
        free(f->T);
        f->T = g->T;
    } else
        field_alloc_lattice(f, g->p->dim, g->n, g->T);
    g->T = NULL;
    for (size_t k = 0; k < f->n; k++, ftcs_next(g, i)) {
        ftcs_place(g, i, x);
        if (g->round) field_put(f, k, x);
        for (int a = 0; a < f->dim && !g->round; a++) f->x[a][i[a]] = x[a];
        f->T[k] = ftcs_face_temperature(g->p, f->T[ftcs_at(g, i)]);
    }
    f->T = xcheck(realloc(f->T, f->n * sizeof *f->T), f->n, sizeof *f->T);
    f->cost.bytes = bytes;
    weigh(g, f);
}

/* Points, steps and their cost.  Fluxes need two neighbours for q and two for its slope; averages need four
 * quadrature nodes per piece of the spline along each axis; k(T) a function of each stage; the part along the angles
 * two transforms and an elimination. */
static void count(const struct ftcs_grid *g, struct field *f) {
    const struct options *o = g->o;
    const double n = (double)f->n;
    const int pieces = o->sampling == SAMPLING_SPLINE ? 4 : 1, nodes = o->sampling == SAMPLING_POINT ? 1 : 4 * pieces;
    struct cost *c = &f->cost;
    f->time = g->p->t_end, f->dt = g->dt, f->steps = g->steps, f->stages = g->stages;
    f->applications = g->applications, f->time_error = g->time_error;
    f->range[0] = g->range[0], f->range[1] = g->range[1];
    for (int a = 0; a < f->dim; a++) f->spacing[a] = g->round ? g->d[0] : g->d[a];
    c->updates = g->applications * (long long)f->n;
    c->interactions = c->updates * (g->reach == 2 ? 4 : 2) * f->dim;
    c->work = WORK_SCALAR * n * (WORK_PLACE + WORK_SAMPLE * pow(nodes, f->dim));
    c->work += (g->round ? 2 : 1) * (double)c->interactions + 2 * (double)c->updates;
    c->work += WORK_SCALAR * WORK_GHOST * ((double)g->size - n) * (double)g->applications;
    if (g->p->k_law) c->work += WORK_SCALAR * WORK_FUNCTION * (double)c->updates;
}

static int solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why) {
    struct ftcs_grid g;
    double called = field_clock();
    if (ftcs_plan(&g, m->name, m == &method_ftcs_flux, p, o, why)) return why->status;
    ftcs_fill(&g);
    double before = ftcs_heat(&g), stepping = field_clock();
    int status = ftcs_run(&g, why);
    double stepped = field_clock();
    if (status == STATUS_OK) {
        double after = ftcs_heat(&g);
        hand_over(&g, f);
        count(&g, f);
        f->heat[0] = before, f->heat[1] = after;
        f->cost.step_seconds = stepped - stepping;
        f->cost.seconds = field_clock() - called;
    }
    ftcs_free(&g, 0);
    return status;
}

const struct method method_ftcs = {
    .name = "ftcs",
    .about = "finite differences, (T[i+1] - 2 T[i] + T[i-1])/dx^2: Song eq. 5, Pamplona eq. 16",
    .accepts = "stepper layout sampling walls mean cross",
    .solve = solve,
};

const struct method method_ftcs_flux = {
    .name = "ftcs_flux",
    .about = "finite differences through the heat fluxes, (q[i+1] - q[i-1])/(2 dx): Song eq. 6",
    .accepts = "stepper layout sampling walls",
    .solve = solve,
};
