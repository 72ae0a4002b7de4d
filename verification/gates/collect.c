/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of gates, the references of scenes, and the choice of --only, --skip and --quick. */
#include "verification/gates/gates.h"

#include "references/scene.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/command.h"
#include "verification/gates/battery.h"
#include "verification/gates/ceiling.h"
#include "verification/text/output.h"
#include "verification/text/shell.h"

#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The table ---- */

struct row {
    const char *id;
    enum gate_tier tier;
    const char *measure, *command;
    int line; /* line of gates.def with the row's bounds */
    const char *why;
};

#define GATE(id, tier, measure, command, lo, hi, ceiling, why) {id, TIER_##tier, measure, command, __LINE__, why},
static const struct row rows[] = {
#include "verification/gates/gates.def"
};
#undef GATE

/* The bounds of the row on that line; e: the experiment at the finest rung. */
static void bounds_of(int line, const struct experiment *e, struct gate *g) {
    const double dx = e->options.dx;
    switch (line) {
#define GATE(id, tier, measure, command, low, high, limit, why)                                                      \
    case __LINE__:                                                                                                   \
        g->lo = low, g->hi = high, g->ceiling = limit;                                                               \
        return;
#include "verification/gates/gates.def"
#undef GATE
    default:
        g->lo = g->hi = g->ceiling = NAN * dx;
    }
}

enum { NAME = 240, WORD = 80 };

/* Replaces the first {a,b,c} of the text by its k-th alternative; word: the first word of the alternative without
 * the name of an option.  Returns 0 if there are fewer. */
static int pick(const char *text, int k, char picked[GATES_COMMAND], char word[WORD]) {
    const char *open = strchr(text, '{'), *at = open + 1, *close = strchr(open, '}');
    for (; k > 0; k--) {
        at += strcspn(at, ",}");
        if (*at++ == '}') return 0;
    }
    int length = (int)strcspn(at, ",}");
    snprintf(picked, GATES_COMMAND, "%.*s%.*s%s", (int)(open - text), text, length, at, close + 1);
    int option = *at == '-' ? (int)strcspn(at, " ") + 1 : 0;
    snprintf(word, WORD, "%.*s", (int)strcspn(at + option, " ,}"), at + option);
    return 1;
}

/* The id with its first {} replaced by the word, or with the word appended. */
static void name_with(const char *id, const char *word, char name[NAME]) {
    const char *place = strstr(id, "{}");
    if (place)
        snprintf(name, NAME, "%.*s%s%.100s", (int)(place - id), id, word, place + 2);
    else
        snprintf(name, NAME, "%.150s/%s", id, word);
}

/* Adds a gate for each choice of alternatives. */
static void add_row(struct gates *g, const struct row *row, const char *id, const char *command) {
    char picked[GATES_COMMAND], word[WORD], name[NAME];
    if (!strchr(command, '{')) {
        gates_add(g, &(struct gate){gates_keep(g, id), row->tier, row->measure, gates_keep(g, command), NAN, NAN, NAN,
                                    row->why});
        g->result[g->declared - 1].line = row->line;
        return;
    }
    for (int k = 0; pick(command, k, picked, word); k++) {
        name_with(id, word, name);
        add_row(g, row, name, picked);
    }
}

/* A refused command has no bounds; its gate fails with the refusal.  An interrupt leaves the rest. */
static void set_bounds(struct gate_result *r) {
    if (output_noted() || !r->line || !r->read) return;
    struct experiment e = gates_finest(r->read);
    bounds_of(r->line, &e, &r->gate);
}

/* ---- References ---- */

enum { TEXT = 160 }; /* characters of the name and of the command of a reference's gate */

/* The reference of a scene needs no row: its two forms must agree within their bounds, and the bounds must be
 * small. */
static void add_reference(struct gates *g, const struct scene *s) {
    struct problem p;
    struct failure why;
    char id[TEXT], command[TEXT];
    scene_defaults(s, &p);
    snprintf(id, sizeof id, "reference/%s", s->name);
    if (s->setup(&p, &why)) p.dim = 1; /* its command then fails with that text */
    snprintf(command, sizeof command, "reference %s --at ", s->name);
    for (int a = 0; a < p.dim; a++) {
        static const double part[DIM_MAX] = {0.137, 0.311, 0.253};
        words_add(command, sizeof command, a ? ",%.3g" : "%.3g", p.lo[a] + part[a] * (p.hi[a] - p.lo[a]));
    }
    words_add(command, sizeof command, " --time %.3g", p.t_end);
    gates_add(g, &(struct gate){gates_keep(g, id), TIER_QUICK, "reference", gates_keep(g, command), 0, 1, 1e-12,
                                "two forms derived apart differ by no more than the sum of their bounds"});
}

static void copy_name(const char *id, int group, char name[TEXT]) {
    snprintf(name, TEXT, "%.*s", group ? (int)gates_group_length(id) : TEXT - 1, id);
}

/* The id nearest to what was typed, or the group nearest to that of a pattern. */
static void suggest(const struct gates *g, const char *glob, char *hint, size_t size) {
    char typed[TEXT], (*name)[TEXT] = xcalloc((size_t)g->declared, sizeof *name);
    const char **names = xcalloc((size_t)g->declared + 1, sizeof *names), *nearest = NULL;
    const int group = strpbrk(glob, "*?[") != NULL;
    copy_name(glob, group, typed);
    for (int i = 0; i < g->declared; i++) copy_name(g->result[i].gate.id, group, name[i]), names[i] = name[i];
    if (!strpbrk(typed, "*?[")) nearest = words_nearest(names, typed);
    hint[0] = '\0';
    if (nearest) snprintf(hint, size, "; did you mean '%.60s%s'?", nearest, group ? "/*" : "");
    free(names);
    free(name);
}

/* Orders of the battery that have the row, or one that the pattern matches: 1, 2, 4 or their sum. */
static int orders_of(const char *glob) {
    int orders = 0;
    for (const struct battery_row *row = battery_table; row->orders; row++)
        if (fnmatch(glob, row->id, 0) == 0) orders |= row->orders;
    return orders;
}

/* option: only or skip */
static int none_matches(const struct gates *g, const char *option, const char *glob, struct failure *why) {
    char hint[100];
    int file = g->origin && strncmp(g->origin, "--gates", 7) == 0, orders = g->origin && !file ? orders_of(glob) : 0;
    if (orders)
        return refuse(why, STATUS_INPUT, "--%s: '%.60s' is a row of --order %d, not of these (%.200s)", option, glob,
                      orders & 2   ? 2
                      : orders & 1 ? 1
                                   : 4,
                      g->origin);
    if (!g->origin && orders_of(glob))
        return refuse(why, STATUS_INPUT, "--%s: '%.60s' is a row of the battery: --solver or --results is missing",
                      option, glob);
    suggest(g, glob, hint, sizeof hint);
    return refuse(why, STATUS_INPUT, "--%s: no gate matches '%.60s'%s (see: %s%.200s)", option, glob, hint,
                  file ? "" : "heatladder list ",
                  file        ? g->origin
                  : g->origin ? "battery"
                              : "gates");
}

void gates_add(struct gates *g, const struct gate *gate) {
    size_t used = (size_t)g->declared;
    if ((used & (used - 1)) == 0) /* 0, 1, 2, 4, 8, ...: full */
        g->result = xgrow(g->result, used, used ? 2 * used : 1, sizeof *g->result);
    g->result[used] = (struct gate_result){.gate = *gate};
    g->declared++;
}

/* STATUS_OK if each of the globs matches a row. */
static int check_globs(const struct gates *g, const char *option, const char *globs, struct failure *why) {
    char glob[1024];
    while (globs) {
        int found = 0;
        globs = shell_glob(globs, glob, sizeof glob);
        for (int i = 0; i < g->declared; i++) found += fnmatch(glob, g->result[i].gate.id, 0) == 0;
        if (!found) return none_matches(g, option, glob, why);
    }
    return STATUS_OK;
}

int gates_choose(struct gates *g, const char *only, const char *skip, int quick, struct failure *why) {
    int kept = 0;
    if (check_globs(g, "only", only, why) || check_globs(g, "skip", skip, why)) return why->status;
    for (int i = 0; i < g->declared; i++) {
        struct gate gate = g->result[i].gate;
        if ((quick && gate.tier != TIER_QUICK) || (only && !shell_match(only, gate.id))) continue;
        if (!shell_match(skip, gate.id)) g->result[kept++] = g->result[i];
    }
    g->declared = kept;
    if (kept) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "no gate is left: --only '%.60s'%s%s%s%s", only ? only : "*",
                  skip ? " --skip '" : "", skip ? skip : "", skip ? "'" : "", quick ? " --quick" : "");
}

static void add_rows(struct gates *g) {
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) add_row(g, &rows[i], rows[i].id, rows[i].command);
}

int gates_collect(const char *only, const char *skip, int quick, struct gates *g, struct failure *why) {
    *g = (struct gates){0};
    add_rows(g);
    for (int i = 0; scenes[i]; i++) add_reference(g, scenes[i]);
    if (gates_choose(g, only, skip, quick, why)) return why->status;
    gates_read(g);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < g->declared; i++) set_bounds(&g->result[i]);
    return STATUS_OK;
}

const char *gates_keep(struct gates *g, const char *text) {
    size_t count = (size_t)g->texts;
    g->kept = xgrow(g->kept, count, count + 1, sizeof *g->kept);
    return g->kept[g->texts++] = xcheck(strdup(text), strlen(text) + 1, 1);
}

void gates_forget(struct gate_result *r) {
    if (r->read) command_free(r->read);
    free(r->read);
    r->read = NULL, r->refused.status = STATUS_OK;
}

void gates_retype(struct gates *g, int i, const char *command) {
    gates_forget(&g->result[i]);
    g->result[i].gate.command = gates_keep(g, command);
}

void gates_free(struct gates *g) {
    for (int i = 0; i < g->declared; i++) gates_forget(&g->result[i]), measures_free(&g->result[i].measured);
    for (int i = 0; i < g->texts; i++) free(g->kept[i]);
    free(g->kept);
    free(g->result);
    free(g->text);
    *g = (struct gates){0};
}

int gates_has_order(const char *scene, const char *method) {
    char start[120];
    int length = snprintf(start, sizeof start, "ladder %s %s ", scene, method), found = 0;
    struct gates g = {0};
    add_rows(&g);
    for (int i = 0; i < g.declared && !found; i++) {
        const struct gate *gate = &g.result[i].gate;
        found = strncmp(gate->measure, "slope", 5) == 0 && strncmp(gate->command, start, (size_t)length) == 0;
    }
    gates_free(&g);
    return found;
}
