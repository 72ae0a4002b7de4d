/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A result as JSON and as a line of text.  Options without meaning for the method are null, so a table shows no
 * kernel for finite differences. */
#include "verification/judge/result.h"

#include "solver/words.h"
#include "references/scene.h"
#include "verification/text/json.h"

#include <math.h>
#include <stdio.h>

int result_accepts(const struct result *r, const char *option) {
    return words_among(r->method->accepts, option);
}

int result_grows(const struct result *r) {
    return r->growth * r->t_end > M_LN2;
}

void result_warn(const struct result *r) {
    if (!result_grows(r)) return;
    fprintf(stderr,
            "heatladder: warning: dx = %g m: a mode grows at %.4g s^-1 at any time step, %.3g times in %.6g s; the "
            "error may be that of this mode: use less --jitter or another method\n",
            r->options.dx, r->growth, exp(r->growth * r->t_end), r->t_end);
}

static void options_json(const struct result *r, struct json *j) {
    const struct options *o = &r->options;
    json_text(j, "kernel", result_accepts(r, "kernel") ? kernel_words[o->kernel] : NULL);
    json_number(j, "h", o->h > 0 ? o->h : NAN);
    json_number(j, "order", result_accepts(r, "order") && o->order ? (double)o->order : NAN);
    json_text(j, "stepper", result_accepts(r, "stepper") ? stepper_words[o->stepper] : NULL);
    json_text(j, "layout", result_accepts(r, "layout") ? layout_words[o->layout] : NULL);
    json_number(j, "jitter", o->layout == LAYOUT_JITTER ? o->jitter : 0);
    json_whole(j, "seed", (long long)o->seed);
    json_text(j, "sampling", result_accepts(r, "sampling") ? sampling_words[o->sampling] : NULL);
    json_text(j, "walls", result_accepts(r, "walls") ? walls_words[o->walls] : NULL);
    json_text(j, "mean", result_accepts(r, "mean") ? mean_words[o->mean] : NULL);
    json_text(j, "cross", result_accepts(r, "cross") ? cross_words[o->cross] : NULL);
    json_text(j, "domain", domain_words[o->domain]);
    json_text(j, "volume", result_accepts(r, "volume") ? volume_words[o->volume] : NULL);
}

static void errors_json(const struct result *r, struct json *j) {
    for (int k = 0; k < NORM_QUANTITY; k++) json_number(j, norm_keys[k], r->error[k]);
    json_whole(j, "left_out_points", (long long)r->left_out);
    if (r->derived_name) {
        json_add(j, "quantity_name %s|quantity %g|quantity_exact %g|quantity_error %g", r->derived_name, r->derived,
                 r->derived_exact, r->error[NORM_QUANTITY]);
    }
}

static void shape_json(const struct result *r, struct json *j) {
    json_add(j, "min [K] %g|max [K] %g|overshoot [K] %g|undershoot [K] %g|variation [K] %g", r->shape.min,
             r->shape.max, r->shape.overshoot, r->shape.undershoot, r->shape.variation);
    json_number(j, "checkerboard [K]", r->shape.checkerboard);
    json_number(j, "heat_drift", r->heat_drift);
}

void result_json(const struct result *r, struct json *j) {
    json_add(j, "scene %s|method %s", r->scene->name, r->method->name);
    options_json(r, j);
    json_number(j, "dx [m]", r->options.dx);
    json_text(j, "failure", r->failure.status ? r->failure.text : NULL);
    if (r->failure.status) {
        json_number(j, "error_l1", NAN);
        return;
    }
    json_add(j, "dt [s] %g|fourier %g|steps %lld|stages %d", r->dt, r->fourier, r->steps, r->stages);
    json_number(j, "saving_over_euler", r->saving);
    json_add(j, "t_end [s] %g|particles %zu", r->t_end, r->particles);
    errors_json(r, j);
    json_add(j, "time_error %g|growth [1/s] %g|reference_error %g", r->time_error, r->growth, r->reference_error);
    shape_json(r, j);
    json_add(j, "seconds %g|step_seconds %g|updates %lld|search_updates %lld|interactions %lld", r->cost.seconds,
             r->cost.step_seconds, r->cost.updates, r->search_updates, r->cost.interactions);
    json_add(j, "work %g|bytes %zu", r->cost.work, r->cost.bytes);
}

void result_describe(const struct result *r, char *text, size_t size) {
    const struct options *o = &r->options;
    char kernel[64] = "", jitter[48] = "";
    if (!*r->method->accepts) {
        snprintf(text, size, "%s %s: %s, t = %g s", r->scene->name, r->method->name, r->method->about, r->t_end);
        return;
    }
    if (result_accepts(r, "kernel")) {
        char h[24] = ""; /* a refused run has no value of h */
        if (o->h > 0) snprintf(h, sizeof h, ", h/dx %g", o->h);
        snprintf(kernel, sizeof kernel, "%s kernel%s, ", kernel_words[o->kernel], h);
    }
    if (o->layout == LAYOUT_JITTER) snprintf(jitter, sizeof jitter, " %g (seed %lu)", o->jitter, o->seed);
    if (o->layout == LAYOUT_RELAXED) snprintf(jitter, sizeof jitter, " (seed %lu)", o->seed);
    snprintf(text, size, "%s %s: %s%s%s, %s samples, %s walls, %s in time, t = %g s", r->scene->name, r->method->name,
             kernel, layout_words[o->layout], jitter, sampling_words[o->sampling], walls_words[o->walls],
             stepper_words[o->stepper], r->t_end);
}
