/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One gate: its command, by another program where there is one, and what its measure says of it. */
#include "verification/gates/gates.h"

#include "verification/ladder/command.h"
#include "verification/foreign/program.h"
#include "verification/foreign/results.h"
#include "verification/ladder/judge.h"
#include "verification/ladder/ladder.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether the measure is what `ladder` itself judges: its command can be typed as it is. */
static int is_ladder(const char *measure) {
    return strcmp(measure, "slope") == 0 || strncmp(measure, "order", 5) == 0;
}

/* Ladders are judged with the ceiling by themselves. */
static int has_ladders(const char *measure) {
    return is_ladder(measure) || strncmp(measure, "slope_", 6) == 0;
}

static void judge_refused(struct measured *m, const char *text) {
    m->verdict = VERDICT_FAIL;
    m->value = m->ci[0] = m->ci[1] = m->error = NAN;
    snprintf(m->reason, sizeof m->reason, "%.300s", text);
}

/* The words that let another program answer a gate. */
struct words {
    const char *word[9]; /* ended by NULL */
    int count;
    char timeout[40], seeds[16];
};

int gates_is_drawn(const struct gate *gate) {
    return strncmp(gate->command, "ladder ", 7) == 0 && !strstr(gate->command, " --dt ");
}

static void words_of(const struct gate *gate, const struct program *g, struct words *w) {
    int n = 0;
    *w = (struct words){0};
    if (!g) return;
    w->word[n++] = g->solver ? "--solver" : "--results";
    w->word[n++] = g->solver ? g->solver : g->results;
    if (g->timeout > 0) {
        snprintf(w->timeout, sizeof w->timeout, "%.17g", g->timeout);
        w->word[n++] = "--timeout", w->word[n++] = w->timeout;
    }
    if (g->seeds > 1 && gates_is_drawn(gate)) {
        snprintf(w->seeds, sizeof w->seeds, "%d", g->seeds);
        w->word[n++] = "--seeds", w->word[n++] = w->seeds;
    }
    if (g->columns.text) w->word[n++] = "--columns", w->word[n++] = g->columns.text;
    w->count = n;
}

/* What all rows of one program share: where cases are kept, each in the directory of its parameters, and their runs.
 */
static void share(const struct gate *gate, const struct program *program, struct command *r) {
    struct experiment *e = &r->experiment;
    struct program *g = &e->program;
    g->keep = program->keep;
    g->runs = program->runs;
    g->row = gate->id;
    if (!e->scene || results_setting(e->scene, &e->problem, r->overridden, &g->map, e->options.aspect, g->setting))
        g->setting[0] = '\0';
}

/* Of a ladder or a run alone: no other verb can be done by another program. */
static int parse(const struct gate *gate, const struct program *program, struct command *r, struct failure *why) {
    struct words w;
    words_of(gate, program, &w);
    if (command_read_with(gate->command, w.word, r, why)) return why->status;
    if (!isnan(gate->ceiling)) r->rungs.ceiling = gate->ceiling;
    if (program && program->solver) share(gate, program, r);
    return STATUS_OK;
}

void gates_judge(const struct gate *gate, const struct program *program, struct measured *m) {
    struct command r;
    struct failure why;
    *m = (struct measured){0};
    const struct measure *measure = measures_find(gate->measure, m);
    if (!measure) return;
    if (parse(gate, program, &r, &why)) {
        judge_refused(m, why.text);
    } else if (measure->ceiling && !(gate->ceiling > 0)) {
        judge_refused(m, "this measure needs an error ceiling beside it");
    } else {
        measure->take(&r, gate->lo, gate->hi, m);
        if (!isnan(gate->ceiling) && m->verdict != VERDICT_SKIPPED && !has_ladders(gate->measure))
            judge_ceiling(m->error, gate->ceiling, &m->verdict, m->reason, sizeof m->reason);
    }
    command_free(&r);
}

void gates_command(const struct gate *gate, const struct program *program, char *text, size_t size) {
    struct words w;
    char glob[512];
    int ladder = is_ladder(gate->measure);
    FILE *out = xcheck(fmemopen(text, size, "w"), size, 1);
    if (!ladder) {
        char *only = words_line(1, (const char *const[]){words_literal(gate->id, glob, sizeof glob)});
        fprintf(out, "verify --only %s", only);
        free(only);
    } else
        fprintf(out, "%s --expect %g,%g", gate->command, gate->lo, gate->hi);
    if (strcmp(gate->measure, "order_linf") == 0) fprintf(out, " --norm linf");
    if (ladder && !isnan(gate->ceiling)) fprintf(out, " --ceiling %.10g", gate->ceiling);
    words_of(gate, program, &w);
    char *more = words_line(w.count, w.word);
    fprintf(out, "%s%s", w.count > 0 ? " " : "", more);
    free(more);
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

/* Rungs of a ladder, in whatever it climbs, each for every seed; 1 of a run. */
static int add_cases(const struct gate *gate, const struct program *program, struct cases *cases) {
    struct command r;
    struct failure why;
    int rungs = 1;
    if (!parse(gate, program, &r, &why) && r.experiment.scene) {
        const struct numbers none = {.count = 1}, *dx = &r.rungs.dx, *steps = &none;
        const struct numbers *climbs[] = {&r.rungs.dt, &r.rungs.fourier, &r.rungs.vary};
        for (int k = 0; k < 3; k++)
            if (climbs[k]->count > 0) steps = climbs[k];
        rungs = dx->count * steps->count;
        int seeds = r.experiment.program.seeds > 1 ? r.experiment.program.seeds : 1;
        for (int i = 0; i < rungs * seeds; i++)
            add_case(cases, &r, dx->value[i / seeds / steps->count], steps->value[i / seeds % steps->count],
                     i % seeds);
        rungs *= seeds;
    }
    command_free(&r);
    return rungs;
}

int gates_rungs(const struct gate *gate, const struct program *program) {
    struct cases cases = {0};
    int rungs = add_cases(gate, program, &cases);
    free(cases.name);
    return rungs;
}

int gates_runs(const struct gates *g) {
    struct cases cases = {0};
    int again = 0; /* the same case once more */
    for (int i = 0; i < g->declared; i++) {
        add_cases(&g->result[i].gate, g->program, &cases);
        again += strcmp(g->result[i].gate.measure, "repeat") == 0;
    }
    free(cases.name);
    return (int)cases.count + again;
}
