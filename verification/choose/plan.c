/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plan of a run: the method's outline at the stepper and the steps that the run will choose. */
#include "verification/choose/plan.h"
#include "solver/time/stepper.h"

#include "verification/run/experiment.h"
#include "verification/run/symmetry.h"
#include "verification/run/time_step.h"

const char *const plan_phases[] = {"set-up", "steps", "errors", NULL};

enum outline_phase plan_peak(const struct plan *plan) {
    int most = 0;
    for (int i = 1; i < OUTLINE_PHASES; i++)
        if (plan->part.bytes[i] > plan->part.bytes[most]) most = i;
    return (enum outline_phase)most;
}

double plan_work(const struct plan *plan) {
    const double ROW = 9; /* extra of a CSR entry, read from memory */
    return plan->part.run.cost.work + (plan->part.rows ? ROW * (double)plan->part.run.cost.interactions : 0);
}

static int has_exact(const struct experiment *e) {
    struct options with = e->options;
    struct outline ignored;
    struct failure why;
    with.stepper = STEPPER_EXACT;
    return method_outline(e->method, &e->problem, &with, &ignored, &why) != STATUS_NOT_APPLICABLE;
}

/* What e->options leaves open, as time_step_solve resolves it. */
static void resolve_steps(struct experiment *e, enum plan_search search, struct plan *plan) {
    struct options *o = &e->options;
    int given = o->dt > 0 || o->fourier > 0, particles = e->method->scheme != NULL;
    if (o->stepper == STEPPER_AUTO && e->time_error > 0 && particles) o->stepper = STEPPER_RKL2;
    if (o->stepper == STEPPER_AUTO && !given && particles) o->stepper = has_exact(e) ? STEPPER_EXACT : STEPPER_RKL2;
    if (o->stepper == STEPPER_AUTO) o->stepper = STEPPER_EULER;
    int polynomials = o->stepper == STEPPER_CHEBYSHEV;
    plan->refined = !given && (stepper_of(o->stepper)->order > 0 || polynomials) && e->problem.t_end > 0;
    if (plan->refined && polynomials) o->dt = e->problem.t_end / 2; /* the second of two runs that agree */
    if (!plan->refined || polynomials) return;
    if (search == PLAN_STORAGE) o->dt = e->problem.t_end;
    if (search == PLAN_STORAGE) return;
    plan->forecast = plan_steps_predict(e, search == PLAN_RUN ? 1 : 2);
    if (plan->forecast.steps > 0) o->dt = e->problem.t_end / plan->forecast.steps;
}

/* What the whole adds to the part: the runs before this one, the answer and its error. */
static void hold_whole(const struct experiment *e, struct plan *plan) {
    struct outline *part = &plan->part;
    const size_t n = plan->particles, unit = sizeof(double), answer = n * (size_t)part->answer * unit;
    if (plan->refined)
        outline_hold(part, "other runs of the search for a time step", time_step_bytes(e, n, answer), OUTLINE_SET_UP,
                     OUTLINE_STEPS);
    outline_hold(part,
                 part->answer > plan->dim + 1 ? "places, temperatures and volumes" : "places and temperatures of all",
                 answer, OUTLINE_ERRORS, OUTLINE_ERRORS);
    outline_hold(part, "exact temperatures", n * unit, OUTLINE_ERRORS, OUTLINE_ERRORS);
    if (part->on_lattice)
        outline_hold(part, "the error and its transform", 2 * n * unit, OUTLINE_ERRORS, OUTLINE_ERRORS);
}

int plan_make(const struct experiment *given, enum plan_search search, struct plan *plan, struct failure *why) {
    struct experiment whole = *given, part;
    const struct method *m = given->method;
    int cut[2], status = STATUS_NOT_APPLICABLE;
    *plan = (struct plan){.dim = given->problem.dim};
    if (!m->outline)
        return refuse(why, status, "%s does not tell what it stores and does (no outline in its struct method)",
                      m->name);
    resolve_steps(&whole, search, plan);
    part = whole;
    if (symmetry_reduce(&whole.problem, &whole.options, &part.problem, cut)) {
        status = method_outline(m, &part.problem, &part.options, &plan->part, why);
        if (!status) plan->cut[0] = cut[0], plan->cut[1] = cut[1];
    }
    if (status_refused(status)) status = method_outline(m, &whole.problem, &whole.options, &plan->part, why);
    if (status) return status;
    plan->options = whole.options;
    if (plan->part.run.h > 0) plan->options.h = plan->part.run.h;
    plan->particles = plan->part.run.n * (size_t)((plan->cut[0] ? 2 : 1) * (plan->cut[1] ? 2 : 1));
    hold_whole(&whole, plan);
    return STATUS_OK;
}
