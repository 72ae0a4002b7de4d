/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ladder: row -> runs -> errors -> slope -> verdict.
 *
 * Each rung is one run, or one per draw of --seeds.  Its error is relative to the exact solution; of a ladder in
 * time to the particles' semi-discrete equations, or to another run of the ladder. */
#include "verification/judge/ladder.h"

#include "solver/field.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/results.h"
#include "verification/judge/self_difference.h"
#include "verification/text/progress.h"
#include "verification/judge/run.h"
#include "verification/judge/time_step.h"

#include <float.h>
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

/* ---- The climb ---- */

struct climb {
    const struct experiment *e;
    const struct ladder *l;
    int draws, runs;                /* how many, and the runs of each: the rungs, and last that of --fine */
    int keeps;                      /* fields kept of the first draw: those of so many finest runs */
    int differences;                /* 1: each run is the reference of another */
    struct semidiscrete *reference; /* owned; NULL: the exact solution */
    struct failure failure;         /* why there is no reference */
    struct result *result;          /* owned, [draws][runs] */
    struct field *field;            /* owned, [runs]; n = 0: not kept */
};

static struct experiment run_of(const struct climb *c, int draw, int i) {
    struct experiment run = *c->e;
    struct program *g = &run.program;
    const struct ladder_rungs *asked = &c->l->asked;
    char value[40];
    results_number(c->l->x[i], value);
    if (c->l->draws) {
        g->seed = draw + 1;
        run.options.seed += (unsigned long)draw;
        snprintf(g->rung, sizeof g->rung, "seed=%d", draw + 1);
    }
    if (asked->vary.count) {
        results_number(asked->vary.value[i], g->value);
        snprintf(g->rung, sizeof g->rung, "%s=%s", g->vary, g->value);
    } else if (!c->l->in_time) {
        run.options.dx = c->l->x[i];
    } else if (asked->dt.count) {
        run.options.dt = c->l->x[i];
        snprintf(g->rung, sizeof g->rung, "dt=%s", value);
    } else {
        run.options.fourier = c->l->x[i];
        snprintf(g->rung, sizeof g->rung, "fourier=%s", value);
    }
    return run;
}

/* instead: the failure of a run that is not done; NULL: it is. */
static int climb_run(const struct climb *c, int draw, int i, const struct failure *instead) {
    struct experiment run = run_of(c, draw, i);
    struct result *r = &c->result[draw * c->runs + i];
    if (instead) {
        *r = run_blank(&run);
        r->failure = *instead;
    } else if (c->reference) {
        run_against(&run, c->reference->field.T, c->reference->error, r);
    } else {
        run_experiment(&run, r, draw == 0 && i >= c->runs - c->keeps ? &c->field[i] : NULL);
    }
    return r->failure.status;
}

/* Ours: the finest run first, in parallel.  A program: the coarsest first, one at a time for undisturbed timing, up
 * to the first failure; existing answers are all read. */
static void climb(const struct climb *c) {
    const int all = c->draws * c->runs, ours = !c->l->external;
    struct failure stopped;
    const struct failure *instead = c->failure.status ? &c->failure : NULL;
    refuse(&stopped, STATUS_NUMERICAL, "not run, because a coarser rung failed");
    struct progress progress = progress_start("rungs", ours ? all : 0);
#pragma omp parallel for schedule(dynamic, 1) if (ours)
    for (int k = 0; k < all; k++) {
        int i = k % c->runs, failed = climb_run(c, k / c->runs, ours ? c->runs - 1 - i : i, instead);
        if (failed && c->e->program.solver) instead = &stopped;
        if (ours) progress_tick(&progress);
    }
    progress_end(&progress);
}

/* ---- From runs to rungs ---- */

/* The errors of a rung become the geometric means of its draws; a draw that failed is shown in their place. */
static void pool(const struct climb *c, struct ladder *l) {
    enum norm norm = c->e->derived ? NORM_QUANTITY : l->asked.norm;
    int shown = c->draws - 1, failed = 0;
    for (int k = 0; k < c->draws * c->runs && !failed; k++)
        if (c->result[k].failure.status) shown = k / c->runs, failed = 1;
    memcpy(l->rung, &c->result[shown * c->runs], (size_t)l->n * sizeof *l->rung);
    if (failed) l->draws = 0;
    for (int i = 0; i < l->n && l->draws; i++) {
        double mean[NORM_QUANTITY + 1] = {0};
        for (int k = 0; k < l->draws; k++) {
            const struct result *r = &c->result[k * c->runs + i];
            l->draw[k][i] = ladder_error_in(r, norm);
            for (int n = 0; n <= NORM_QUANTITY; n++) mean[n] += log(r->error[n]) / l->draws;
        }
        for (int n = 0; n <= NORM_QUANTITY; n++) l->rung[i].error[n] = exp(mean[n]);
    }
}

/* A refused run refuses the ladder; a failed one is reported in it. */
static int note_failures(const struct climb *c, struct ladder *l, struct failure *why) {
    for (int k = 0; k < c->draws * c->runs; k++) {
        const struct failure *f = &c->result[k].failure;
        if (f->status && !l->failure.status) l->failure = *f;
        if (status_refused(f->status) && !l->external) l->failure = *f;
        if (status_refused(l->failure.status)) break;
    }
    if (l->failure.status) *why = l->failure;
    return l->failure.status;
}

/* Possible share of rounding in the difference of two runs: each has its own, and where a program adds up its clock,
 * N steps of eps each. */
static double rounding_of_steps(const struct climb *c, const double *dt, int i) {
    int of = c->l->fine > 0 ? c->runs - 1 : i + 1;
    double sum = 0;
    if (of == c->runs) return 0; /* the finest is no rung */
    for (int k = 0; k < 2; k++) {
        int run = k ? of : i;
        sum += c->result[run].rounding + (c->l->external ? DBL_EPSILON * c->e->problem.t_end / dt[run] : 0);
    }
    return sum;
}

/* The number of steps is whole, so dt differs slightly from the request. */
static int measure_in_time(const struct climb *c, struct ladder *l, struct failure *why) {
    double dt[RUNG_MAX + 1];
    for (int i = 0; i < c->runs; i++) {
        const struct result *r = &c->result[i];
        dt[i] = r->dt > 0 ? r->dt : l->x[i];
        if (!r->failure.status) l->x[i] = dt[i];
        for (int n = 0; n < NORM_QUANTITY && c->differences && i < l->n; n++) l->rung[i].error[n] = NAN;
    }
    if (!c->differences || l->failure.status) return STATUS_OK;
    for (int i = 0; i < l->n; i++) l->rung[i].rounding = rounding_of_steps(c, dt, i);
    if (l->fine > 0)
        l->fine = dt[l->n];
    else
        l->n--; /* the finest run is a reference alone */
    return self_difference_errors(&c->e->problem, c->field, dt, l, why);
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

/* A ladder in time has the particles' semi-discrete equations as its reference, or runs of its own. */
static int choose_reference(struct climb *c, struct ladder *l, struct semidiscrete *semidiscrete,
                            struct failure *why) {
    const struct experiment *e = c->e;
    if (!l->in_time) {
        c->keeps = l->vary[0] ? 0 : 2;
        return STATUS_OK;
    }
    if (e->method->scheme && !e->problem.k_law) {
        struct experiment finest = run_of(c, 0, l->n - 1);
        int status = semidiscrete_solve(&finest, semidiscrete, &c->failure);
        if (status)
            *why = c->failure;
        else
            c->failure = (struct failure){0};
        l->semidiscrete_steps = semidiscrete->steps;
        l->semidiscrete_error = semidiscrete->error;
        c->reference = semidiscrete;
        return status_refused(status) ? status : STATUS_OK;
    }
    if (l->n < 3 && !(l->asked.fine > 0))
        return refuse(
            why, STATUS_INPUT,
            "the time error of %s comes from successive runs: needs at least three time steps, %d for a gate",
            e->method->name, WINDOW_LEAST + 1);
    l->fine = l->asked.fine;
    if (l->fine > 0) l->x[c->runs++] = l->fine;
    c->keeps = c->runs;
    c->differences = 1;
    return STATUS_OK;
}

/* Runs the rungs and sets their errors.  The two finest fields go to l->kept. */
static int climb_ladder(const struct experiment *e, struct ladder *l, struct failure *why) {
    struct climb c = {.e = e, .l = l, .draws = l->draws ? l->draws : 1, .runs = l->n};
    struct semidiscrete semidiscrete = {0};
    int status = choose_reference(&c, l, &semidiscrete, why);
    if (!status) {
        c.result = xcalloc((size_t)(c.draws * c.runs), sizeof *c.result);
        c.field = xcalloc((size_t)c.runs, sizeof *c.field);
        climb(&c);
        pool(&c, l);
        status = note_failures(&c, l, why);
        if (l->in_time && (!status_refused(status) || l->external) && measure_in_time(&c, l, why))
            status = why->status;
    }
    for (int i = 0; i < c.runs && c.field; i++) {
        int before_finest = l->n - 1 - i;
        if (!l->in_time && c.field[i].n)
            l->kept[before_finest] = c.field[i];
        else
            field_free(&c.field[i]);
    }
    field_free(&semidiscrete.field);
    free(c.result);
    free(c.field);
    return status;
}

/* ---- The ladder ---- */

/* Repeats the rung before the finest, to measure how far the answers of a program differ between runs, and counts
 * the digits that it prints. */
static void question(const struct experiment *e, struct ladder *l) {
    struct experiment again = *e;
    const struct result *first = &l->rung[l->n - 2];
    struct result result;
    struct field f = {0};
    double apart[NORM_QUANTITY];
    enum norm norm = l->norm == NORM_LINF ? NORM_LINF : NORM_L1;
    if (l->norm != NORM_QUANTITY && l->kept[0].n)
        l->printed = norms_digits(&l->kept[0], &e->program.map, &l->digits) / l->rung[l->n - 1].error[NORM_L1];
    if (!e->program.solver || !l->kept[1].n) return;
    again.options.dx = l->x[l->n - 2];
    again.program.keep = NULL;
    again.program.diagnosis = 1;
    if (!run_experiment(&again, &result, &f) && self_difference_fields(&e->problem, &l->kept[1], &f, apart)) {
        l->noise.apart = apart[NORM_LINF];
        l->noise.finest = norm == NORM_LINF ? apart[norm] : apart[norm] / sqrt(2);
        l->noise.share = l->noise.finest / first->error[norm];
    }
    field_free(&f);
}

int ladder_run(const struct experiment *e, const struct ladder_rungs *rungs, struct ladder *l, struct failure *why) {
    double start = omp_get_wtime();
    *l = (struct ladder){.asked = *rungs, .external = e->external};
    if (plan(rungs, l, why)) return why->status;
    memcpy(l->vary, e->program.vary, sizeof l->vary);
    if (e->program.seeds > 1 && check_seeds(e, l, why)) return why->status;
    l->draws = e->program.seeds > 1 ? e->program.seeds : 0;
    int status = climb_ladder(e, l, why);
    if (status_refused(status) && !(l->external && l->failure.status)) return status;
    ladder_fit(l, e->derived ? NORM_QUANTITY : rungs->norm);
    int judged = rungs->expect.count || rungs->ceiling > 0, wanted = judged && l->verdict != VERDICT_PASS;
    l->open = (wanted || rungs->diagnose) && !l->in_time && !l->vary[0] && !l->failure.status;
    if (l->open && l->external) {
        question(e, l);
        ladder_fit(l, l->norm);
    }
    if (!l->open) ladder_free(l);
    l->seconds = omp_get_wtime() - start;
    return status;
}

void ladder_free(struct ladder *l) {
    for (int k = 0; k < 2; k++) field_free(&l->kept[k]);
}
