/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder plan: what a run would store and do, and why. */
#include "verification/command/verb.h"
#include "solver/time/stepper.h"

#include "references/scene.h"
#include "verification/choose/plan.h"
#include "verification/command/request.h"
#include "verification/run/time_step.h"
#include "verification/text/json.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>

static void describe_storage(const struct outline *part, char *text, size_t size) {
    snprintf(text, size, "%s", part->weights);
    if (part->stand_in > 0) words_add(text, size, "; estimated from those at dx = %g m", part->stand_in);
}

/* Why a mirror plane is not made use of. */
static const char *uncut(const struct experiment *e, const struct plan *plan, int axis) {
    const struct options *o = &plan->options;
    if (!e->problem.mirror[axis]) return "the scene is not even about it";
    if (o->domain == DOMAIN_WHOLE) return "--domain whole";
    return o->layout != LAYOUT_LATTICE ? "needs --layout lattice"
                                       : "needs an even number of particles, and a stencil that fits";
}

static void describe_steps(const struct experiment *e, const struct plan *plan, char *text, size_t size) {
    const struct plan_steps *f = &plan->forecast;
    char until[80];
    snprintf(until, sizeof until, "refined until the time error is 1 %%, within %g updates", TIME_STEP_UPDATES_MAX);
    if (e->time_error > 0) snprintf(until, sizeof until, "the longest with a time error of %g", e->time_error);
    const struct stepper *stepper = stepper_of(plan->options.stepper);
    if (stepper->order == 0)
        snprintf(text, size, "%s", stepper->about);
    else if (!plan->refined)
        snprintf(text, size, "as asked");
    else if (f->steps == 0)
        snprintf(text, size, "%s; no coarser run predicts how many, so this is where the search begins", until);
    else if (f->runs == 1)
        snprintf(text, size, "%s; found by the search itself", until);
    else
        snprintf(text, size, "%s; predicted from runs at dx = %g and %g m", until, f->dx[0], f->dx[1]);
}

/* From the first to the last phase that an array is held in. */
static const char *held(const struct outline_array *a, char *text, size_t size) {
    snprintf(text, size, a->from == a->to ? "%s" : "%s to %s", plan_phases[a->from], plan_phases[a->to]);
    return text;
}

static void print_text(const struct experiment *e, const struct plan *plan) {
    const struct options *o = &plan->options;
    const struct outline *part = &plan->part;
    static const char *const axis[] = {"x", "y"};
    char text[240];
    enum outline_phase peak = plan_peak(plan);
    printf("%s %s, dx = %g m\n", e->scene->name, e->method->name, o->dx);
    printf("  %-13s %d: %s\n", "dimension", plan->dim,
           plan->dim == 1     ? "a rod; nothing along y is stored"
           : e->problem.shape ? "a round body"
                              : "a rectangle");
    for (int d = 0; d < plan->dim; d++)
        printf("  %-13s the middle of %s: %s\n", d ? "" : "mirror planes", axis[d],
               plan->cut[d] ? "half is computed" : uncut(e, plan, d));
    printf("  %-13s %zu", "particles", plan->particles);
    if (part->run.n < plan->particles) printf(", %zu of them computed", part->run.n);
    describe_storage(part, text, sizeof text);
    printf("\n  %-13s %s\n", "weights", text);
    if (words_among(e->method->accepts, "h"))
        printf("  %-13s %.4g in the mean, within 2 h, h/dx = %.6g\n", "neighbours", part->neighbours, o->h);
    else
        printf("  %-13s %.4g\n", "neighbours", part->neighbours);
    describe_steps(e, plan, text, sizeof text);
    printf("  %-13s %s: %s", "time", stepper_words[o->stepper], text);
    if (part->run.steps)
        printf(", %lld of %.6g s, %d stage%s", part->run.steps, part->run.dt, part->run.stages,
               part->run.stages == 1 ? "" : "s");
    printf("\n  %-13s %lld updates, %lld interactions%s\n", "work", part->run.cost.updates,
           part->run.cost.interactions, plan->refined ? ", and the runs of the search" : "");
    printf("  %-13s %zu bytes while time runs, %.4g for each particle that is computed; at most %zu (%s)\n", "memory",
           part->bytes[OUTLINE_STEPS], (double)part->bytes[OUTLINE_STEPS] / (double)part->run.n, part->bytes[peak],
           plan_phases[peak]);
    for (int i = 0; i < part->count; i++)
        printf("  %-13s %12zu  %s (%s)\n", "", part->array[i].bytes, part->array[i].what,
               held(&part->array[i], text, sizeof text));
}

static void print_json(const struct experiment *e, const struct plan *plan, struct json *j) {
    const struct options *o = &plan->options;
    const struct outline *part = &plan->part;
    char text[240];
    json_add(j, "scene %s|method %s|dx %g|dimension %d", e->scene->name, e->method->name, o->dx, plan->dim);
    json_array(j, "mirror_planes");
    for (int d = 0; d < plan->dim; d++)
        if (plan->cut[d]) json_text(j, NULL, d ? "y" : "x");
    json_end(j);
    json_add(j, "particles %zu|particles_computed %zu", plan->particles, part->run.n);
    json_text(j, "weights", part->rows ? "rows" : "stencil");
    describe_storage(part, text, sizeof text);
    json_add(j, "weights_why %s|neighbours %g", text, part->neighbours);
    json_number(j, "h", words_among(e->method->accepts, "h") ? o->h : NAN);
    json_text(j, "stepper", stepper_words[o->stepper]);
    describe_steps(e, plan, text, sizeof text);
    json_add(j, "stepper_why %s|dt %g|steps %lld|stages %d|steps_refined %d", text, part->run.dt, part->run.steps,
             part->run.stages, plan->refined);
    json_add(j, "updates %lld|interactions %lld|bytes %zu", part->run.cost.updates, part->run.cost.interactions,
             part->bytes[OUTLINE_STEPS]);
    json_add(j, "bytes_per_particle %g|bytes_peak %zu|peak %s",
             (double)part->bytes[OUTLINE_STEPS] / (double)part->run.n, part->bytes[plan_peak(plan)],
             plan_phases[plan_peak(plan)]);
    json_array(j, "arrays");
    for (int i = 0; i < part->count; i++) {
        json_object(j, NULL);
        json_add(j, "what %s|bytes %zu|held %s", part->array[i].what, part->array[i].bytes,
                 held(&part->array[i], text, sizeof text));
        json_end(j);
    }
    json_end(j);
}

int verb_plan(const struct request *r, struct failure *why) {
    struct plan plan;
    if (r->rungs.dx.count > 1 || r->rungs.dt.count > 1 || r->rungs.fourier.count > 1)
        return refuse(why, STATUS_INPUT, "plan takes one --dx, and one --dt or --fourier");
    if (plan_make(&r->experiment, PLAN_RUN, &plan, why)) return why->status;
    if (r->json) {
        struct json j = json_on(stdout);
        print_json(&r->experiment, &plan, &j);
        json_end(&j);
    } else {
        print_text(&r->experiment, &plan);
    }
    return STATUS_OK;
}
