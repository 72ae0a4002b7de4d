/* A plan in words and as JSON. */
#include "verification/choose/plan_print.h"

#include "references/scene.h"
#include "verification/text/json.h"
#include "verification/choose/plan.h"
#include "verification/run/experiment.h"
#include "verification/run/time_step.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>

static void describe_storage(const struct experiment *e, const struct plan *plan, char *text, size_t size) {
    const char *what = !e->method->scheme ? "one stencil for all points: a grid of one material"
                       : !plan->rows ? "one stencil for all particles: a lattice of one material, no neighbour list"
                       : e->problem.materials == 2
                           ? "a row for each particle: two materials, so that pairs differ"
                           : "a row for each particle: off the lattice each has its own neighbours";
    int used = snprintf(text, size, "%s", what);
    if (plan->stand_in > 0)
        snprintf(text + used, size - (size_t)used, "; estimated from those at dx = %g m", plan->stand_in);
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
    if (e->time_error > 0) snprintf(until, sizeof until, "the longest whose time error is %g", e->time_error);
    if (plan->options.stepper == STEPPER_EXACT)
        snprintf(text, size, "exp(tA) in one pair of transforms: one stencil and walls that mirror");
    else if (plan->options.stepper == STEPPER_MATCHED)
        snprintf(text, size, "the step whose own error cancels that of space");
    else if (!plan->refined)
        snprintf(text, size, "as asked");
    else if (f->steps == 0)
        snprintf(text, size, "%s; no coarser run foretells how many, so this is where the search begins", until);
    else if (f->runs == 1)
        snprintf(text, size, "%s; found by the search itself", until);
    else
        snprintf(text, size, "%s; foretold from runs at dx = %g and %g m", until, f->dx[0], f->dx[1]);
}

/* From the first to the last phase that an array is held in. */
static const char *held(const struct plan_array *a, char *text, size_t size) {
    snprintf(text, size, a->from == a->to ? "%s" : "%s to %s", plan_phases[a->from], plan_phases[a->to]);
    return text;
}

void plan_print_text(const struct experiment *e, const struct plan *plan) {
    const struct options *o = &plan->options;
    static const char *const axis[] = {"x", "y"};
    char text[240];
    enum plan_phase peak = plan_peak(plan);
    printf("%s %s, dx = %g m\n", e->scene->name, e->method->name, o->dx);
    printf("  %-13s %d: %s\n", "dimension", plan->dim,
           plan->dim == 1 ? "a rod; nothing along y is stored" : "a rectangle");
    for (int d = 0; d < plan->dim; d++)
        printf("  %-13s the middle of %s: %s\n", d ? "" : "mirror planes", axis[d],
               plan->cut[d] ? "half is computed" : uncut(e, plan, d));
    printf("  %-13s %zu", "particles", plan->particles);
    if (plan->computed < plan->particles) printf(", of which %zu are computed", plan->computed);
    describe_storage(e, plan, text, sizeof text);
    printf("\n  %-13s %s\n", "weights", text);
    if (words_among(e->method->accepts, "h"))
        printf("  %-13s %.4g in the mean, within 2 h, h/dx = %.6g\n", "neighbours", plan->neighbours, o->h);
    else
        printf("  %-13s %.4g\n", "neighbours", plan->neighbours);
    describe_steps(e, plan, text, sizeof text);
    printf("  %-13s %s: %s", "time", stepper_words[o->stepper], text);
    if (plan->steps)
        printf(", %lld of %.6g s, %d stage%s", plan->steps, plan->dt, plan->stages, plan->stages == 1 ? "" : "s");
    printf("\n  %-13s %lld updates, %lld interactions%s\n", "work", plan->updates, plan->interactions,
           plan->refined ? ", and the runs of the search" : "");
    printf("  %-13s %zu bytes while time runs, %.4g for each particle that is computed; at most %zu (%s)\n", "memory",
           plan->bytes[PLAN_STEPS], (double)plan->bytes[PLAN_STEPS] / (double)plan->computed, plan->bytes[peak],
           plan_phases[peak]);
    for (int i = 0; i < plan->count; i++)
        printf("  %-13s %12zu  %s (%s)\n", "", plan->array[i].bytes, plan->array[i].what,
               held(&plan->array[i], text, sizeof text));
}

void plan_print_json(const struct experiment *e, const struct plan *plan, struct json *j) {
    const struct options *o = &plan->options;
    char text[240];
    json_text(j, "scene", e->scene->name);
    json_text(j, "method", e->method->name);
    json_number(j, "dx", o->dx);
    json_whole(j, "dimension", plan->dim);
    json_array(j, "mirror_planes");
    for (int d = 0; d < plan->dim; d++)
        if (plan->cut[d]) json_text(j, NULL, d ? "y" : "x");
    json_end(j);
    json_whole(j, "particles", (long long)plan->particles);
    json_whole(j, "particles_computed", (long long)plan->computed);
    json_text(j, "weights", plan->rows ? "rows" : "stencil");
    describe_storage(e, plan, text, sizeof text);
    json_text(j, "weights_why", text);
    json_number(j, "neighbours", plan->neighbours);
    json_number(j, "h", words_among(e->method->accepts, "h") ? o->h : NAN);
    json_text(j, "stepper", stepper_words[o->stepper]);
    describe_steps(e, plan, text, sizeof text);
    json_text(j, "stepper_why", text);
    json_number(j, "dt", plan->dt);
    json_whole(j, "steps", plan->steps);
    json_whole(j, "stages", plan->stages);
    json_whole(j, "steps_refined", plan->refined);
    json_whole(j, "updates", plan->updates);
    json_whole(j, "interactions", plan->interactions);
    json_whole(j, "bytes", (long long)plan->bytes[PLAN_STEPS]);
    json_number(j, "bytes_per_particle", (double)plan->bytes[PLAN_STEPS] / (double)plan->computed);
    json_whole(j, "bytes_peak", (long long)plan->bytes[plan_peak(plan)]);
    json_text(j, "peak", plan_phases[plan_peak(plan)]);
    json_array(j, "arrays");
    for (int i = 0; i < plan->count; i++) {
        json_object(j, NULL);
        json_text(j, "what", plan->array[i].what);
        json_whole(j, "bytes", (long long)plan->array[i].bytes);
        json_text(j, "held", held(&plan->array[i], text, sizeof text));
        json_end(j);
    }
    json_end(j);
}
