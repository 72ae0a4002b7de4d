/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs of a ladder, one per rung. */
#include "verification/judge/ladder.h"

#include "solver/field.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/solve/results.h"
#include "verification/judge/inconclusive.h"
#include "verification/judge/judge.h"
#include "verification/judge/self_difference.h"
#include "verification/text/progress.h"
#include "verification/judge/run.h"
#include "verification/judge/semidiscrete.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* If the list increases, x is its inverse, which decreases. */
static int plan_vary(const struct ladder_rungs *r, struct ladder *l, struct failure *why) {
    if (r->dx.count > 1 || r->dt.count > 1 || r->fourier.count > 1)
        return refuse(why, STATUS_INPUT, "a ladder varies one quantity: use one --dx and one time step with --vary");
    if (r->vary.count < 2)
        return refuse(why, STATUS_INPUT, "a ladder needs at least two rungs: --vary NAME=A,B,C,...");
    l->n = r->vary.count;
    l->inverse = r->vary.value[1] > r->vary.value[0];
    for (int i = 0; i < l->n; i++) l->x[i] = l->inverse ? 1 / r->vary.value[i] : r->vary.value[i];
    for (int i = 0; i + 1 < l->n; i++)
        if (!(l->x[i + 1] < l->x[i]))
            return refuse(why, STATUS_INPUT,
                          "--vary: must be from coarsest to finest, increasing or decreasing throughout");
    return STATUS_OK;
}

/* Copies the list with several numbers to l->x, coarsest first. */
static int plan(const struct ladder_rungs *r, struct ladder *l, struct failure *why) {
    const struct numbers *steps = r->dt.count ? &r->dt : &r->fourier;
    const char *name = steps->count < 2 ? "dx" : r->dt.count ? "dt" : "fourier";
    if (r->vary.count) return plan_vary(r, l, why);
    if (r->dx.count > 1 && steps->count > 1)
        return refuse(why, STATUS_INPUT, "a ladder varies dx or the time step: use one --dx, or one --%s", name);
    if (r->dx.count < 2 && steps->count < 2)
        return refuse(why, STATUS_INPUT, "a ladder needs at least two rungs, and a gate %d: --dx A,B,C,...",
                      WINDOW_LEAST);
    l->in_time = steps->count > 1;
    const struct numbers *list = l->in_time ? steps : &r->dx;
    l->n = list->count;
    memcpy(l->x, list->value, sizeof l->x);
    number_sort_falling(l->x, l->n);
    for (int i = 0; i + 1 < l->n; i++)
        if (!(l->x[i + 1] < l->x[i])) return refuse(why, STATUS_INPUT, "--%s: %g is given twice", name, l->x[i]);
    return STATUS_OK;
}

static struct experiment rung_of(const struct experiment *e, const struct ladder_rungs *rungs, const struct ladder *l,
                                 int i) {
    struct experiment rung = *e;
    struct program *g = &rung.program;
    char value[40];
    results_number(l->x[i], value);
    if (rungs->vary.count) {
        results_number(rungs->vary.value[i], g->value);
        snprintf(g->rung, sizeof g->rung, "%s=%s", g->vary, g->value);
    } else if (!l->in_time) {
        rung.options.dx = l->x[i];
    } else if (rungs->dt.count) {
        rung.options.dt = l->x[i];
        snprintf(g->rung, sizeof g->rung, "dt=%s", value);
    } else {
        rung.options.fourier = l->x[i];
        snprintf(g->rung, sizeof g->rung, "fourier=%s", value);
    }
    return rung;
}

/* Storage for the field of a rung: kept for the two finest, for the diagnosis. */
static struct field *keep(struct field kept[2], int before_finest) {
    return before_finest < 2 ? &kept[before_finest] : NULL;
}

static struct result not_run(const struct experiment *rung) {
    struct result r = run_blank(rung);
    refuse(&r.failure, STATUS_NUMERICAL, "not run, because a coarser rung failed");
    return r;
}

/* External programs: coarsest rung first, one at a time for undisturbed timing; stop at the first failure.  Existing
 * answers are all read. */
static void climb_program(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l,
                          struct field kept[2]) {
    int failed = 0;
    for (int i = 0; i < l->n; i++) {
        struct experiment rung = rung_of(e, rungs, l, i);
        if (failed && e->program.solver)
            l->rung[i] = not_run(&rung);
        else
            failed = run_experiment(&rung, &l->rung[i], keep(kept, l->n - 1 - i)) || failed;
    }
}

/* Runs the rungs against the semi-discrete reference, or the exact solution if there is none. */
static void climb(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l,
                  const struct semidiscrete *reference, struct field kept[2]) {
    if (l->external) {
        climb_program(e, rungs, l, kept);
        return;
    }
    struct progress progress = progress_start("rungs", l->n);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < l->n; i++) {
        int finest_first = l->n - 1 - i;
        struct experiment rung = rung_of(e, rungs, l, finest_first);
        if (reference)
            run_against(&rung, reference->field.T, reference->error, &l->rung[finest_first]);
        else
            run_experiment(&rung, &l->rung[finest_first], keep(kept, i));
        progress_tick(&progress);
    }
    progress_end(&progress);
}

/* A refused rung refuses the ladder; a failed rung is reported in it. */
static int collect(struct ladder *l, struct failure *why) {
    for (int i = 0; i < l->n; i++) {
        const struct failure *f = &l->rung[i].failure;
        if (status_refused(f->status) && !l->external) {
            *why = *f;
            return f->status;
        }
        if (f->status && !l->failure.status) l->failure = *f;
        if (l->in_time && !f->status && !l->self_differences)
            l->x[i] = l->rung[i].dt; /* the number of steps is whole, so dt differs slightly from the request */
    }
    if (l->failure.status) *why = l->failure;
    return l->failure.status;
}

/* Without a semi-discrete reference.  A failed run leaves a ladder without errors. */
static int climb_without_reference(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l,
                                   struct failure *why) {
    struct experiment rung[RUNG_MAX], fine = *e;
    if (l->n < 3 && !(rungs->fine > 0))
        return refuse(
            why, STATUS_INPUT,
            "the time error of %s comes from successive runs: needs at least three time steps, %d for a gate",
            e->method->name, WINDOW_LEAST + 1);
    for (int i = 0; i < l->n; i++) {
        rung[i] = rung_of(e, rungs, l, i);
        l->rung[i] = not_run(&rung[i]);
    }
    fine.options.dt = l->fine = rungs->fine;
    char value[40];
    results_number(rungs->fine, value);
    snprintf(fine.program.rung, sizeof fine.program.rung, "dt=%s", value);
    int status = self_difference_climb(rung, rungs->fine > 0 ? &fine : NULL, l, why);
    int reported = l->external && l->rung[0].failure.status;
    return status_refused(status) && !reported ? status : STATUS_OK;
}

/* Measures each rung against the reference; without one the rungs fail.  Returns STATUS_INPUT with *why if it is
 * refused. */
static int climb_in_time(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l,
                         struct failure *why) {
    struct experiment finest = rung_of(e, rungs, l, l->n - 1);
    struct semidiscrete reference;
    if (!e->method->scheme || e->problem.k_law) return climb_without_reference(e, rungs, l, why);
    int status = semidiscrete_solve(&finest, &reference, why);
    if (status_refused(status)) return status;
    l->semidiscrete_steps = reference.steps;
    l->semidiscrete_error = reference.error;
    if (!status) climb(e, rungs, l, &reference, NULL);
    for (int i = 0; status && i < l->n; i++) {
        struct experiment rung = rung_of(e, rungs, l, i);
        l->rung[i] = run_blank(&rung);
        l->rung[i].failure = *why;
    }
    field_free(&reference.field);
    return STATUS_OK;
}

/* At round-off there is no order to fit; an exact code passes on its ceiling alone. */
static void judge_exact(const struct ladder_rungs *rungs, struct ladder *l) {
    int exact = 0;
    for (int i = 0; i < l->n; i++) exact += l->window.exact[i];
    if (l->window.n >= WINDOW_LEAST || !l->window.exact[l->n - 1] || l->failure.status) return;
    if (rungs->ceiling > 0) l->verdict = VERDICT_PASS;
    snprintf(l->reason, sizeof l->reason, "%d of %d rungs are at round-off, without an order%s", exact, l->n,
             rungs->ceiling > 0 ? "" : ": --ceiling E judges the error");
    if (rungs->ceiling > 0 && ladder_finest_error(l) <= rungs->ceiling)
        words_add(l->reason, sizeof l->reason, "; the error %.4g is below its ceiling %.4g", ladder_finest_error(l),
                  rungs->ceiling);
}

static void judge(const struct ladder_rungs *rungs, struct ladder *l) {
    if (rungs->scattered) l->window.scattered = 1;
    if (rungs->expect.count) {
        ladder_judge(l, rungs->expect.value[0], rungs->expect.value[1]);
        judge_exact(rungs, l);
    }
    if (!(rungs->ceiling > 0)) return;
    if (!rungs->expect.count && !l->failure.status) l->verdict = VERDICT_PASS, l->reason[0] = '\0';
    judge_ceiling(ladder_finest_error(l), rungs->ceiling, &l->verdict, l->reason, sizeof l->reason);
}

/* Error number `which` of a result. */
static double *error_of(struct result *r, int which) {
    double *const of[] = {&r->error.l1,    &r->error.l2,    &r->error.linf,
                          &r->interior.l1, &r->boundary.l1, &r->derived_error};
    return of[which];
}

/* Runs each rung once per seed; its errors become the geometric means. */
static void climb_draws(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l,
                        struct field kept[2]) {
    enum { ERRORS = 6 };
    enum ladder_norm norm = e->derived ? LADDER_QUANTITY : rungs->norm;
    struct result *sum = xcalloc(RUNG_MAX, sizeof *sum);
    l->draws = e->program.seeds;
    for (int k = 0, failed = 0; k < e->program.seeds && !failed; k++) {
        struct experiment one = *e;
        struct field other[2] = {{0}, {0}};
        one.program.seed = k + 1;
        one.options.seed = e->options.seed + (unsigned long)k;
        snprintf(one.program.rung, sizeof one.program.rung, "seed=%d", k + 1);
        climb(&one, rungs, l, NULL, k ? other : kept);
        for (int i = 0; i < l->n; i++) {
            l->draw[k][i] = ladder_error_in(&l->rung[i], norm);
            failed = failed || l->rung[i].failure.status;
            for (int n = 0; n < ERRORS; n++)
                *error_of(&sum[i], n) += log(*error_of(&l->rung[i], n)) / e->program.seeds;
        }
        for (int n = 0; n < 2; n++) field_free(&other[n]);
        if (failed) l->draws = 0;
    }
    for (int i = 0; i < l->n && l->draws; i++)
        for (int n = 0; n < ERRORS; n++) *error_of(&l->rung[i], n) = exp(*error_of(&sum[i], n));
    free(sum);
}

/* Draws differ only in a seed: that of a program, of a cloud, or of the lattice position under a round body. */
static int check_seeds(const struct experiment *e, const struct ladder *l, struct failure *why) {
    const struct options *o = &e->options;
    int cloud = o->layout == LAYOUT_JITTER || o->layout == LAYOUT_RELAXED;
    int lattice = e->problem.shape && !(o->has_origin && o->has_angle);
    if (l->in_time || l->vary[0])
        return refuse(why, STATUS_INPUT, "--seeds: only for a ladder in dx, not in a time step or a parameter");
    if (!l->external && !cloud && !lattice)
        return refuse(why, STATUS_INPUT,
                      "--seeds needs --solver, --results, --layout jitter or relaxed, or a round body; no other "
                      "input is random");
    return STATUS_OK;
}

int ladder_run(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l, struct failure *why) {
    double start = omp_get_wtime();
    struct field kept[2] = {{0}, {0}};
    *l = (struct ladder){.external = e->solve == run_program};
    if (plan(rungs, l, why)) return why->status;
    memcpy(l->vary, e->program.vary, sizeof l->vary);
    if (e->program.seeds > 1 && check_seeds(e, l, why)) return why->status;
    if (e->program.seeds > 1)
        climb_draws(e, rungs, l, kept);
    else if (!l->in_time)
        climb(e, rungs, l, NULL, kept);
    else if (climb_in_time(e, rungs, l, why))
        return why->status;
    int status = collect(l, why);
    if (!status_refused(status) || l->external) {
        ladder_fit(l, e->derived ? LADDER_QUANTITY : rungs->norm);
        judge(rungs, l);
        int judged = rungs->expect.count || rungs->ceiling > 0;
        int wanted = rungs->diagnose || (judged && l->verdict != VERDICT_PASS);
        l->diagnosed = wanted && !l->in_time && !l->vary[0] && !l->failure.status;
        struct inconclusive_noise noise = {0};
        if (l->diagnosed) diagnose_ladder(e, kept, l, &noise);
        l->noisy = noise.share > INCONCLUSIVE_NOISE;
        if (judged && l->diagnosed && l->external) inconclusive_judge(rungs, &noise, &kept[0], &e->program.map, l);
        l->seconds = omp_get_wtime() - start;
    }
    for (int k = 0; k < 2; k++) field_free(&kept[k]);
    return status;
}
