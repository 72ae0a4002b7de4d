/* A plan in words and as JSON. */
#include "verification/plan_print.h"

#include "references/scene.h"
#include "verification/json.h"
#include "verification/plan.h"
#include "verification/request.h"
#include "verification/words.h"

#include <math.h>
#include <stdio.h>

static const char *storage(const struct request *r, const struct plan *plan) {
    if (!r->method->scheme) return "one stencil for all points: a grid of one material";
    if (!plan->rows) return "one stencil for all particles: a lattice of one material, no neighbour list";
    return r->problem.materials == 2 ? "a row for each particle: two materials, so that pairs differ"
                                     : "a row for each particle: off the lattice each has its own neighbours";
}

static const char *steps_why(const struct plan *plan) {
    switch (plan->options.stepper) {
    case STEPPER_EXACT:
        return "exp(tA) in one pair of transforms: one stencil and walls that mirror";
    case STEPPER_MATCHED:
        return "the step whose own error cancels that of space";
    default:
        return plan->refined ? "refined until the time error is 1 %, from a first guess" : "as asked";
    }
}

void plan_print_text(const struct request *r, const struct plan *plan) {
    const struct options *o = &plan->options;
    static const char *const axis[] = {"x", "y"};
    double n = (double)plan->computed;
    printf("%s %s, dx = %g m\n", r->scene->name, r->method->name, o->dx);
    printf("  %-13s %d: %s\n", "dimension", plan->dim,
           plan->dim == 1 ? "a rod; nothing along y is stored" : "a rectangle");
    printf("  %-13s", "mirror planes");
    for (int d = 0; d < plan->dim; d++)
        if (plan->cut[d]) printf(" the middle of %s,", axis[d]);
    if (plan->cut[0] || plan->cut[1])
        printf(" one part is computed\n  %-13s %zu, of which %zu are computed\n", "particles", plan->particles,
               plan->computed);
    else
        printf(" none\n  %-13s %zu\n", "particles", plan->particles);
    printf("  %-13s %s\n", "weights", storage(r, plan));
    if (words_among(r->method->accepts, "h"))
        printf("  %-13s %.4g in the mean, within 2 h, h/dx = %.6g\n", "neighbours", plan->neighbours, o->h);
    else
        printf("  %-13s %.4g\n", "neighbours", plan->neighbours);
    printf("  %-13s %s: %s", "time", stepper_words[o->stepper], steps_why(plan));
    if (plan->steps)
        printf(", %lld of %.6g s, %d stage%s", plan->steps, plan->dt, plan->stages, plan->stages == 1 ? "" : "s");
    printf("\n  %-13s %lld updates, %lld interactions\n", "work", plan->updates, plan->interactions);
    printf("  %-13s %zu bytes, %.4g a particle\n", "memory", plan->bytes, (double)plan->bytes / n);
    for (int i = 0; i < plan->count; i++)
        printf("  %-13s %12zu  %s\n", "", plan->array[i].bytes, plan->array[i].what);
}

void plan_print_json(const struct request *r, const struct plan *plan, struct json *j) {
    const struct options *o = &plan->options;
    json_text(j, "scene", r->scene->name);
    json_text(j, "method", r->method->name);
    json_number(j, "dx", o->dx);
    json_whole(j, "dimension", plan->dim);
    json_array(j, "mirror_planes");
    for (int d = 0; d < plan->dim; d++)
        if (plan->cut[d]) json_text(j, NULL, d ? "y" : "x");
    json_end(j);
    json_whole(j, "particles", (long long)plan->particles);
    json_text(j, "weights", plan->rows ? "rows" : "stencil");
    json_text(j, "weights_why", storage(r, plan));
    json_number(j, "neighbours", plan->neighbours);
    json_number(j, "h", words_among(r->method->accepts, "h") ? o->h : NAN);
    json_text(j, "stepper", stepper_words[o->stepper]);
    json_text(j, "stepper_why", steps_why(plan));
    json_number(j, "dt", plan->dt);
    json_whole(j, "steps", plan->steps);
    json_whole(j, "stages", plan->stages);
    json_whole(j, "steps_refined", plan->refined);
    json_whole(j, "updates", plan->updates);
    json_whole(j, "interactions", plan->interactions);
    json_whole(j, "bytes", (long long)plan->bytes);
    json_number(j, "bytes_per_particle", (double)plan->bytes / (double)plan->particles);
    json_array(j, "arrays");
    for (int i = 0; i < plan->count; i++) {
        json_object(j, NULL);
        json_text(j, "what", plan->array[i].what);
        json_whole(j, "bytes", (long long)plan->array[i].bytes);
        json_end(j);
    }
    json_end(j);
}
