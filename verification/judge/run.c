/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One run: scene -> field -> norms; its result as text; the run of a command line. */
#include "verification/judge/run.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/particles/particles.h"
#include "solver/time/stepper.h"
#include "solver/words.h"
#include "verification/case/experiment.h"
#include "verification/judge/derived.h"
#include "verification/judge/time_step.h"
#include "verification/solve/program.h"
#include "verification/text/json.h"

#include <float.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Heat and temperatures round like the field.  A gradient divides differences of T by dx, while a flux is of the
 * size of k T over the extent, so its rounding is extent/dx times larger. */
static double derived_rounding(const struct experiment *e, const struct result *r) {
    const struct problem *p = &e->problem;
    double extent = 0;
    for (int a = 0; a < p->dim; a++) extent = fmax(extent, p->hi[a] - p->lo[a]);
    return r->rounding * (e->quantity.kind == QUANTITY_FLUX ? extent / r->options.dx : 1);
}

static int measure_derived(const struct experiment *e, const struct field *f, struct result *out) {
    out->derived_name = e->derived;
    if (!e->derived) return STATUS_OK;
    struct quantity_value exact = quantity_exact(&e->quantity, e->scene, &e->problem, f->time);
    if (exact.no_value)
        return refuse(&out->failure, STATUS_INPUT,
                      "--quantity %.60s: has no finite value, since two adjacent sides have different temperatures",
                      e->derived);
    int status = derived_value(&e->quantity, &e->problem, f, out->options.dx, &out->derived, &out->failure);
    double size = exact.value != 0 ? fabs(exact.value) : 1;
    out->derived_exact = exact.value;
    out->error[NORM_QUANTITY] = fabs(out->derived - exact.value) / size;
    out->derived_bound = exact.error_bound / size;
    out->derived_rounding = derived_rounding(e, out);
    return status;
}

/* Overwrites `reference`. */
static int measure(const struct experiment *e, const struct field *f, double *reference, struct result *out) {
    const struct problem *p = &e->problem;
    if (norms_check(f, reference, &out->failure)) return STATUS_INPUT;
    double dx = out->options.dx;
    out->t_end = f->time;
    out->dt = f->dt;
    out->fourier = f->dt * problem_diffusivity(p) / (dx * dx);
    out->steps = f->steps;
    out->stages = f->stages;
    /* Euler is stable for dt <= 2 / bound */
    const struct stepper *stepper = stepper_of(out->options.stepper);
    int staged = stepper && stepper->order && stepper->count;
    out->saving =
        staged && f->bound > 0 && f->applications > 0 ? f->bound * p->t_end / 2 / (double)f->applications : NAN;
    out->particles = f->n;
    double skin = INFINITY;
    for (int a = 0; a < p->dim; a++) skin = fmin(skin, (p->hi[a] - p->lo[a]) / 10);
    unsigned char *near = norms_near(p, f, skin);
    norms_all(f, reference, near, out->error);
    free(near);
    out->left_out = norms_left_out(f, reference);
    if (!isfinite(out->error[NORM_L1]))
        return refuse(&out->failure, STATUS_NUMERICAL, "E1 = %g: temperature errors of up to %g K",
                      out->error[NORM_L1], out->error[NORM_LINF]);
    if (measure_derived(e, f, out)) return out->failure.status;
    out->shape = norms_shape(p, f, reference);
    out->heat_drift = norms_heat_drift(f);
    out->cost = f->cost;
    return STATUS_OK;
}

struct result run_blank(const struct experiment *e) {
    return (struct result){.scene = e->scene,
                           .method = e->method,
                           .options = e->options,
                           .t_end = e->problem.t_end,
                           .time_error = NAN,
                           .growth = NAN};
}

/* rows: shared by the runs of the search for a time step, and by the search for growing modes; the caller frees
 * them. */
static int solve(const struct experiment *e, struct assembled *rows, struct result *out, struct field *f) {
    *out = run_blank(e);
    *f = (struct field){0};
    struct experiment used = *e;
    struct time_step stepping;
    *rows = (struct assembled){0};
    used.options.assembled = rows;
    if (used.options.mean == MEAN_AUTO)
        used.options.mean = used.problem.k_law            ? MEAN_KIRCHHOFF
                            : used.problem.resistance > 0 ? MEAN_SERIES
                                                          : MEAN_HARMONIC;
    int status = (e->external ? run_program : time_step_solve)(&used, f, &stepping, &out->failure);
    out->options = used.options;
    out->options.assembled = NULL;
    out->time_error = stepping.time_error;
    out->rounding = stepping.rounding;
    out->search_updates = stepping.updates;
    if (!status && f->h > 0) out->options.h = f->h;
    out->failure.status = status;
    return status;
}

/* Growth rate of the rows in use.  A run with a growing mode fails if its field has left the range of the data. */
static int measure_growth(const struct experiment *e, struct assembled *rows, const struct field *f,
                          struct result *out) {
    if (!e->growth) return STATUS_OK;
    struct options with = out->options;
    with.assembled = rows;
    if (particles_growth(e->method, &e->problem, &with, &out->growth, &out->failure)) return out->failure.status;
    double lo = f->data[0], hi = f->data[1], slack = 1e-6 * (hi - lo);
    if (!result_grows(out) || (out->shape.min >= lo - slack && out->shape.max <= hi + slack)) return STATUS_OK;
    return refuse(&out->failure, STATUS_UNSTABLE,
                  "unstable: a mode grows at %.4g s^-1 at any step, %.3g times in %.6g s, and the temperatures, %.4g "
                  "to %.4g K, have left the data's range of [%.4g, %.4g] K; use less --jitter or another method",
                  out->growth, exp(out->growth * out->t_end), out->t_end, out->shape.min, out->shape.max, lo, hi);
}

int run_experiment(const struct experiment *e, struct result *out, struct field *field) {
    struct field f;
    struct assembled rows;
    if (solve(e, &rows, out, &f)) {
        particles_free_assembled(&rows);
        return out->failure.status;
    }
    double *exact = xcalloc(f.n, sizeof *exact);
    out->reference_error = norms_exact(e->scene, &e->problem, &f, exact);
    int status = measure(e, &f, exact, out);
    if (!status) status = measure_growth(e, &rows, &f, out);
    particles_free_assembled(&rows);
    free(exact);
    if (field && !status)
        *field = f;
    else
        field_free(&f);
    return status;
}

/* The temperatures of the case, scale |T| + |offset| on average, over those of the scene in the same scale. */
static double magnified(const struct mapping *m, const struct field *f) {
    double size = 0;
    for (size_t i = 0; i < f->n; i++) size += mapping_scale(m) * fabs(f->T[i]) / (double)f->n;
    return size > 0 ? 1 + fabs(m->offset) / size : 1;
}

int run_program(struct experiment *e, struct field *f, struct time_step *step, struct failure *why) {
    double weights = time_step_weights(e);
    *step = (struct time_step){.time_error = NAN};
    int status = program_solve(&e->program, e->scene, &e->problem, &e->options, f, why);
    if (status) return status;
    double steps = fmin((double)f->steps * (f->stages > 0 ? f->stages : 1), weights * weights);
    step->rounding = DBL_EPSILON * (1 + sqrt(steps) + weights) * magnified(&e->program.map, f);
    return STATUS_OK;
}

int run_against(const struct experiment *e, const double *reference, double error, struct result *out) {
    struct field f;
    struct assembled rows;
    int status = solve(e, &rows, out, &f);
    particles_free_assembled(&rows);
    if (status) return status;
    out->reference_error = error;
    double *own = memcpy(xcalloc(f.n, sizeof *own), reference, f.n * sizeof *own);
    status = measure(e, &f, own, out);
    free(own);
    field_free(&f);
    return status;
}

int run_warm_up(const struct experiment *e, struct failure *why) {
    double start = omp_get_wtime();
    struct time_step ignored;
    int status;
    do {
        struct experiment again = *e;
        struct field field = {0};
        struct assembled rows = {0};
        again.options.assembled = &rows;
        status = (e->external ? run_program : time_step_solve)(&again, &field, &ignored, why);
        particles_free_assembled(&rows);
        field_free(&field);
    } while (!status && omp_get_wtime() - start < 0.1);
    return status;
}

/* ---- Results ---- */

/* Options without meaning for the method are null, so a table shows no kernel for finite differences. */

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

/* ---- Commands ---- */

static int read_list(struct command_run *run, const char *format, va_list arguments) {
    *run = (struct command_run){0};
    struct failure *why = &run->result.failure;
    int length = vsnprintf(run->command, sizeof run->command, format, arguments);
    if (length < 0 || (size_t)length >= sizeof run->command)
        return refuse(why, STATUS_INPUT, "the command '%.60s...' is too long", run->command);
    return command_read(run->command, &run->typed, why);
}

int command_run_list(struct command_run *run, const char *format, va_list arguments) {
    int status = read_list(run, format, arguments);
    return status || strcmp(run->typed.syntax->name, "run") != 0 ? status : command_run_solve(run);
}

int command_run_read(struct command_run *run, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int status = read_list(run, format, arguments);
    va_end(arguments);
    return status;
}

int command_run_solve(struct command_run *run) {
    return run_experiment(&run->typed.experiment, &run->result, &run->field);
}

int command_run_line(struct command_run *run, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int status = command_run_list(run, format, arguments);
    va_end(arguments);
    return status;
}

int command_run_check(const struct command_run *run, struct failure *why) {
    const struct failure *failure = &run->result.failure;
    if (!failure->status) return STATUS_OK;
    return refuse(why, failure->status, "heatladder %.100s: %.300s", run->command, failure->text);
}

int command_run_note(const struct command_run *run, struct failure *any) {
    struct failure why;
    int status = command_run_check(run, &why);
#pragma omp critical(command_run_note)
    if (status) *any = why;
    return status;
}

double command_run_error(const struct command_run *run, int decimals, double late) {
    const struct experiment *e = &run->typed.experiment;
    const struct field *f = &run->field;
    double apart = 0, whole = 0, unit = pow(10, -decimals), t = f->time + late;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX], w = f->weight ? f->weight[i] : 1;
        field_place(f, i, x);
        double T = e->scene->published ? e->scene->published(&e->problem, x, t) : command_run_exact(run, x, t);
        if (decimals) T = unit * round(T / unit);
        apart += w * fabs(f->T[i] - T);
        whole += w * fabs(T);
    }
    return apart / whole;
}

double command_run_exact(const struct command_run *run, const double x[2], double t) {
    return scene_exact(run->typed.experiment.scene, &run->typed.experiment.problem, x, t).temperature;
}

void command_run_free(struct command_run *run) {
    field_free(&run->field);
    command_free(&run->typed);
}
