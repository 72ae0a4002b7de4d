/* The plan of a run: the same layout, operator and choice of steps as the run itself, so that they cannot differ, and
 * then what the time loop will hold and count, which a unit test compares with what runs report. */
#include "verification/plan.h"

#include "solver/ftcs_grid.h"
#include "solver/particles.h"
#include "solver/transform.h"
#include "verification/fold.h"
#include "verification/request.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void hold(struct plan *plan, const char *what, size_t bytes) {
    if (bytes == 0) return;
    plan->array[plan->count++] = (struct plan_array){what, bytes};
    plan->bytes += bytes;
}

/* ---- Particles ---- */

static int exact_applies(const struct problem *p, const struct options *o) {
    return o->layout != LAYOUT_JITTER && p->materials == 1 && o->walls == WALLS_MIRROR;
}

static int assemble(const struct request *r, const struct options *o, const struct lattice *l,
                    struct heat_operator *a, struct failure *why) {
    const struct problem *p = &r->problem;
    const struct scheme *s = r->method->scheme;
    struct cloud c;
    if (o->layout != LAYOUT_JITTER && p->materials == 1) return operator_create_lattice(a, p, o, s, l, why);
    if (layout_cloud(p, o, l, s->sweeps * 2.0 * o->h * l->dx[0], &c, why)) return why->status;
    int status = operator_create_rows(a, p, o, s, &c, l->dx[0], why);
    layout_cloud_free(&c);
    return status;
}

static void hold_operator(const struct heat_operator *a, struct plan *plan) {
    size_t all = a->bytes, g = a->g ? (a->weight ? a->state : a->n) * sizeof *a->g : 0;
    plan->rows = a->weight == NULL;
    hold(plan, plan->rows ? "rows: weights, columns, diagonal" : "stencil: a quadrant of weights, for all particles",
         all - g);
    hold(plan, "what walls and source add", g);
    for (int d = 0; d < 2; d++) plan->reach[d] = plan->rows ? 0 : a->reach[d];
    plan->particles = a->n;
    plan->neighbours = (double)a->pairs / (double)a->n;
}

static int hold_march(const struct request *r, const struct options *o, const struct lattice *l,
                      const struct heat_operator *a, struct plan *plan, struct failure *why) {
    struct march m;
    if (o->stepper == STEPPER_EXACT) {
        hold(plan, "temperatures, transformed", a->n * sizeof(double));
        hold(plan, "what walls and source add, transformed", a->g ? a->n * sizeof(double) : 0);
        hold(plan, "what the transform works with", transform_bytes(l));
        plan->stages = 0;
        plan->updates = (long long)a->n;
        plan->interactions = (long long)a->pairs;
        return STATUS_OK;
    }
    if (particles_march(&r->problem, o, r->method->scheme, l, a, &m, why)) return why->status;
    hold(plan, m.stepper == STEPPER_RKL2 ? "four states with their ghosts" : "two states with their ghosts",
         (size_t)stepper_arrays(m.stepper) * a->state * sizeof(double));
    plan->steps = m.steps;
    plan->stages = m.stages;
    plan->dt = m.time / (double)m.steps;
    plan->updates = (long long)a->n * m.steps * m.stages;
    plan->interactions = (long long)a->pairs * m.steps * m.stages;
    return STATUS_OK;
}

static int plan_particles(const struct request *r, const struct options *given, struct plan *plan,
                          struct failure *why) {
    const struct problem *p = &r->problem;
    struct options *o = &plan->options;
    struct lattice l;
    struct heat_operator a = {0};
    if (particles_settle(p, given, r->method->scheme, o, why)) return why->status;
    int open = !(o->dt > 0 || o->fourier > 0);
    if (o->stepper == STEPPER_AUTO) o->stepper = open && exact_applies(p, o) ? STEPPER_EXACT : STEPPER_RKL2;
    if (o->stepper == STEPPER_EXACT && !exact_applies(p, o))
        return fail(why, STATUS_INPUT, "--stepper exact: needs one material on a lattice, and --walls mirror");
    plan->refined = open && o->stepper != STEPPER_EXACT && o->stepper != STEPPER_MATCHED;
    double ratio = o->stepper == STEPPER_MATCHED && p->dim == 2 ? sqrt(p->material[0].k[1] / p->material[0].k[0]) : 1;
    int status = layout_lattice(p, o, ratio, &l, why);
    if (!status) status = assemble(r, o, &l, &a, why);
    if (!status) {
        hold_operator(&a, plan);
        status = hold_march(r, o, &l, &a, plan, why);
    }
    operator_free(&a);
    return status;
}

/* ---- Finite differences ---- */

static int plan_ftcs(const struct request *r, const struct options *o, struct plan *plan, struct failure *why) {
    struct ftcs_grid g;
    const int wide = strcmp(r->method->name, "ftcs_flux") == 0;
    if (ftcs_grid_make(&g, r->method->name, wide, &r->problem, o, why)) return why->status;
    size_t n = (size_t)g.n[0] * (size_t)g.n[1], unit = sizeof(double);
    size_t gain = g.gain ? n * unit : 0, flux = g.q ? (size_t)(g.n[0] + 2 + (g.dim == 2 ? 3 * g.n[0] : 0)) * unit : 0;
    size_t state = g.size * unit, held = g.held * unit;
    int alike = g.end_cell[X_LO] * g.end_cell[X_HI] * g.end_cell[Y_LO] * g.end_cell[Y_HI] == 1;
    hold(plan, "temperatures with their ghosts", state);
    hold(plan, "temperatures of the next step", g.next ? state : 0);
    hold(plan, "fluxes of a few rows", flux);
    hold(plan, "what the source adds in a step", gain);
    hold(plan, "what the walls add", held - plan->bytes);
    size_t after = state + n * unit * (alike ? 1 : 2); /* while the answer is handed over the rest is gone */
    if (after > plan->bytes) hold(plan, "the answer, beyond what it takes the place of", after - plan->bytes);
    plan->options.stepper = o->stepper == STEPPER_AUTO ? STEPPER_EULER : o->stepper;
    plan->refined = !(o->dt > 0 || o->fourier > 0) && o->stepper != STEPPER_MATCHED;
    plan->reach[0] = wide ? 2 : 1;
    plan->reach[1] = g.dim == 2 ? plan->reach[0] : 0;
    plan->particles = n;
    plan->neighbours = (wide ? 4 : 2) * g.dim;
    plan->steps = g.steps;
    plan->stages = 1;
    plan->dt = g.dt;
    plan->updates = g.steps * (long long)n;
    plan->interactions = plan->updates * (wide ? 4 : 2) * g.dim;
    ftcs_grid_free(&g);
    return STATUS_OK;
}

static int plan_part(const struct request *r, const struct options *o, struct plan *plan, struct failure *why) {
    int cut[2] = {plan->cut[0], plan->cut[1]};
    *plan = (struct plan){.options = *o, .dim = r->problem.dim, .cut = {cut[0], cut[1]}};
    int status = r->method->scheme ? plan_particles(r, o, plan, why) : plan_ftcs(r, o, plan, why);
    plan->computed = plan->particles;
    plan->particles *= (size_t)((cut[0] ? 2 : 1) * (cut[1] ? 2 : 1));
    return status;
}

int plan_make(const struct request *r, const struct options *o, struct plan *plan, struct failure *why) {
    struct request part = *r;
    if (fold_problem(&r->problem, o, &part.problem, plan->cut)) {
        int status = plan_part(&part, o, plan, why);
        if (status != STATUS_INPUT) return status;
    }
    plan->cut[0] = plan->cut[1] = 0;
    return plan_part(r, o, plan, why);
}
