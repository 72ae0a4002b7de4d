/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of the battery, and its cases for a program that runs elsewhere. */
#include "verification/gates/battery.h"

#include "solver/words.h"
#include "references/scene.h"
#include "verification/case/command.h"
#include "verification/case/results.h"
#include "verification/gates/ceiling.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BATTERY(orders, id, measure, run, sets, rungs, ranges, lo, hi, ceiling, sees, bounds)                        \
    {orders, id, measure, run, sets, rungs, ranges, __LINE__, "detects " sees "; bounds: " bounds},
const struct battery_row battery_table[] = {
#include "verification/gates/battery.def"
    {0}};
#undef BATTERY

/* The bounds of the row on that line; e: drawn, at the finest rung. */
static void bounds_of(int line, const struct experiment *e, struct gate *g) {
    const double dx = e->options.dx;
    g->lo = g->hi = g->ceiling = NAN * dx;
    switch (line) {
#define BATTERY(orders, id, measure, run, sets, rungs, ranges, low, high, limit, sees, bounds)                       \
    case __LINE__:                                                                                                   \
        g->lo = low, g->hi = high, g->ceiling = limit;                                                               \
        break;
#include "verification/gates/battery.def"
#undef BATTERY
    }
}

const char *const battery_profile_words[] = {"all", "particles", NULL};

static int is_in_profile(const char *id, enum profile profile) {
    return profile == PROFILE_ALL || strncmp(id, "periodic/", 9) == 0 || strcmp(id, "space/smooth") == 0;
}

/* Rows in a plane take most of the time; rods detect all faults except those of two axes. */
static enum gate_tier tier_of(const struct battery_row *row) {
    return strstr(row->run, " rod-") || strstr(row->run, " wall-") ? TIER_QUICK : TIER_FULL;
}

int battery_add(int order, enum profile profile, unsigned long seed, struct gates *g, struct failure *why) {
    char command[BATTERY_COMMAND];
    for (const struct battery_row *row = battery_table; row->orders; row++) {
        if (!(row->orders & order) || !is_in_profile(row->id, profile)) continue;
        if (battery_command(row, seed, command, why)) return why->status;
        gates_add(
            g, &(struct gate){row->id, tier_of(row), row->measure, gates_keep(g, command), NAN, NAN, NAN, row->why});
        g->result[g->declared - 1].line = row->line;
    }
    return STATUS_OK;
}

void battery_words(enum profile profile, int rungs, char *text, size_t size) {
    if (profile) words_add(text, size, " --profile %s", battery_profile_words[profile]);
    if (rungs) words_add(text, size, " --rungs %d", rungs);
}

/* The program of rows that are only listed or written. */
static const struct program any = {.solver = "{case} {out}"};

/* If the command was refused because of its program and has no answer, the bounds are the general ones. */
static int set_bounds(struct gate_result *r, struct failure *why) {
    struct gate *g = &r->gate;
    struct command own;
    int status = r->read ? STATUS_OK : gates_read_row(g, &any, &own, why);
    if (!status) {
        struct experiment e = gates_finest(r->read ? r->read : &own);
        bounds_of(r->line, &e, g);
        if (!(g->lo <= g->hi))
            status = refuse(why, STATUS_NUMERICAL, "%.60s: '%.200s' has no bounds", g->id, g->command);
    }
    if (!r->read) command_free(&own);
    return status;
}

/* Each row is one run, on many threads; of several failures that of the first row is reported. */
int battery_bounds(struct gates *g, struct failure *why) {
    int first = g->declared;
    if (!g->program) g->program = &any;
    gates_read(g);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < g->declared; i++) {
        struct failure own;
        if (output_noted() || !g->result[i].line || !set_bounds(&g->result[i], &own)) continue;
#pragma omp critical(battery_bounds)
        if (i < first) first = i, *why = own;
    }
    return first < g->declared ? why->status : STATUS_OK;
}

/* Writes the cases of one row, `seeds` times for a ladder in space; the time steps of a ladder are directories below
 * the spacing. */
static int write_row(const struct gate_result *row, int seeds, const char *dir, struct failure *why) {
    if (!row->read) return *why = row->refused, why->status;
    struct experiment e = row->read->experiment;
    const struct numbers *steps = &row->read->rungs.dt;
    char rung[60] = "", dt[40];
    int status = STATUS_OK, written;
    if (!e.scene || results_setting(e.scene, &e.problem, row->read->overridden, &e.program.map, e.options.aspect,
                                    e.program.setting))
        return refuse(why, STATUS_INPUT, "'%.200s': has no scene, or too many parameters", row->gate.command);
    for (int i = 0; !status && i < (steps->count > 1 ? steps->count : 1); i++) {
        if (steps->count > 1) {
            e.options.dt = steps->value[i];
            results_number(e.options.dt, dt);
            snprintf(rung, sizeof rung, "dt=%s", dt);
        }
        const struct results_place at = {dir, e.program.setting, rung, &e.program.map,
                                         gates_is_drawn(&row->gate) && seeds > 1 ? seeds : 0};
        status = results_write(&at, e.scene, &e.problem, &e.options, row->read->rungs.dx.text, &written, why);
    }
    return status;
}

int battery_write(struct gates *g, int seeds, const char *dir, int *cases, struct failure *why) {
    char path[RESULTS_PATH];
    if (!g->program) g->program = &any;
    gates_read(g);
    for (int i = 0; i < g->declared; i++)
        if (write_row(&g->result[i], seeds, dir, why)) return why->status;
    snprintf(path, sizeof path, "%.1000s/cases.txt", dir);
    char *list = whole_file_at(path, NULL);
    *cases = 0;
    for (const char *line = list; line && (line = strchr(line, '\n')); line++) ++*cases;
    free(list);
    return STATUS_OK;
}
