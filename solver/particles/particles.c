/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a problem and options to a field, for every particle method: layout -> sample -> operator -> stepper ->
 * field. */
#include "solver/particles/particles.h"
#include "solver/particles/compatibility.h"
#include "solver/particles/conduction.h"
#include "solver/particles/start.h"
#include "solver/particles/walls.h"
#include "solver/time/matched.h"
#include "solver/space/sample.h"
#include "solver/space/voronoi.h"
#include "solver/time/stepper.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int particles_resolve(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct failure *why) {
    *resolved = *o;
    int order = o->order > 2 ? o->order : 2;
    if (o->h == 0) resolved->h = s->h ? s->h(p) : 1.1 * order / 2;
    if (o->layout == LAYOUT_RELAXED && o->jitter == 0) resolved->jitter = 0.5;
    if (o->layout == LAYOUT_RELAXED && o->sweeps == 0) resolved->sweeps = 2000;
    if (compatibility_check(p, resolved, s, why)) return why->status;
    if (o->h_iso) return matched_isotropic(p->dim, resolved, s, &resolved->h, why);
    return STATUS_OK;
}

int particles_rows(const struct problem *p, const struct options *o) {
    return options_is_cloud(o) || p->materials == 2 || p->side[X_LO] == PERIODIC || layout_is_cut(p, o);
}

int particles_prepare(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct lattice *l, int *rows, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    if (particles_resolve(p, o, s, resolved, why)) return why->status;
    if (layout_lattice(p, resolved, l, why)) return why->status;
    *rows = particles_rows(p, o);
    if (!stepper || !stepper->needs) return STATUS_OK;
    return stepper->needs(p, o, s, l, why);
}

/* rho_c: J m^-3 K^-1, of each point's cell; NULL if it follows from the position.  Four independent partial sums
 * within one material hide the latency. */
static double heat_content(const struct problem *p, const struct field *f, const double *rho_c, double cell,
                           double volume) {
    double sum[4] = {0}, all = 0;
    size_t i = 0;
    if (p->materials == 1 && !f->weight) {
        for (; i + 4 <= f->n; i += 4)
            for (size_t k = 0; k < 4; k++) sum[k] += f->T[i + k];
        for (; i < f->n; i++) sum[i % 4] += f->T[i];
    }
    for (; i < f->n; i++) {
        double x[DIM_MAX], held = rho_c ? rho_c[i] : layout_rho_c(p, cell, field_place(f, i, x)[0]);
        all += held * f->T[i] * (f->weight ? f->weight[i] : volume);
    }
    return all + p->material[0].rho_c * ((sum[0] + sum[1]) + (sum[2] + sum[3])) * volume;
}

/* Min and max of T.  Eight independent accumulators hide the latency. */
static void find_range(const struct field *f, double range[2]) {
    enum { APART = 8 };
    double lo[APART], hi[APART];
    for (size_t k = 0; k < APART; k++) lo[k] = HUGE_VAL, hi[k] = -HUGE_VAL;
    size_t i = 0;
    for (; i + APART <= f->n; i += APART)
        for (size_t k = 0; k < APART; k++) {
            double T = f->T[i + k];
            lo[k] = T < lo[k] ? T : lo[k];
            hi[k] = T > hi[k] ? T : hi[k];
        }
    range[0] = HUGE_VAL, range[1] = -HUGE_VAL;
    for (; i < f->n; i++) range[0] = fmin(range[0], f->T[i]), range[1] = fmax(range[1], f->T[i]);
    for (size_t k = 0; k < APART; k++) range[0] = fmin(range[0], lo[k]), range[1] = fmax(range[1], hi[k]);
}

/* Averaged initial data stay in range; heat-conserving data may overshoot by a fraction of the jump.  The limit is
 * half of the range, as for a run. */
static int check_start(const struct field *f, struct failure *why) {
    double slack = (f->range[1] - f->range[0]) / 2 + 1e-9 * fmax(fabs(f->range[0]), fabs(f->range[1]));
    for (size_t i = 0; i < f->n; i++) {
        if (f->T[i] >= f->range[0] - slack && f->T[i] <= f->range[1] + slack) continue;
        double x[DIM_MAX];
        char place[PLACE_TEXT];
        return refuse(why, STATUS_NUMERICAL,
                      "the initial temperature of particle %zu at %s is %.4g K, the data are in [%.4g, %.4g] K; use "
                      "another --sampling, --h or layout",
                      i, problem_place(f->dim, field_place(f, i, x), place), f->T[i], f->range[0], f->range[1]);
    }
    return STATUS_OK;
}

/* room: of T, for a state. */
static void place_on_lattice(const struct lattice *l, size_t room, struct field *f) {
    field_alloc_lattice(f, l->dim, l->n, xcalloc(room, sizeof *f->T));
    for (int a = 0; a < l->dim; a++)
        for (int i = 0; i < l->n[a]; i++) {
            double x[DIM_MAX];
            layout_position(l, i, i, i, x);
            f->x[a][i] = x[a];
        }
}

double particles_reach(const struct options *o, const struct scheme *s, const struct lattice *l) {
    return s->sweeps * 2.0 * o->h * l->dx[0];
}

int particles_cloud(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    struct cloud *c, struct failure *why) {
    if (layout_cloud(p, o, l, particles_reach(o, s, l), c, why)) return why->status;
    int status = walls_fill(p, o, c, l->dx[0], why);
    if (status) layout_cloud_free(c);
    return status;
}

/* 1 if the initial data are averaged over the cells of the scheme. */
static int averages_cells(const struct options *o, const struct scheme *s) {
    return s->cells && o->sampling == SAMPLING_CELL;
}

static int place_cloud(const struct problem *p, const struct options *o, const struct scheme *s,
                       const struct lattice *l, struct heat_operator *a, struct field *f, struct failure *why) {
    struct cloud c;
    if (particles_cloud(p, o, s, l, &c, why)) return why->status;
    int status = operator_create_csr(a, p, o, s, &c, l->dx[0], why);
    field_alloc(f, p->dim, c.n);
    if (!status && averages_cells(o, s)) status = voronoi_average(p, &c, o->threads, f->T, why);
    for (size_t i = 0; i < c.n; i++) {
        double x[DIM_MAX];
        layout_cloud_place(&c, i, x);
        field_put(f, i, x);
    }
    f->weight = a->volume, a->volume = NULL;
    if (!f->weight) f->weight = c.cell, c.cell = NULL;
    if (a->images && !status) {
        a->images->cloud = xcalloc(1, sizeof c);
        *a->images->cloud = c;
    } else {
        layout_cloud_free(&c);
    }
    return status;
}

/* Initial temperature of a particle off the lattice; on a Dirichlet wall the wall's temperature, which it keeps. */
static double start_at(const struct problem *p, const struct options *o, const struct lattice *l, const double x[2]) {
    double cell = layout_cell(o, l->dx[0]);
    if (layout_is_cut(p, o)) {
        int wall;
        struct foot f = shape_nearest(p, x, &wall);
        if (p->side[wall] == DIRICHLET && f.depth <= LAYOUT_ON_WALL * l->dx[0])
            return p->wall(p, (enum side)wall, f.x, 0);
    }
    return (cell > 0 ? sample_cell : sample_initial)(p, o->sampling, l->dx, x);
}

/* Sets positions, operator and shape of the field. */
static int place(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                 int rows, struct heat_operator *a, struct field *f, struct failure *why) {
    if (rows) {
        if (place_cloud(p, o, s, l, a, f, why)) return why->status;
        int ordered = p->dim == 1 && !options_is_cloud(o); /* else by cells */
        for (int d = 0; d < DIM_MAX && ordered; d++) f->shape[d] = d ? 1 : (int)f->n;
    } else {
        if (operator_create_lattice(a, p, o, s, l, why)) return why->status;
        place_on_lattice(l, a->state, f);
    }
    for (int d = 0; d < p->dim; d++) f->spacing[d] = l->dx[d];
    return STATUS_OK;
}

static int set_start(const struct problem *p, const struct options *o, const struct scheme *s,
                     const struct lattice *l, int rows, struct heat_operator *a, struct field *f,
                     struct failure *why) {
    if (!rows) sample_lattice(p, o->sampling, l, f->T);
    if (options_is_matched(o) && !rows) matched_source(p, o, a, f->T);
    for (size_t i = 0; i < f->n && rows && !averages_cells(o, s); i++) {
        double x[DIM_MAX];
        f->T[i] = start_at(p, o, l, field_place(f, i, x));
    }
    find_range(f, f->range);
    if (start_is_kept(p, o, s) && start_keep_heat(p, o, s, f, why)) return why->status;
    return check_start(f, why);
}

int particles_solve(const struct method *m, const struct problem *p, const struct options *given, struct field *out,
                    struct failure *why) {
    double begin = field_clock();
    struct options o;
    struct lattice l;
    int rows;
    if (p->k_law) return nonlinear_solve(m, p, given, out, why);
    if (particles_prepare(p, given, m->scheme, &o, &l, &rows, why)) return why->status;
    if (o.stepper == STEPPER_AUTO) o.stepper = stepper_auto(1, o.dt > 0 || o.fourier > 0, 0);

    struct field f = {0};
    struct heat_operator a = {0};
    int status = place(p, &o, m->scheme, &l, rows, &a, &f, why);
    f.time = p->t_end;
    if (!status) status = set_start(p, &o, m->scheme, &l, rows, &a, &f, why);
    if (!status) {
        double volume = layout_volume(&l), cell = layout_cell(&o, l.dx[0]);
        f.heat[0] = heat_content(p, &f, a.rho_c, cell, volume);
        double loop = field_clock();
        status = particles_integrate(p, &o, m->scheme, &l, &a, &f, why);
        f.cost.step_seconds = field_clock() - loop;
        if (a.state > a.n) f.T = xcheck(realloc(f.T, f.n * sizeof *f.T), f.n, sizeof *f.T);
        f.heat[1] = heat_content(p, &f, a.rho_c, cell, volume);
    }
    operator_free(&a);
    f.cost.seconds = field_clock() - begin;
    if (status)
        field_free(&f);
    else
        *out = f;
    return status;
}
