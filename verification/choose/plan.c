/* The plan of a run: the same layout, operator and choice of steps as the run itself, so that they cannot differ, and
 * then what is held and counted.  A unit test compares that with what runs report, and with what they allocate. */
#include "verification/choose/plan.h"

#include "solver/differences/ftcs_grid.h"
#include "solver/methods/particles.h"
#include "solver/space/sample.h"
#include "verification/run/symmetry.h"
#include "verification/run/experiment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const plan_phases[] = {"set-up", "steps", "answer", "refinement", "errors", NULL};

enum plan_phase plan_peak(const struct plan *plan) {
    int most = 0;
    for (int i = 1; i < PLAN_PHASES; i++)
        if (plan->bytes[i] > plan->bytes[most]) most = i;
    return (enum plan_phase)most;
}

static void hold(struct plan *plan, const char *what, size_t bytes, enum plan_phase from, enum plan_phase to) {
    if (bytes == 0) return;
    plan->array[plan->count++] = (struct plan_array){what, bytes, from, to};
    for (int i = (int)from; i <= (int)to; i++) plan->bytes[i] += bytes;
}

/* ---- Particles ---- */

static const double ASSEMBLED = 2e5,
                    FEWEST = 2000; /* particles whose rows are assembled to be counted: most, least */

static int assemble(const struct experiment *e, const struct options *o, const struct lattice *l, int rows,
                    struct heat_operator *a, struct failure *why) {
    const struct problem *p = &e->problem;
    const struct scheme *s = e->method->scheme;
    struct cloud c;
    if (!rows) return operator_outline_lattice(a, p, o, s, l, why);
    if (layout_cloud(p, o, l, s->sweeps * 2.0 * o->h * l->dx[0], &c, why)) return why->status;
    int status = operator_create_rows(a, p, o, s, &c, l->dx[0], why);
    layout_cloud_free(&c);
    return status;
}

static void hold_operator(const struct problem *p, const struct options *o, const struct lattice *l,
                          const struct heat_operator *a, struct plan *plan) {
    size_t constants = a->constant ? a->state * sizeof *a->g : 0;
    plan->rows = a->weight == NULL;
    hold(plan, plan->rows ? "rows: weights, columns, diagonal" : "stencil: a quadrant of weights, for all particles",
         a->bytes - constants, PLAN_SET_UP, PLAN_STEPS);
    hold(plan, "what walls and source add", constants, PLAN_SET_UP, PLAN_STEPS);
    hold(plan, "particles, ghosts and rows in the making", a->making, PLAN_SET_UP, PLAN_SET_UP);
    if (!plan->rows) hold(plan, "nodes of the averages", sample_bytes(p, o->sampling, l), PLAN_SET_UP, PLAN_SET_UP);
    for (int d = 0; d < 2; d++) plan->reach[d] = plan->rows ? 0 : a->reach[d];
    plan->neighbours = (double)a->pairs / (double)a->n;
}

static int hold_march(const struct experiment *e, const struct options *o, const struct lattice *l,
                      const struct heat_operator *a, struct plan *plan, struct failure *why) {
    struct march m;
    if (o->stepper == STEPPER_EXACT) {
        plan->stages = 0;
        plan->updates = (long long)a->n;
        plan->interactions = (long long)a->pairs;
        return STATUS_OK;
    }
    if (particles_march(&e->problem, o, e->method->scheme, l, a, &m, why)) return why->status;
    hold(plan, m.stepper == STEPPER_RKL2 ? "four states with their ghosts" : "two states with their ghosts",
         (size_t)stepper_arrays(m.stepper) * a->state * sizeof(double), PLAN_STEPS, PLAN_STEPS);
    plan->steps = m.steps;
    plan->stages = m.stages;
    plan->dt = m.time / (double)m.steps;
    plan->updates = (long long)a->n * m.steps * m.stages;
    plan->interactions = (long long)a->pairs * m.steps * m.stages;
    return STATUS_OK;
}

/* How many times coarser a lattice, *coarse, has few enough particles to assemble their rows; 1 for *l itself. */
static double coarsening(const struct problem *p, const struct options *o, const struct lattice *l,
                         struct lattice *coarse) {
    double n = (double)l->n[0] * l->n[1];
    struct options with = *o;
    struct failure ignored;
    *coarse = *l;
    for (double m = 2; n > ASSEMBLED && n / pow(m, p->dim) > FEWEST; m++) {
        with.dx = m * o->dx;
        if (n / pow(m, p->dim) <= ASSEMBLED / 4 && !layout_lattice(p, &with, 1, coarse, &ignored)) return m;
    }
    *coarse = *l;
    return 1;
}

/* The rows of a lattice that is `finer` times finer have as many entries, finer^2 times as large. */
static void refine_rows(struct heat_operator *a, double finer) {
    for (size_t k = 0; k < a->pairs; k++) a->value[k] *= finer * finer;
    for (size_t i = 0; i < a->n; i++) a->diagonal[i] *= finer * finer;
}

/* What was counted for `n` particles, for all that are computed. */
static void scale(struct plan *plan, size_t n) {
    double times = (double)plan->computed / (double)n;
    for (int i = 0; i < plan->count; i++) plan->array[i].bytes = (size_t)((double)plan->array[i].bytes * times);
    for (int i = 0; i < PLAN_PHASES; i++) plan->bytes[i] = (size_t)((double)plan->bytes[i] * times);
    plan->answer = (size_t)((double)plan->answer * times);
    plan->updates = (long long)((double)plan->updates * times);
    plan->interactions = (long long)((double)plan->interactions * times);
}

static int plan_particles(const struct experiment *e, const struct options *given, struct plan *plan,
                          struct failure *why) {
    const struct problem *p = &e->problem;
    struct options *o = &plan->options;
    struct lattice l, stand_in;
    struct heat_operator a = {0};
    int rows;
    if (particles_outline(p, given, e->method->scheme, o, &l, &rows, why)) return why->status;
    double finer = rows ? coarsening(p, o, &l, &stand_in) : 1;
    int status = assemble(e, o, rows ? &stand_in : &l, rows, &a, why);
    if (!status) {
        if (finer > 1) refine_rows(&a, finer), plan->stand_in = stand_in.dx[0];
        plan->answer = a.n * (size_t)(p->dim + 1) * sizeof(double);
        hold(plan, "places and temperatures", plan->answer, PLAN_SET_UP, p->whole ? PLAN_ANSWER : PLAN_ERRORS);
        hold_operator(p, o, &l, &a, plan);
        status = hold_march(e, o, &l, &a, plan, why);
        plan->computed = (size_t)l.n[0] * (size_t)l.n[1];
        if (finer > 1) scale(plan, a.n);
    }
    operator_free(&a);
    return status;
}

/* ---- Finite differences ---- */

static int plan_ftcs(const struct experiment *e, const struct options *o, struct plan *plan, struct failure *why) {
    const struct problem *p = &e->problem;
    struct ftcs_grid g;
    const int wide = strcmp(e->method->name, "ftcs_flux") == 0;
    if (ftcs_grid_outline(&g, e->method->name, wide, p, o, why)) return why->status;
    size_t nx = (size_t)g.n[0], ny = (size_t)g.n[1], n = nx * ny, unit = sizeof(double);
    size_t sides = 2 * FTCS_LAYERS * (ny + (g.dim == 2 ? nx : 0));
    int alike = g.end_cell[X_LO] * g.end_cell[X_HI] * g.end_cell[Y_LO] * g.end_cell[Y_HI] == 1;
    /* the answer comes when all but T is gone, and T goes before the answer is unfolded */
    hold(plan, "temperatures with their ghosts", g.size * unit, PLAN_SET_UP, p->whole ? PLAN_STEPS : PLAN_ANSWER);
    hold(plan, "temperatures of the next step", wide ? 0 : g.size * unit, PLAN_SET_UP, PLAN_STEPS);
    hold(plan, "fluxes of a few rows", wide ? (nx + 2 + (g.dim == 2 ? 3 * nx : 0)) * unit : 0, PLAN_SET_UP,
         PLAN_STEPS);
    hold(plan, "what the source adds in a step", p->source ? n * unit : 0, PLAN_SET_UP, PLAN_STEPS);
    hold(plan, "what the walls add", sides * unit, PLAN_SET_UP, PLAN_STEPS);
    hold(plan, "what the materials conduct and hold", p->materials == 2 ? 3 * n * unit : 0, PLAN_SET_UP, PLAN_STEPS);
    plan->answer = n * (size_t)(g.dim + 1 + !alike) * unit;
    hold(plan, alike ? "places and temperatures" : "places, temperatures and volumes", plan->answer, PLAN_ANSWER,
         p->whole ? PLAN_ANSWER : PLAN_ERRORS);
    plan->reach[0] = wide ? 2 : 1;
    plan->reach[1] = g.dim == 2 ? plan->reach[0] : 0;
    plan->computed = n;
    plan->neighbours = (wide ? 4 : 2) * g.dim;
    plan->steps = g.steps;
    plan->stages = 1;
    plan->dt = g.dt;
    plan->updates = g.steps * (long long)n;
    plan->interactions = plan->updates * (wide ? 4 : 2) * g.dim;
    return STATUS_OK;
}

/* ---- The whole ---- */

/* Of the whole: what stepping.c keeps of the runs before, the answer and its error. */
static int hold_whole(const struct experiment *e, struct plan *plan, struct failure *why) {
    const struct problem *p = &e->problem;
    const size_t n = plan->particles, unit = sizeof(double), answer = plan->answer * (n / plan->computed);
    const enum plan_phase limit = e->time_error > 0 ? PLAN_SET_UP : PLAN_REFINE;
    if (plan->computed < n) hold(plan, "places and temperatures, unfolded", answer, PLAN_ANSWER, PLAN_ERRORS);
    hold(plan, "exact temperatures", n * unit, plan->refined ? PLAN_SET_UP : PLAN_ERRORS, PLAN_ERRORS);
    if (plan->refined) {
        hold(plan, "the answer of the run before", answer, PLAN_SET_UP, PLAN_REFINE);
        hold(plan, "the answer of the run before that", e->time_error > 0 ? answer : 0, PLAN_SET_UP, PLAN_REFINE);
        hold(plan, "the answer without time error", n * unit, limit, PLAN_REFINE);
    }
    if (plan->rows && (plan->dim == 2 || plan->options.layout == LAYOUT_JITTER))
        return STATUS_OK; /* no checkerboard */
    struct lattice l;
    struct options ignored;
    int rows, status = e->method->scheme
                           ? particles_outline(p, &plan->options, e->method->scheme, &ignored, &l, &rows, why)
                           : layout_lattice(p, &plan->options, 1, &l, why);
    if (!status) hold(plan, "the error, and what its transform needs", n * unit, PLAN_ERRORS, PLAN_ERRORS);
    return status;
}

/* Of the whole or a part; what a method refuses it refuses before anything is held. */
static int plan_part(const struct experiment *e, struct plan *plan, struct failure *why) {
    plan->options = e->options;
    return e->method->scheme ? plan_particles(e, &e->options, plan, why) : plan_ftcs(e, &e->options, plan, why);
}

static int takes_exact(const struct experiment *e) {
    struct options with = e->options, ignored;
    struct lattice l;
    struct failure why;
    int rows;
    with.stepper = STEPPER_EXACT;
    return particles_outline(&e->problem, &with, e->method->scheme, &ignored, &l, &rows, &why) !=
           STATUS_NOT_APPLICABLE;
}

/* What *o leaves open, as verification/run/time_step.c settles it. */
static void settle_steps(struct experiment *e, struct plan *plan) {
    struct options *o = &e->options;
    int given = o->dt > 0 || o->fourier > 0, particles = e->method->scheme != NULL;
    if (o->stepper == STEPPER_AUTO && e->time_error > 0 && particles) o->stepper = STEPPER_RKL2;
    if (o->stepper == STEPPER_AUTO && !given && particles) o->stepper = takes_exact(e) ? STEPPER_EXACT : STEPPER_RKL2;
    if (o->stepper == STEPPER_AUTO) o->stepper = STEPPER_EULER;
    plan->refined = !given && o->stepper != STEPPER_EXACT && o->stepper != STEPPER_MATCHED && e->problem.t_end > 0;
    if (!plan->refined) return;
    plan->forecast = plan_steps_predict(e);
    if (plan->forecast.steps > 0) o->dt = e->problem.t_end / plan->forecast.steps;
}

int plan_make(const struct experiment *given, struct plan *plan, struct failure *why) {
    struct experiment whole = *given, part;
    int cut[2], status = STATUS_INPUT;
    *plan = (struct plan){.dim = given->problem.dim};
    settle_steps(&whole, plan);
    part = whole;
    if (symmetry_reduce(&whole.problem, &whole.options, &part.problem, cut)) {
        status = plan_part(&part, plan, why);
        if (!status) plan->cut[0] = cut[0], plan->cut[1] = cut[1];
    }
    if (status_refused(status)) status = plan_part(&whole, plan, why);
    if (status) return status;
    plan->particles = plan->computed * (size_t)((plan->cut[0] ? 2 : 1) * (plan->cut[1] ? 2 : 1));
    return hold_whole(&whole, plan, why);
}
