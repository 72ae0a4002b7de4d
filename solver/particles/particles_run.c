/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a problem and options to a field, for every particle method: layout -> sample -> operator -> stepper ->
 * field. */
#include "solver/particles/particles.h"

#include "solver/particles/nonlinear.h"
#include "solver/particles/start.h"
#include "solver/shape.h"
#include "solver/space/assembly.h"
#include "solver/space/sample.h"
#include "solver/time/growth.h"
#include "solver/work.h"

#include <math.h>
#include <stdlib.h>

/* ---- Particles and operator ---- */

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

static int place_cloud(const struct problem *p, const struct options *o, const struct scheme *s,
                       const struct lattice *l, struct heat_operator *a, struct field *f, struct failure *why) {
    struct cloud c;
    if (particles_cloud(p, o, s, l, &c, why)) return why->status;
    int status = assembly_operator(a, p, o, s, &c, l->dx[0], why);
    field_alloc(f, p->dim, c.n);
    if (!status && start_averages_cells(o, s)) status = voronoi_average(p, &c, o->threads, f->T, why);
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

/* Sets positions, operator and shape of the field. */
static int lay_out(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
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

/* Positions, operator and initial data, taken from o->assembled if a run has filled it. */
static int set_up(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                  int rows, struct heat_operator *a, struct field *f, struct failure *why) {
    struct assembled *kept = rows ? o->assembled : NULL;
    if (kept && kept->rows.n) {
        *a = kept->rows, *f = field_copy(&kept->start);
        return STATUS_OK;
    }
    if (lay_out(p, o, s, l, rows, a, f, why) || start_set(p, o, s, l, rows, a, f, why)) return why->status;
    if (kept) kept->rows = *a, kept->start = field_copy(f);
    return STATUS_OK;
}

void particles_free_assembled(struct assembled *kept) {
    operator_free(&kept->rows);
    field_free(&kept->start);
}

/* ---- Time steps ---- */

/* 1 if the initial data differ from the temperature of a round Dirichlet wall by more than 1e-9 of their size. */
static int round_is_rough(const struct problem *p) {
    enum { PLACES = 64 };
    for (int k = 0; k < 2 * PLACES; k++) {
        double angle = 2 * M_PI * k / PLACES,
               direction[DIM_MAX] = {cos(angle), sin(angle), p->dim == 3 ? cos(5 * angle) : 0};
        int s = k % 2;
        if (!shape_has_wall(p, s) || p->side[s] != DIRICHLET) continue;
        struct foot f = shape_foot(p, s, direction);
        double start = p->initial(p, f.x), value = p->wall(p, (enum side)s, f.x, 0);
        if (fabs(start - value) > 1e-9 * (fabs(start) + fabs(value))) return 1;
    }
    return 0;
}

/* 1 if the data have jumps, or differ from the temperature of a wall. */
static int is_rough(const struct problem *p, const struct lattice *l) {
    if (p->shape) return round_is_rough(p);
    int rough = p->materials > 1 || p->jumps[0] + p->jumps[1] + p->jumps[2] > 0;
    for (int s = 0; s < 2 * p->dim && !rough; s++)
        rough = p->side[s] == DIRICHLET && !sample_meets_wall(p, l, (enum side)s);
    return rough;
}

/* Plans the steps for the operator *a with this bound, s^-1; no steps for an exact stepper.  Leaves m->lo and m->hi
 * unset. */
static int march_of(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    const struct heat_operator *a, double bound, struct march *m, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    *m = (struct march){.stepper = o->stepper, .time = p->t_end, .steps = 1, .stages = 1, .bound = bound};
    if (stepper->plan) return stepper->plan(p, o, s, a, m, why);
    double dt = o->dt;
    if (dt == 0 && o->fourier > 0) dt = o->fourier * l->dx[0] * l->dx[0] / problem_diffusivity(p);
    if (stepper->length) dt = stepper->length(dt, p->t_end, bound);
    if (dt == 0) dt = 1 / bound;                                        /* half of the stable step */
    const char *name = o->fourier > 0 && o->dt == 0 ? "fourier" : "dt"; /* the option, for messages */
    double asked = o->fourier > 0 && o->dt == 0 ? o->fourier : dt;
    if (!(dt > 0) || !isfinite(dt)) return refuse(why, STATUS_INPUT, "--%s %g: gives steps of %g s", name, asked, dt);
    double steps = ceil(p->t_end / dt - 1e-9);
    if (steps > 1e12) return refuse(why, STATUS_INPUT, "--%s %g: more than 1e12 steps", name, asked);
    m->steps = (long long)fmax(1, steps);
    dt = m->time / (double)m->steps;
    m->stages = stepper->count ? stepper->count(dt, bound) : stepper->stages;
    if (stepper->first && is_rough(p, l)) stepper->first(dt, bound, m->start);
    if (m->stages > STEPPER_STAGES_MAX)
        return refuse(why, STATUS_INPUT, "--%s %g: a step of %s would need more than %d stages; use more steps", name,
                      asked, stepper->name, STEPPER_STAGES_MAX);
    if ((double)a->pairs * (double)m->steps * m->stages > 9e18)
        return refuse(why, STATUS_INPUT, "--%s %g: more than 9e18 interactions, the limit", name, asked);
    return STATUS_OK;
}

/* Work besides the steps: samples (averages need two nodes per particle along an axis, splines one), weights, a
 * stencil for each of the ten or so h/dx that --h iso tries; for transforms the plan or table of each axis, 10 log2
 * n per particle forward and backward, and the modes. */
static double set_up_work(const struct options *o, const struct lattice *l, const struct heat_operator *a,
                          int twice) {
    enum { WEIGHT = 3 * WORK_FUNCTION, ISO = 25000, AXIS = 25000, TRANSFORM = 10 };
    double n = (double)a->n, samples = o->sampling == SAMPLING_CELL ? pow(2, l->dim) : 1;
    double scalar = n * (WORK_PLACE + WORK_SAMPLE * samples), streamed = 0;
    if (!a->weight) scalar += WEIGHT * (double)a->pairs * (twice ? 2 : 1);
    if (o->h_iso) scalar += ISO;
    for (int d = 0; d < l->dim && stepper_of(o->stepper)->evolve; d++) {
        scalar += AXIS + WORK_FUNCTION * n / l->dim;
        streamed += (2 + a->constant) * TRANSFORM * n * log2(l->n[d]);
    }
    return WORK_SCALAR * scalar + streamed;
}

/* Sets points, h, steps, updates, interactions and work of that march in *f. */
static void set_cost(const struct problem *p, const struct options *o, const struct scheme *s,
                     const struct lattice *l, const struct heat_operator *a, const struct march *m, struct field *f) {
    const long long applications = m->steps ? stepper_applications(m) : 1;
    f->dim = l->dim, f->n = a->n, f->h = o->h;
    f->steps = m->steps, f->stages = m->stages, f->dt = m->steps ? m->time / (double)m->steps : 0;
    f->applications = m->steps ? applications : 0;
    f->cost.updates = (long long)a->n * applications;
    f->cost.interactions = (long long)a->pairs * applications;
    f->cost.work = set_up_work(o, l, a, start_is_kept(p, o, s));
    if (m->steps == 0) return;
    f->cost.work += (double)f->cost.interactions + 2 * (double)f->cost.updates; /* each update loads and stores */
    f->cost.work += WORK_SCALAR * WORK_GHOST * (double)(a->state - a->n) * (double)applications;
}

/* Possible effect of source and fluxes during the run, K.  A flux q through a side of a body of length L heats it by
 * q t/(rho_c L) on average and bends its profile by at most q L/k. */
static double heat_added(const struct problem *p, const struct field *f, const double flux[SIDES]) {
    double source = 0, add = 0, rho_c = p->material[0].rho_c;
    for (int m = 1; m < p->materials; m++) rho_c = fmin(rho_c, p->material[m].rho_c);
    for (size_t i = 0; i < f->n && p->source; i++) {
        double x[DIM_MAX];
        field_place(f, i, x);
        source = fmax(source, fmax(fabs(p->source(p, x)), fabs(problem_source(p, x, p->t_end))));
    }
    for (int s = 0; s < 2 * p->dim; s++) {
        double extent = p->hi[s / 2] - p->lo[s / 2], k = p->material[0].k[s / 2];
        for (int m = 1; m < p->materials; m++) k = fmin(k, p->material[m].k[s / 2]);
        add += flux[s] * (extent / k + p->t_end / (rho_c * extent));
    }
    return add + source * p->t_end / rho_c;
}

/* Range of the data, K: initial data, walls, and incoming heat. */
static void data_range(const struct problem *p, const struct field *f, double *lo, double *hi) {
    *lo = f->range[0], *hi = f->range[1];
    double flux[SIDES] = {0};
    for (int s = 0; s < 2 * p->dim; s++)
        for (int k = 0; k < (p->dim == 3 ? 81 : 9) && shape_has_wall(p, s); k++) {
            double at[DIM_MAX] = {cos(k * M_PI / 4), sin(k * M_PI / 4)}; /* a direction, for a round wall */
            for (int a = 0; a < p->dim && !p->shape; a++) {
                int first = a == (s / 2 == 0) || p->dim < 3; /* tangent of a side of a box */
                at[a] = p->lo[a] + (first ? k % 9 : k / 9) / 8.0 * (p->hi[a] - p->lo[a]);
            }
            struct foot foot = shape_foot(p, s, at);
            double least = HUGE_VAL, most = -HUGE_VAL;
            problem_wall_range(p, (enum side)s, foot.x, &least, &most);
            if (problem_law(p, s)->is_flux)
                flux[s] = fmax(flux[s], fmax(-least, most));
            else
                *lo = fmin(*lo, least), *hi = fmax(*hi, most);
        }
    double add = heat_added(p, f, flux);
    *lo -= add, *hi += add;
}

/* STATUS_UNSTABLE if the stages of a step do not damp eigenvalues far from the real axis, as those next to a wall
 * that cuts the lattice.  Up to `damped` stages damp all modes of the operators here. */
static int check_damping(const struct options *o, const struct heat_operator *a, const struct march *m,
                         struct failure *why) {
    const struct stepper *s = stepper_of(o->stepper), *without_error = stepper_of(stepper_without_error(0));
    if (!s->damped || a->weight || m->stages <= s->damped) return STATUS_OK;
    double dt = m->time / (double)m->steps, factor = growth_by_steps(a, m->bound, dt, (double)m->steps);
    if (factor == 0) return STATUS_OK;
    return refuse(why, STATUS_UNSTABLE,
                  "--dt %g: a step of %s with %d stages multiplies by %.3g a mode that should decay; use shorter "
                  "steps, or --stepper %s",
                  dt, s->name, m->stages, factor, without_error->name);
}

static int integrate(const struct problem *p, const struct options *o, const struct scheme *s,
                     const struct lattice *l, struct heat_operator *a, struct field *f, struct failure *why) {
    f->cost.bytes = field_bytes(f) + a->bytes + (o->assembled ? field_bytes(&o->assembled->start) : 0);
    struct march m;
    double bound = operator_bound(a);
    if (march_of(p, o, s, l, a, bound, &m, why)) return why->status;
    set_cost(p, o, s, l, a, &m, f);
    const struct stepper *stepper = stepper_of(o->stepper);
    if (stepper->evolve) {
        stepper->evolve(a, p->t_end, f->T);
        return STATUS_OK;
    }
    f->bound = bound;
    data_range(p, f, &m.lo, &m.hi);
    f->data[0] = m.lo, f->data[1] = m.hi;
    m.field = f;
    m.changing = problem_changes(p) ? p : NULL, m.options = o;
    if (check_damping(o, a, &m, why)) return why->status;
    return stepper_march(a, &m, f->T, &f->cost.bytes, why);
}

/* ---- The run ---- */

int particles_solve(const struct method *m, const struct problem *p, const struct options *given, struct field *out,
                    struct failure *why) {
    double begin = field_clock();
    struct options o;
    struct lattice l;
    int rows;
    if (problem_nonlinearity(p)) return nonlinear_solve(m, p, given, out, why);
    if (particles_prepare(p, given, m->scheme, &o, &l, &rows, why)) return why->status;
    if (o.stepper == STEPPER_AUTO) o.stepper = stepper_auto(1, o.dt > 0 || o.fourier > 0, 0);

    struct field f = {0};
    struct heat_operator a = {0};
    int status = set_up(p, &o, m->scheme, &l, rows, &a, &f, why);
    f.time = p->t_end;
    if (!status) {
        double volume = layout_volume(&l), cell = layout_cell(&o, l.dx[0]);
        f.heat[0] = heat_content(p, &f, a.rho_c, cell, volume);
        double loop = field_clock();
        status = integrate(p, &o, m->scheme, &l, &a, &f, why);
        f.cost.step_seconds = field_clock() - loop;
        if (a.state > a.n) f.T = xcheck(realloc(f.T, f.n * sizeof *f.T), f.n, sizeof *f.T);
        f.heat[1] = heat_content(p, &f, a.rho_c, cell, volume);
    }
    if (!o.assembled || !o.assembled->rows.n) operator_free(&a);
    f.cost.seconds = field_clock() - begin;
    if (status)
        field_free(&f);
    else
        *out = f;
    return status;
}

int particles_growth(const struct method *m, const struct problem *p, const struct options *given, double *rate,
                     struct failure *why) {
    struct options o, there = *given;
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    int rows = 0;
    *rate = NAN;
    if (!m->scheme || problem_nonlinearity(p)) return STATUS_OK;
    if (given->assembled && given->assembled->rows.n) {
        const struct heat_operator *kept = &given->assembled->rows;
        *rate = growth_rate(kept, operator_bound(kept), p->t_end);
        return STATUS_OK;
    }
    there.stepper = stepper_auto(1, 0, 0); /* the rows do not depend on it */
    if (particles_prepare(p, &there, m->scheme, &o, &l, &rows, why)) return why->status;
    if (!rows) return STATUS_OK;
    if (particles_cloud(p, &o, m->scheme, &l, &c, why)) return why->status;
    int status = assembly_operator(&a, p, &o, m->scheme, &c, l.dx[0], why);
    layout_cloud_free(&c);
    if (status) return status;
    *rate = growth_rate(&a, operator_bound(&a), p->t_end);
    operator_free(&a);
    return STATUS_OK;
}
