/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One run: scene -> field -> norms. */
#include "verification/judge/run.h"
#include "verification/solve/program.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/particles/particles.h"
#include "solver/time/stepper.h"
#include "verification/case/experiment.h"
#include "verification/judge/derived.h"
#include "verification/judge/time_step.h"

#include <float.h>
#include <math.h>
#include <omp.h>
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

static int solve(const struct experiment *e, struct result *out, struct field *f) {
    *out = run_blank(e);
    *f = (struct field){0};
    struct experiment used = *e;
    struct time_step stepping;
    if (used.options.mean == MEAN_AUTO)
        used.options.mean = used.problem.k_law            ? MEAN_KIRCHHOFF
                            : used.problem.resistance > 0 ? MEAN_SERIES
                                                          : MEAN_HARMONIC;
    int status = (e->external ? run_program : time_step_solve)(&used, f, &stepping, &out->failure);
    out->options = used.options;
    out->time_error = stepping.time_error;
    out->rounding = stepping.rounding;
    out->search_updates = stepping.updates;
    if (!status && f->h > 0) out->options.h = f->h;
    out->failure.status = status;
    return status;
}

/* Growth rate of the rows in use.  A run with a growing mode fails if its field has left the range of the data. */
static int measure_growth(const struct experiment *e, const struct field *f, struct result *out) {
    if (!e->growth) return STATUS_OK;
    if (particles_growth(e->method, &e->problem, &out->options, f, &out->growth, &out->failure))
        return out->failure.status;
    double lo = f->data[0], hi = f->data[1], slack = 1e-6 * (hi - lo);
    if (!result_grows(out) || (out->shape.min >= lo - slack && out->shape.max <= hi + slack)) return STATUS_OK;
    return refuse(&out->failure, STATUS_UNSTABLE,
                  "unstable: a mode grows at %.4g s^-1 at any step, %.3g times in %.6g s, and the temperatures, %.4g "
                  "to %.4g K, have left the data's range of [%.4g, %.4g] K; use less --jitter or another method",
                  out->growth, exp(out->growth * out->t_end), out->t_end, out->shape.min, out->shape.max, lo, hi);
}

int run_experiment(const struct experiment *e, struct result *out, struct field *field) {
    struct field f;
    if (solve(e, out, &f)) return out->failure.status;
    double *exact = xcalloc(f.n, sizeof *exact);
    out->reference_error = norms_exact(e->scene, &e->problem, &f, exact);
    int status = measure(e, &f, exact, out);
    if (!status) status = measure_growth(e, &f, out);
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
    if (solve(e, out, &f)) return out->failure.status;
    out->reference_error = error;
    double *own = memcpy(xcalloc(f.n, sizeof *own), reference, f.n * sizeof *own);
    int status = measure(e, &f, own, out);
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
        status = (e->external ? run_program : time_step_solve)(&again, &field, &ignored, why);
        field_free(&field);
    } while (!status && omp_get_wtime() - start < 0.1);
    return status;
}
