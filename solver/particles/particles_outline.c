/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps of a run of a particle method and what they cost; and what the run would store and do, told from its
 * lattice, its operator and its steps without its states.
 *
 * Rows are assembled to be counted, up to ASSEMBLED particles.  Past that those of a lattice `finer` times coarser
 * stand in: they have as many entries a particle, and a spectrum finer^2 times smaller.  Where no coarser one divides
 * the domain, its cells are about square: to 1/(2 n), n along the shorter side. */
#include "solver/particles/particles.h"
#include "solver/particles/start.h"
#include "solver/outline.h"
#include "solver/shape.h"
#include "solver/space/sample.h"

#include <math.h>

static const double ASSEMBLED = 2e5, FEWEST = 2000; /* particles: most, and least of a stand-in */

/* ---- Steps, and what they cost ---- */

/* Whether the start misses the temperature of a round Dirichlet wall, by 1e-9 of its size. */
static int round_is_rough(const struct problem *p) {
    enum { PLACES = 64 };
    for (int k = 0; k < 2 * PLACES; k++) {
        double angle = 2 * M_PI * k / PLACES, direction[2] = {cos(angle), sin(angle)};
        int s = k % 2;
        if (!shape_has_wall(p, s) || p->side[s] != DIRICHLET) continue;
        struct foot f = shape_foot(p, s, direction);
        double start = p->initial(p, f.x), value = p->wall(p, (enum side)s, f.x);
        if (fabs(start - value) > 1e-9 * (fabs(start) + fabs(value))) return 1;
    }
    return 0;
}

/* Whether the data have jumps, or a wall whose temperature they do not meet. */
static int is_rough(const struct problem *p, const struct lattice *l) {
    if (p->shape) return round_is_rough(p);
    int rough = p->materials > 1 || p->jumps[0] + p->jumps[1] > 0;
    for (int s = 0; s < 2 * p->dim && !rough; s++)
        rough = p->side[s] == DIRICHLET && !sample_meets_wall(p, l, (enum side)s);
    return rough;
}

int particles_march(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
                    const struct heat_operator *a, double bound, struct march *m, struct failure *why) {
    const struct stepper *stepper = stepper_of(o->stepper);
    *m = (struct march){.stepper = o->stepper, .time = p->t_end, .steps = 1, .stages = 1, .bound = bound};
    if (stepper->plan) return stepper->plan(p, o, s, a, m, why);
    double dt = o->dt;
    if (dt == 0 && o->fourier > 0) dt = o->fourier * l->dx[0] * l->dx[0] / problem_diffusivity(p);
    if (stepper->length) dt = stepper->length(dt, p->t_end, bound);
    if (dt == 0) dt = 1 / bound;                                        /* half of the stable step */
    const char *name = o->fourier > 0 && o->dt == 0 ? "fourier" : "dt"; /* what was asked for, for messages */
    double asked = o->fourier > 0 && o->dt == 0 ? o->fourier : dt;
    if (!(dt > 0) || !isfinite(dt)) return refuse(why, STATUS_INPUT, "--%s %g: makes steps of %g s", name, asked, dt);
    double steps = ceil(p->t_end / dt - 1e-9);
    if (steps > 1e12) return refuse(why, STATUS_INPUT, "--%s %g: more than 1e12 steps", name, asked);
    m->steps = (long long)fmax(1, steps);
    dt = m->time / (double)m->steps;
    m->stages = stepper->count ? stepper->count(dt, bound) : stepper->stages;
    if (stepper->first && is_rough(p, l)) stepper->first(dt, bound, m->start);
    if (m->stages > STEPPER_STAGES_MAX)
        return refuse(why, STATUS_INPUT, "--%s %g: a step would take %s more than %d stages; take more steps", name,
                      asked, stepper->name, STEPPER_STAGES_MAX);
    if ((double)a->pairs * (double)m->steps * m->stages > 9e18)
        return refuse(why, STATUS_INPUT, "--%s %g: more interactions than can be counted, 9e18", name, asked);
    return STATUS_OK;
}

/* Beside the steps: samples (averages along an axis take two nodes a particle, of a spline one), weights, a stencil
 * for each h/dx that --h iso tries, some ten, and for transforms what is planned or tabulated once for an axis, 10
 * log2 n for each particle to and fro, and the modes. */
static double set_up_work(const struct options *o, const struct lattice *l, const struct heat_operator *a,
                          int twice) {
    enum { WEIGHT = 3 * OUTLINE_FUNCTION, ISO = 25000, AXIS = 25000, TRANSFORM = 10 };
    double n = (double)a->n, samples = o->sampling == SAMPLING_CELL ? pow(2, l->dim) : 1;
    double scalar = n * (OUTLINE_PLACE + OUTLINE_SAMPLE * samples), streamed = 0;
    if (!a->weight) scalar += WEIGHT * (double)a->pairs * (twice ? 2 : 1);
    if (o->h_iso) scalar += ISO;
    for (int d = 0; d < l->dim && o->stepper == STEPPER_EXACT; d++) {
        scalar += AXIS + OUTLINE_FUNCTION * n / l->dim;
        streamed += (2 + a->constant) * TRANSFORM * n * log2(l->n[d]);
    }
    return OUTLINE_SCALAR * scalar + streamed;
}

void particles_count(const struct problem *p, const struct options *o, const struct scheme *s,
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
    f->cost.work += OUTLINE_SCALAR * OUTLINE_GHOST * (double)(a->state - a->n) * (double)applications;
}

/* ---- Without the run ---- */

/* How many times coarser the lattice is whose rows are counted, *coarse. */
static double coarsening(const struct problem *p, const struct options *o, const struct lattice *l,
                         struct lattice *coarse) {
    double n = (double)l->n[0] * l->n[1];
    struct options with = *o;
    struct failure ignored;
    for (double m = 2; n > ASSEMBLED && n / pow(m, p->dim) > FEWEST; m++) {
        with.dx = m * o->dx;
        if (n / pow(m, p->dim) <= ASSEMBLED / 4 && !layout_lattice(p, &with, 1, coarse, &ignored)) return m;
    }
    double m = pow(n / (ASSEMBLED / 4), 1.0 / p->dim), spacing[2] = {1, 1};
    for (int a = 0; a < p->dim; a++) {
        double extent = p->hi[a] - p->lo[a];
        spacing[a] = extent / fmax(1, nearbyint(extent / l->dx[a] / m));
    }
    with.dx = spacing[0];
    double ratio = p->dim == 2 ? spacing[1] / spacing[0] : 1;
    if (n > ASSEMBLED && !layout_lattice(p, &with, ratio, coarse, &ignored)) return with.dx / o->dx;
    *coarse = *l;
    return 1;
}

/* Rows whose counts are those of the lattice *l; *bound is that of its operator. */
static int count_rows(const struct problem *p, const struct options *o, const struct scheme *s,
                      const struct lattice *l, struct heat_operator *a, double *bound, struct outline *out,
                      struct failure *why) {
    struct lattice coarse;
    struct cloud c;
    double finer = coarsening(p, o, l, &coarse), n = (double)l->n[0] * l->n[1];
    if (particles_cloud(p, o, s, &coarse, &c, why)) return why->status;
    if (layout_is_cut(p, o)) n *= (double)c.n / ((double)coarse.n[0] * coarse.n[1]);
    int status = operator_create_csr(a, p, o, s, &c, coarse.dx[0], why);
    layout_cloud_free(&c);
    if (status) return status;
    double times = n / (double)a->n;
    *bound = operator_bound(a) * finer * finer;
    a->state = (size_t)n + (size_t)((double)(a->state - a->n) * pow(finer, p->dim - 1)); /* ghosts */
    a->n = (size_t)n;
    a->pairs = (size_t)(times * (double)a->pairs), a->bytes = (size_t)(times * (double)a->bytes);
    if (finer > 1) out->stand_in = coarse.dx[0];
    return STATUS_OK;
}

static void hold(const struct problem *p, const struct options *o, const struct scheme *s,
                 const struct heat_operator *a, const struct march *m, struct outline *out) {
    size_t constants = a->constant ? (a->weight ? a->state : a->n) * sizeof *a->g : 0, unit = sizeof(double);
    out->answer = p->dim + 1 + (s->cells && out->rows); /* volumes differ */
    out->on_lattice = particles_on_lattice(p, o, out->rows);
    out->neighbours = (double)a->pairs / (double)a->n;
    outline_hold(out, out->answer > p->dim + 1 ? "places, temperatures and volumes" : "places and temperatures",
                 a->n * (size_t)out->answer * unit, OUTLINE_SET_UP, OUTLINE_STEPS);
    outline_hold(out,
                 a->gradient ? "first derivatives: pairs, places, ghosts, fluxes"
                 : out->rows ? "rows: weights, columns, diagonal, bands of a rod"
                             : "stencil: a quadrant of weights, for all particles",
                 a->bytes - constants, OUTLINE_SET_UP, OUTLINE_STEPS);
    outline_hold(out, "what walls and source add", constants, OUTLINE_SET_UP, OUTLINE_STEPS);
    /* lists that grow by doubling, and the cloud with its ghosts; of pairs each is listed once */
    const size_t bands = a->banded ? (size_t)(2 * a->band + 1) * a->n * unit : 0;
    outline_hold(out, "neighbours while they are found, about",
                 out->rows ? (a->gradient ? 1 : 2) * (a->bytes - bands) : 0, OUTLINE_SET_UP, OUTLINE_SET_UP);
    /* on a rod; in the plane what transforms hold depends on the data, and is less than what the measured error holds
     */
    if (o->stepper == STEPPER_EXACT && p->dim == 1)
        outline_hold(out, "rates of the modes and a transform", a->n * (size_t)(a->reach[0] + 2) * unit,
                     OUTLINE_SET_UP, OUTLINE_SET_UP);
    const int states = m->steps ? stepper_of(m->stepper)->arrays : 0;
    outline_hold(out, states == 3 ? "three states with their ghosts" : "two states with their ghosts",
                 (size_t)states * a->state * unit, OUTLINE_STEPS, OUTLINE_STEPS);
}

static const char *weights_of(const struct problem *p, int rows) {
    return !rows               ? "one stencil for all particles: a lattice of one material, no neighbour list"
           : p->materials == 2 ? "a row for each particle: two materials, so that pairs differ"
                               : "a row for each particle: off the lattice each has its own neighbours";
}

int particles_outline(const struct method *m, const struct problem *p, const struct options *given,
                      struct outline *out, struct failure *why) {
    const struct scheme *s = m->scheme;
    struct options resolved, *o = &resolved;
    struct lattice l;
    struct heat_operator a = {0};
    struct march march;
    double bound = 0;
    *out = (struct outline){0};
    if (particles_prepare(p, given, s, o, &l, &out->rows, why)) return why->status;
    int status =
        out->rows ? count_rows(p, o, s, &l, &a, &bound, out, why) : operator_outline_lattice(&a, p, o, s, &l, why);
    if (!status && !out->rows) bound = operator_bound(&a);
    if (!status) status = particles_march(p, o, s, &l, &a, bound, &march, why);
    if (!status) {
        out->weights = weights_of(p, out->rows);
        particles_count(p, o, s, &l, &a, &march, &out->run);
        hold(p, o, s, &a, &march, out);
        if (start_is_kept(p, o, s))
            outline_hold(out, "rows once more, for what they keep of the start", 3 * a.bytes, OUTLINE_SET_UP,
                         OUTLINE_SET_UP);
        out->run.cost.bytes = out->bytes[OUTLINE_STEPS];
    }
    operator_free(&a);
    return status;
}
