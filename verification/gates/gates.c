/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gates: reading, judging and running rows.  A row that was not filled is inconclusive and does not pass;
 * gates_status also compares the rows executed with those declared.
 *
 * Another program: twice as many rows as cases run at a time, so that it runs for the next row while one row is
 * judged or waits for a case of another.
 *
 * More rungs: a ceiling bounds the error at the finest spacing.  k halvings multiply it by 2^-kP, P the order of the
 * row: bands begin half an order below it, 0.1 below the order in time. */
#include "verification/gates/gates.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/command.h"
#include "verification/case/results.h"
#include "verification/judge/judge.h"
#include "verification/judge/ladder.h"
#include "verification/solve/process.h"
#include "verification/solve/program.h"
#include "verification/solve/runs.h"
#include "verification/solve/scratch.h"
#include "verification/text/number.h"
#include "verification/text/output.h"
#include "verification/text/progress.h"
#include "verification/text/shell.h"

#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 1 if `ladder` itself judges the measure. */
static int is_ladder(const char *measure) {
    return strcmp(measure, "slope") == 0 || strncmp(measure, "order", 5) == 0;
}

/* 1 if ladder_judge applies the ceiling. */
static int has_ladders(const char *measure) {
    return is_ladder(measure) || strncmp(measure, "slope_", 6) == 0;
}

static void judge_refused(struct measured *m, const char *text) {
    m->verdict = VERDICT_FAIL;
    m->value = m->ci[0] = m->ci[1] = m->error = NAN;
    snprintf(m->reason, sizeof m->reason, "%.300s", text);
}

int gates_is_drawn(const struct gate *gate) {
    return strncmp(gate->command, "ladder ", 7) == 0 && !strstr(gate->command, " --dt ");
}

/* ---- Reading ---- */

/* Another program answers only ladders and runs. */
int gates_read_row(const struct gate *gate, const struct program *program, struct command *c, struct failure *why) {
    const char *const more[] = {!program          ? NULL
                                : program->solver ? "--solver"
                                                  : "--results",
                                !program          ? NULL
                                : program->solver ? program->solver
                                                  : program->results,
                                NULL};
    struct experiment *e = &c->experiment;
    struct program *own = &e->program;
    if (command_read_with(gate->command, more, c, why)) return why->status;
    if (!program) return STATUS_OK;
    own->timeout = program->timeout;
    own->columns = program->columns;
    if (program->seeds > 1 && gates_is_drawn(gate)) own->seeds = program->seeds;
    if (!program->solver) return STATUS_OK;
    own->row = gate->id;
    if (!e->scene ||
        results_setting(e->scene, &e->problem, c->overridden, &own->map, e->options.aspect, own->setting))
        own->setting[0] = '\0';
    return STATUS_OK;
}

void gates_read(struct gates *g) {
    for (int i = 0; i < g->declared; i++) {
        struct gate_result *r = &g->result[i];
        if (r->read || r->refused.status) continue;
        r->read = xcalloc(1, sizeof *r->read);
        if (!gates_read_row(&r->gate, g->program, r->read, &r->refused)) continue;
        command_free(r->read);
        free(r->read);
        r->read = NULL;
    }
}

struct experiment gates_finest(const struct command *c) {
    struct experiment e = c->experiment;
    struct options *o = &e.options;
    for (int i = 0; i < c->rungs.dx.count; i++) o->dx = fmin(o->dx, c->rungs.dx.value[i]);
    for (int i = 0; i < c->rungs.dt.count; i++) o->dt = fmin(o->dt, c->rungs.dt.value[i]);
    for (int i = 0; i < c->rungs.fourier.count; i++) o->fourier = fmin(o->fourier, c->rungs.fourier.value[i]);
    return e;
}

/* ---- Judging ---- */

/* c: NULL if the command was refused.  bounded: 1 if a measure of an error needs its ceiling, which an expression
 * may fail to give; 0 for a row of a file, in which NAN is none.  The rows of one program share its runs and the
 * directory of its cases. */
static void judge(const struct gate *gate, const struct program *program, const struct command *c,
                  const char *refused, int bounded, struct measured *m) {
    *m = (struct measured){0};
    const struct measure *measure = measures_find(gate->measure, m);
    if (!measure) return;
    if (!c || (bounded && measure->ceiling && !(gate->ceiling > 0))) {
        judge_refused(m, c ? "this measure needs a ceiling, and that of its row has no value: see gates/ceiling.h"
                           : refused);
        return;
    }
    struct command row = *c;
    if (!isnan(gate->ceiling)) row.rungs.ceiling = gate->ceiling;
    if (program && program->solver)
        row.experiment.program.keep = program->keep, row.experiment.program.runs = program->runs;
    measure->take(&row, gate->lo, gate->hi, m);
    if (!isnan(gate->ceiling) && m->verdict != VERDICT_SKIPPED && !has_ladders(gate->measure))
        judge_ceiling(m->error, gate->ceiling, &m->verdict, m->reason, sizeof m->reason);
}

void gates_judge(const struct gate *gate, const struct program *program, struct measured *m) {
    struct command c;
    struct failure why;
    int status = gates_read_row(gate, program, &c, &why);
    judge(gate, program, status ? NULL : &c, why.text, 1, m);
    command_free(&c);
}

void gates_run_row(struct gates *g, struct gate_result *r, const struct program *program) {
    double start = omp_get_wtime();
    gates_command(&r->gate, g->program, r->typed, sizeof r->typed);
    if (g->origin && strncmp(r->typed, "verify", 6) == 0) words_add(r->typed, sizeof r->typed, " %s", g->origin);
    judge(&r->gate, program, r->read, r->refused.text, r->line > 0, &r->measured);
    r->seconds = omp_get_wtime() - start;
}

/* ---- The command that repeats a row ---- */

static void put_words(const char *option, const char *value, FILE *out) {
    char *words = shell_line(2, (const char *const[]){option, value});
    fprintf(out, " %s", words);
    free(words);
}

/* Options for which another program answers. */
static void put_program(const struct gate *gate, const struct program *g, FILE *out) {
    if (g->solver)
        put_words("--solver", g->solver, out);
    else
        put_words("--results", g->results, out);
    if (g->timeout > 0) fprintf(out, " --timeout %.17g", g->timeout);
    if (g->seeds > 1 && gates_is_drawn(gate)) fprintf(out, " --seeds %d", g->seeds);
    if (g->columns.text) put_words("--columns", g->columns.text, out);
}

void gates_command(const struct gate *gate, const struct program *program, char *text, size_t size) {
    char glob[512];
    int ladder = is_ladder(gate->measure);
    FILE *out = xcheck(fmemopen(text, size, "w"), size, 1);
    if (!ladder) {
        char *only = shell_line(1, (const char *const[]){shell_literal(gate->id, glob, sizeof glob)});
        fprintf(out, "verify --only %s", only);
        free(only);
    } else
        fprintf(out, "%s --expect %g,%g", gate->command, gate->lo, gate->hi);
    if (strcmp(gate->measure, "order_linf") == 0) fprintf(out, " --norm linf");
    if (ladder && !isnan(gate->ceiling)) fprintf(out, " --ceiling %.10g", gate->ceiling);
    if (program) put_program(gate, program, out);
    fclose(out);
    text[size - 1] = '\0';
}

/* ---- How many cases ---- */

enum { CASE_NAME = 400 };

struct cases {
    char (*name)[CASE_NAME]; /* SCENE/SETTING/DX/STEP/SEED */
    size_t count;
};

static void add_case(struct cases *c, const struct command *r, double dx, double climbed, int seed) {
    const struct experiment *e = &r->experiment;
    char name[CASE_NAME];
    snprintf(name, sizeof name, "%.60s/%.199s/%.17g/%.17g/%d", e->scene->name, e->program.setting, dx, climbed, seed);
    for (size_t i = 0; i < c->count; i++)
        if (strcmp(c->name[i], name) == 0) return;
    c->name = xgrow(c->name, c->count, c->count + 1, sizeof *c->name);
    memcpy(c->name[c->count++], name, sizeof name);
}

/* Adds the rungs of a ladder, in any of its quantities, once per seed; 1 for a run. */
static int add_cases(const struct command *c, struct cases *cases) {
    if (!c || !c->experiment.scene) return 1;
    const struct numbers none = {.count = 1}, *dx = &c->rungs.dx, *steps = &none;
    const struct numbers *climbs[] = {&c->rungs.dt, &c->rungs.fourier, &c->rungs.vary};
    for (int k = 0; k < 3; k++)
        if (climbs[k]->count > 0) steps = climbs[k];
    int seeds = c->experiment.program.seeds > 1 ? c->experiment.program.seeds : 1;
    int all = dx->count * steps->count * seeds;
    for (int i = 0; i < all; i++)
        add_case(cases, c, dx->value[i / seeds / steps->count], steps->value[i / seeds % steps->count], i % seeds);
    return all;
}

int gates_rungs(const struct gate_result *r) {
    struct cases cases = {0};
    int rungs = add_cases(r->read, &cases);
    free(cases.name);
    return rungs;
}

int gates_runs(struct gates *g) {
    struct cases cases = {0};
    int again = 0; /* repetitions of a case */
    gates_read(g);
    for (int i = 0; i < g->declared; i++) {
        add_cases(g->result[i].read, &cases);
        again += strcmp(g->result[i].gate.measure, "repeat") == 0;
    }
    free(cases.name);
    return (int)cases.count + again;
}

/* ---- Running all rows ---- */

/* Estimate of particle updates: particles x steps, summed over rungs; steps = t kappa/(F dx^2), with F as given, else
 * 1/600, where the time error of Euler's method is below 1 %; a few steps for the exact stepper.  It decides only
 * which row starts first. */
static double steps_at(const struct command *r, double dx) {
    const struct experiment *e = &r->experiment;
    const struct material *m = &e->problem.material[0];
    double diffusion = e->problem.t_end * m->k[0] / m->rho_c / (dx * dx), steps = 0;
    for (int i = 0; i < r->rungs.dt.count; i++) steps += e->problem.t_end / r->rungs.dt.value[i];
    for (int i = 0; i < r->rungs.fourier.count; i++) steps += diffusion / r->rungs.fourier.value[i];
    if (steps > 0) return steps;
    return e->method && e->method->scheme && !options_is_matched(&e->options) ? 20 : 600 * diffusion;
}

static double job_size(const struct command *r) {
    if (!r) return 0;
    const struct problem *p = &r->experiment.problem;
    double work = 0;
    for (int i = 0; i < r->rungs.dx.count; i++) {
        double particles = 1;
        for (int a = 0; a < p->dim; a++) particles *= (p->hi[a] - p->lo[a]) / r->rungs.dx.value[i];
        work += particles * steps_at(r, r->rungs.dx.value[i]);
    }
    return isfinite(work) ? work : 0;
}

void gates_run(struct gates *g) {
    gates_read(g);
    size_t *order = xcalloc((size_t)g->declared, sizeof *order);
    double *light = xcalloc((size_t)g->declared, sizeof *light);
    for (int i = 0; i < g->declared; i++) order[i] = (size_t)i, light[i] = -job_size(g->result[i].read);
    if (!g->program) gsl_sort_index(order, light, 1, (size_t)g->declared);
    struct progress progress = progress_start("gates", g->declared);
    int executed = 0, solver = g->program && g->program->solver;
#pragma omp parallel for schedule(dynamic, 1) reduction(+ : executed) if (!solver)
    for (int i = 0; i < g->declared; i++) {
        struct gate_result *result = &g->result[order[i]];
        if (output_noted()) continue;
        gates_run_row(g, result, g->program);
        executed += !result->executed;
        result->executed = 1;
        progress_tick(&progress);
    }
    progress_end(&progress);
    g->executed = executed;
    free(light);
    free(order);
}

void gates_cut(struct gates *g, int signal) {
    int judged = 0;
    for (int i = 0; i < g->declared; i++)
        if (g->result[i].executed)
            g->result[judged++] = g->result[i];
        else
            gates_forget(&g->result[i]);
    g->planned = g->declared;
    g->declared = judged;
    g->interrupted = signal;
}

size_t gates_group_length(const char *id) {
    return strcspn(id, "/");
}

int gates_same_group(const char *a, const char *b) {
    size_t n = gates_group_length(a);
    return n == gates_group_length(b) && strncmp(a, b, n) == 0;
}

int gates_begins_group(const struct gates *g, int i) {
    for (int k = 0; k < i; k++)
        if (gates_same_group(g->result[k].gate.id, g->result[i].gate.id)) return 0;
    return 1;
}

const char *gates_noun(const struct gates *g, int number) {
    if (g->program) return number == 1 ? "row" : "rows";
    return number == 1 ? "gate" : "gates";
}

int gates_holds(const struct gate_result *r) {
    return r->measured.verdict == VERDICT_PASS;
}

int gates_fails(const struct gate_result *r) {
    return !gates_holds(r) && r->measured.verdict != VERDICT_SKIPPED;
}

struct gates_tally gates_tally(const struct gates *g, const char *id) {
    struct gates_tally t = {0};
    for (int i = 0; i < g->declared; i++) {
        const enum verdict verdict = g->result[i].measured.verdict;
        if (id && !gates_same_group(g->result[i].gate.id, id)) continue;
        t.judged += verdict != VERDICT_SKIPPED;
        t.skipped += verdict == VERDICT_SKIPPED;
        t.passed += verdict == VERDICT_PASS;
        t.failed += verdict == VERDICT_FAIL;
        t.seconds += g->result[i].seconds;
    }
    t.undecided = t.judged - t.passed - t.failed;
    return t;
}

int gates_status(const struct gates *g) {
    struct gates_tally t = gates_tally(g, NULL);
    int silent = 0, sound = 0;
    for (int i = 0; i < g->declared; i++) {
        const struct gate_result *r = &g->result[i];
        const enum verdict verdict = r->measured.verdict;
        silent += verdict == VERDICT_FAIL && isnan(r->measured.value);
        sound += r->executed && verdict != VERDICT_FAIL && verdict != VERDICT_MEASURED;
    }
    if (g->program && silent && silent + t.skipped == g->declared) return STATUS_NUMERICAL;
    if (g->declared == 0 || g->executed != g->declared || sound < g->declared) return STATUS_GATE;
    if (g->program && t.skipped == g->declared) return STATUS_SKIPPED;
    return t.undecided || !t.passed ? STATUS_INCONCLUSIVE : STATUS_OK;
}

/* ---- Rows of another program ---- */

/* A program that solves rods alone declines most rows; their lines would hide the others. */
static void show_row(const struct gates *g, const struct gate_result *r, struct progress *progress) {
    const struct measured *m = &r->measured;
    int passed = m->verdict == VERDICT_PASS;
    if (m->verdict == VERDICT_SKIPPED && !g->verbose && process_declined(m->reason)) {
        progress_now(progress, "%d of %d  %s  skipped", progress->done, g->declared, r->gate.id);
        return;
    }
    progress_print(progress, "%d of %d  %s  %s%s%s  %.1f s", progress->done, g->declared, r->gate.id,
                   verdict_words[m->verdict], passed ? "" : ": ", passed ? "" : m->reason, r->seconds);
}

static void run_row(struct gates *g, struct gate_result *result, const struct program *program,
                    struct progress *progress) {
    struct failure ignored;
    if (output_noted() || runs_absent(program->runs, &ignored)) return;
    gates_run_row(g, result, program);
    if (output_noted() || runs_absent(program->runs, &ignored)) return; /* no verdict: its runs were interrupted */
    result->executed = 1;
#pragma omp critical(gates_row)
    {
        progress->done++;
        show_row(g, result, progress);
    }
}

static void run_rows(struct gates *g, int jobs, const struct program *program, struct progress *progress) {
    size_t *order = xcalloc((size_t)g->declared, sizeof *order);
    double *few = xcalloc((size_t)g->declared, sizeof *few);
    for (int i = 0; i < g->declared; i++) order[i] = (size_t)i, few[i] = -gates_rungs(&g->result[i]);
    if (jobs > 1) gsl_sort_index(order, few, 1, (size_t)g->declared); /* most rungs first */
#pragma omp parallel for schedule(dynamic, 1) num_threads(2 * jobs) if (jobs > 1)
    for (int i = 0; i < g->declared; i++) run_row(g, &g->result[order[i]], program, progress);
    free(few);
    free(order);
}

int gates_run_program(struct gates *g, int jobs, struct failure *why) {
    struct program program = *g->program;
    struct scratch scratch;
    struct progress progress = progress_start("rows", g->declared);
    int kept = program.keep != NULL;
    if (!kept && scratch_open(&scratch, why)) return why->status;
    if (!kept) program.keep = scratch.dir;
    program.runs = runs_create(jobs, gates_runs(g), &progress);
    run_rows(g, jobs, &program, &progress);
    progress_end(&progress);
    for (int i = 0; i < g->declared; i++) g->executed += g->result[i].executed;
    int status = runs_absent(program.runs, why) ? STATUS_INPUT : STATUS_OK;
    runs_free(program.runs);
    if (!kept) scratch_close(&scratch);
    return status;
}

/* ---- More rungs ---- */

/* The list of numbers after that option in a command; NULL where there are fewer than two. */
static const char *list_after(const char *command, const char *option, size_t *letters) {
    const char *at = strstr(command, option);
    if (!at) return NULL;
    at += strlen(option);
    *letters = strcspn(at, " ");
    return memchr(at, ',', *letters) ? at : NULL;
}

/* The number of `letters` letters at `text`, over 2^halvings: 1/60 is 1/120. */
static void halve(const char *text, size_t letters, int halvings, FILE *out) {
    const char *slash = memchr(text, '/', letters);
    char below[40] = "1";
    double divisor = 1;
    size_t above = slash ? (size_t)(slash - text) : letters;
    if (slash) snprintf(below, sizeof below, "%.*s", (int)(letters - above - 1), slash + 1);
    number_read(below, &divisor);
    fprintf(out, ",%.*s/%.17g", (int)above, text, ldexp(divisor, halvings));
}

/* The command with so many rungs into `text`; by how many halvings it is finer. */
static int add_rungs(const char *command, int rungs, char *text, size_t size) {
    size_t letters;
    const char *list = list_after(command, "--dt ", &letters);
    int count = 1;
    if (!list) list = list_after(command, "--dx ", &letters);
    if (!list) return 0;
    const char *last = list;
    for (const char *c = list; c < list + letters; c++)
        if (*c == ',') count++, last = c + 1;
    if (count >= rungs) return 0;
    FILE *out = xcheck(fmemopen(text, size, "w"), size, 1);
    fprintf(out, "%.*s", (int)(list + letters - command), command);
    for (int k = 1; k <= rungs - count; k++) halve(last, (size_t)(list + letters - last), k, out);
    fprintf(out, "%s", list + letters);
    fclose(out);
    text[size - 1] = '\0';
    return rungs - count;
}

void gates_refine(struct gates *g, int rungs, double time_order) {
    static const double BELOW = 0.2, ABOVE = 0.5;
    char text[GATES_COMMAND];
    for (int i = 0; i < g->declared; i++) {
        struct gate *gate = &g->result[i].gate;
        int finer = rungs > 0 ? add_rungs(gate->command, rungs, text, sizeof text) : 0;
        if (finer) gates_retype(g, i, text), gate->ceiling *= pow(2, -finer * nearbyint(gate->lo + 0.5));
        if (time_order > 0 && strcmp(gate->measure, "slope_time") == 0)
            gate->lo = time_order - BELOW, gate->hi = time_order + ABOVE;
    }
}
