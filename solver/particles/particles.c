/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a problem and options to a field, for every particle method: layout -> sample -> operator -> stepper -> field.
 */
#include "solver/particles/particles.h"
#include "solver/particles/compatibility.h"
#include "solver/particles/start.h"
#include "solver/particles/walls.h"
#include "solver/time/growth.h"
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
    if (o->h < 0 || !isfinite(o->h)) return refuse(why, STATUS_INPUT, "--h %g: must be > 0, in units of dx", o->h);
    if (o->layout == LAYOUT_RELAXED && o->jitter == 0) resolved->jitter = 0.5;
    if (o->sweeps == 0) resolved->sweeps = 2000;
    if (options_is_cloud(o) && !(o->jitter >= 0 && o->jitter <= 0.5))
        return refuse(why, STATUS_INPUT, "--jitter %g: must be 0 to 0.5, in units of dx", o->jitter);
    if (compatibility_check(p, resolved, s, why)) return why->status;
    if (o->h_iso) return matched_isotropic(resolved, s, &resolved->h, why);
    return STATUS_OK;
}

int particles_rows(const struct problem *p, const struct options *o) {
    return options_is_cloud(o) || p->materials == 2 || p->side[X_LO] == PERIODIC || layout_is_cut(p, o);
}

int particles_prepare(const struct problem *p, const struct options *o, const struct scheme *s,
                      struct options *resolved, struct lattice *l, int *rows, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    if (particles_resolve(p, o, s, resolved, why)) return why->status;
    double ratio = o->stepper == STEPPER_MATCHED && p->dim == 2 ? sqrt(p->material[0].k[1] / p->material[0].k[0]) : 1;
    if (layout_lattice(p, resolved, ratio, l, why)) return why->status;
    *rows = particles_rows(p, o);
    if (!stepper || !stepper->needs) return STATUS_OK;
    return stepper->needs(p, o, s, l, why);
}

/* What source and fluxes can add in the time of the run, K.  A flux q through a side of a body of length L warms it
 * by q t/(rho_c L) on the average, and bends its profile by q L/k at most. */
static double heat_added(const struct problem *p, const struct field *f, const double flux[4]) {
    double source = 0, add = 0, rho_c = p->material[0].rho_c;
    for (int m = 1; m < p->materials; m++) rho_c = fmin(rho_c, p->material[m].rho_c);
    for (size_t i = 0; i < f->n && p->source; i++) {
        double x[2] = {f->x[i], f->y ? f->y[i] : 0};
        source = fmax(source, fabs(p->source(p, x)));
    }
    for (int s = 0; s < 2 * p->dim; s++) {
        double extent = p->hi[s / 2] - p->lo[s / 2], k = p->material[0].k[s / 2];
        for (int m = 1; m < p->materials; m++) k = fmin(k, p->material[m].k[s / 2]);
        add += flux[s] * (extent / k + p->t_end / (rho_c * extent));
    }
    return add + source * p->t_end / rho_c;
}

/* What the data span, K: initial data, walls, and the heat that comes in. */
static void data_range(const struct problem *p, const struct field *f, double *lo, double *hi) {
    *lo = f->range[0], *hi = f->range[1];
    double flux[4] = {0};
    for (int s = 0; s < 2 * p->dim; s++)
        for (int k = 0; k <= 8 && shape_has_wall(p, s); k++) {
            double at[2] = {cos(k * M_PI / 4), sin(k * M_PI / 4)}; /* a direction, of a round wall */
            for (int a = 0; a < 2 && !p->shape; a++) at[a] = p->lo[a] + k / 8.0 * (p->hi[a] - p->lo[a]);
            struct foot foot = shape_foot(p, s, at);
            double value = p->wall(p, (enum side)s, foot.x);
            if (p->side[s] == NEUMANN)
                flux[s] = fmax(flux[s], fabs(value));
            else
                *lo = fmin(*lo, value), *hi = fmax(*hi, value);
        }
    double add = heat_added(p, f, flux);
    *lo -= add, *hi += add;
}

/* rho_c: of each point's cell; NULL where its place says it.  Four sums of what lies in one material: additions that
 * do not wait for each other, in an order that does not change. */
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
        double held = rho_c ? rho_c[i] : layout_rho_c(p, cell, f->x[i]);
        all += held * f->T[i] * (f->weight ? f->weight[i] : volume);
    }
    return all + p->material[0].rho_c * ((sum[0] + sum[1]) + (sum[2] + sum[3])) * volume;
}

/* The lowest and the highest temperature; eight at a time, which do not wait for each other. */
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

/* A start is an average of its data, and stays in their range; one that keeps the heat of a jump leaves it by a part
 * of a particle's.  Half of the range is as much as a run may leave it by. */
static int check_start(const struct field *f, struct failure *why) {
    double slack = (f->range[1] - f->range[0]) / 2 + 1e-9 * fmax(fabs(f->range[0]), fabs(f->range[1]));
    for (size_t i = 0; i < f->n; i++)
        if (!(f->T[i] >= f->range[0] - slack && f->T[i] <= f->range[1] + slack))
            return refuse(
                why, STATUS_NUMERICAL,
                "the start has %.4g K at particle %zu at %.6g m, the data are in [%.4g, %.4g] K; take another "
                "--sampling, --h or layout",
                f->T[i], i, f->x[i], f->range[0], f->range[1]);
    return STATUS_OK;
}

static void place_on_lattice(const struct lattice *l, struct field *f) {
    size_t nx = (size_t)l->n[0], ny = (size_t)l->n[1];
    double x[2];
    for (size_t i = 0; i < nx; i++) {
        layout_position(l, (int)i, 0, x);
        f->x[i] = x[0];
    }
    for (size_t j = 1; j < ny; j++) memcpy(f->x + j * nx, f->x, nx * sizeof *f->x);
    for (size_t j = 0; j < ny && f->y; j++) {
        layout_position(l, 0, (int)j, x);
        for (size_t i = 0; i < nx; i++) f->y[j * nx + i] = x[1];
    }
}

/* Rows of the plane go by cells. */
int particles_on_lattice(const struct problem *p, const struct options *o, int rows) {
    return !options_is_cloud(o) && !(rows && p->dim == 2);
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

/* Whether the initial data are averaged over the very cells that the scheme has. */
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
        f->x[i] = c.x[i];
        if (f->y) f->y[i] = c.y[i];
    }
    f->weight = a->volume, a->volume = NULL;
    if (!f->weight) f->weight = c.cell, c.cell = NULL;
    layout_cloud_free(&c);
    return status;
}

/* STATUS_UNSTABLE where many stages of RKL2 meet rows whose eigenvalues are far from real, as where a wall cuts the
 * particles.  To seven stages none of the operators here has a mode that they do not damp. */
static int check_damping(const struct options *o, const struct heat_operator *a, const struct march *m,
                         struct failure *why) {
    enum { FEW = 7 };
    if (o->stepper != STEPPER_RKL2 || a->weight || m->stages <= FEW) return STATUS_OK;
    double dt = m->time / (double)m->steps, factor = growth_by_steps(a, m->bound, dt, (double)m->steps);
    if (factor == 0) return STATUS_OK;
    return refuse(why, STATUS_UNSTABLE,
                  "--dt %g: a step of rkl2's %d stages multiplies by %.3g what should be gone after it; take shorter "
                  "steps, or --stepper chebyshev",
                  dt, m->stages, factor);
}

static int integrate(const struct problem *p, const struct options *o, const struct scheme *s,
                     const struct lattice *l, struct heat_operator *a, struct field *f, struct failure *why) {
    f->cost.bytes = a->n * (size_t)(p->dim + 1 + (f->weight != NULL)) * sizeof *f->T + a->bytes;
    struct march m;
    double bound = operator_bound(a);
    if (particles_march(p, o, s, l, a, bound, &m, why)) return why->status;
    particles_count(p, o, s, l, a, &m, f);
    const struct stepper *stepper = stepper_of(o->stepper);
    if (stepper->evolve) {
        stepper->evolve(a, p->t_end, f->T);
        return STATUS_OK;
    }
    f->bound = bound;
    data_range(p, f, &m.lo, &m.hi);
    f->data[0] = m.lo, f->data[1] = m.hi;
    m.x = f->x, m.y = f->y;
    if (check_damping(o, a, &m, why)) return why->status;
    return stepper_march(a, &m, f->T, &f->cost.bytes, why);
}

int particles_growth(const struct method *m, const struct problem *p, const struct options *given,
                     const struct field *f, double *rate, struct failure *why) {
    struct options o, there = *given;
    struct lattice l;
    struct cloud c;
    struct heat_operator a;
    int rows = 0;
    *rate = NAN;
    there.placed = there.layout == LAYOUT_RELAXED ? f : NULL;
    if (!m->scheme) return STATUS_OK;
    there.stepper = STEPPER_RK2; /* the rows are the same */
    if (particles_prepare(p, &there, m->scheme, &o, &l, &rows, why)) return why->status;
    if (!rows) return STATUS_OK;
    if (particles_cloud(p, &o, m->scheme, &l, &c, why)) return why->status;
    int status = operator_create_csr(&a, p, &o, m->scheme, &c, l.dx[0], why);
    layout_cloud_free(&c);
    if (status) return status;
    *rate = growth_rate(&a, operator_bound(&a), p->t_end);
    operator_free(&a);
    return STATUS_OK;
}

/* The start of a particle off the lattice; on a Dirichlet wall the wall's temperature, which it holds. */
static double start_at(const struct problem *p, const struct options *o, const struct lattice *l, const double x[2]) {
    double cell = layout_cell(o, l->dx[0]);
    int wall;
    struct foot f = shape_nearest(p, x, &wall);
    if (layout_is_cut(p, o) && p->side[wall] == DIRICHLET && f.depth <= LAYOUT_ON_WALL * l->dx[0])
        return p->wall(p, (enum side)wall, f.x);
    return (cell > 0 ? sample_cell : sample_initial)(p, o->sampling, l->dx, x);
}

int particles_solve(const struct method *m, const struct problem *p, const struct options *given, struct field *out,
                    struct failure *why) {
    double begin = field_clock();
    const struct scheme *s = m->scheme;
    struct options resolved, *o = &resolved;
    struct lattice l;
    int rows;
    if (particles_prepare(p, given, s, o, &l, &rows, why)) return why->status;
    if (o->stepper == STEPPER_AUTO) o->stepper = STEPPER_RK2;

    struct field field, *f = &field;
    struct heat_operator a = {0};
    *f = (struct field){0};
    if (!rows) field_alloc(f, p->dim, (size_t)l.n[0] * (size_t)l.n[1]);
    int status = rows ? place_cloud(p, o, s, &l, &a, f, why) : operator_create_lattice(&a, p, o, s, &l, why);
    if (!status) {
        if (!rows) place_on_lattice(&l, f);
        double volume = l.dx[0] * l.dx[1], cell = layout_cell(o, l.dx[0]);
        for (int d = 0; d < 2; d++) {
            f->shape[d] = particles_on_lattice(p, o, rows) ? l.n[d] : 0;
            f->spacing[d] = d < p->dim ? l.dx[d] : 0;
        }
        if (!rows) sample_lattice(p, o->sampling, &l, f->T);
        if (o->stepper == STEPPER_MATCHED && !rows) matched_source(p, o, &a, f->T);
        for (size_t i = 0; i < f->n && rows && !averages_cells(o, s); i++) {
            double x[2] = {f->x[i], f->y ? f->y[i] : 0};
            f->T[i] = start_at(p, o, &l, x);
        }
        find_range(f, f->range);
        if (start_is_kept(p, o, s)) status = start_keep_heat(p, o, s, f, why);
        if (!status) status = check_start(f, why);
        f->heat[0] = heat_content(p, f, a.rho_c, cell, volume);
        f->time = p->t_end;
        double loop = field_clock();
        if (!status) status = integrate(p, o, s, &l, &a, f, why);
        f->cost.step_seconds = field_clock() - loop;
        f->heat[1] = heat_content(p, f, a.rho_c, cell, volume);
    }
    operator_free(&a);
    f->cost.seconds = field_clock() - begin;
    if (status)
        field_free(f);
    else
        *out = field;
    return status;
}
