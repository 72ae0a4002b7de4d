/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps of a run of a particle method, and their counted work. */
#include "solver/particles/particles.h"
#include "solver/particles/start.h"
#include "solver/work.h"
#include "solver/shape.h"
#include "solver/space/sample.h"

#include <math.h>

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
    enum { WEIGHT = 3 * WORK_FUNCTION, ISO = 25000, AXIS = 25000, TRANSFORM = 10 };
    double n = (double)a->n, samples = o->sampling == SAMPLING_CELL ? pow(2, l->dim) : 1;
    double scalar = n * (WORK_PLACE + WORK_SAMPLE * samples), streamed = 0;
    if (!a->weight) scalar += WEIGHT * (double)a->pairs * (twice ? 2 : 1);
    if (o->h_iso) scalar += ISO;
    for (int d = 0; d < l->dim && o->stepper == STEPPER_EXACT; d++) {
        scalar += AXIS + WORK_FUNCTION * n / l->dim;
        streamed += (2 + a->constant) * TRANSFORM * n * log2(l->n[d]);
    }
    return WORK_SCALAR * scalar + streamed;
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
    f->cost.work += WORK_SCALAR * WORK_GHOST * (double)(a->state - a->n) * (double)applications;
}
