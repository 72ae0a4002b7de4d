/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One gate: reading its command, measuring, judging, and the command that repeats the verdict. */
#include "solver/words.h"
#include "verification/gates/gates.h"

#include "verification/case/command.h"
#include "verification/solve/program.h"
#include "verification/case/results.h"
#include "verification/judge/judge.h"
#include "verification/judge/ladder.h"
#include "verification/text/shell.h"

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
        judge_refused(m, c ? "this measure needs an error ceiling beside it" : refused);
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
