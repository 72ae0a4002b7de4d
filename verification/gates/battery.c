/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The battery's table, and its cases for a program that runs elsewhere. */
#include "verification/gates/battery.h"

#include "references/scene.h"
#include "verification/ladder/command.h"
#include "verification/foreign/results.h"
#include "verification/text/whole_file.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BATTERY(order, id, measure, command, bound, ranges, lo, hi, ceiling, sees, bounds)                           \
    {order, {id, TIER_QUICK, measure, command, lo, hi, ceiling, "detects " sees "; bounds: " bounds}, bound, ranges},
const struct battery_row battery_table[] = {
#include "verification/gates/battery.def"
    {0}};
#undef BATTERY

const char *const battery_profile_words[] = {"all", "particles", "slabs", NULL};

static int is_in_profile(const char *id, enum profile profile) {
    if (profile == PROFILE_PARTICLES) return strncmp(id, "periodic/", 9) == 0;
    return profile == PROFILE_SLABS || strncmp(id, "slab/", 5) != 0;
}

static struct draw draw_of(const struct battery_row *row) {
    return (struct draw){row->gate.command, row->ranges, row->bound, row->gate.measure};
}

/* A program's rows in a plane cost it most by far; those of rods see all but what has two axes. */
static enum gate_tier tier_of(const struct gate *gate) {
    struct failure ignored;
    return draw_dimension(gate->command, &ignored) == 1 ? TIER_QUICK : TIER_FULL;
}

int battery_add(int order, enum profile profile, unsigned long seed, struct gates *g, struct failure *why) {
    char command[DRAW_COMMAND];
    for (const struct battery_row *row = battery_table; row->order; row++) {
        struct draw draw = draw_of(row);
        if (row->order != order || !is_in_profile(row->gate.id, profile)) continue;
        if (draw_command(&draw, seed, command, why)) return why->status;
        gates_add(g, &row->gate);
        struct gate *gate = &g->result[g->declared - 1].gate;
        if (seed) gate->command = gates_keep(g, command);
        gate->tier = tier_of(&row->gate);
    }
    return STATUS_OK;
}

void battery_words(enum profile profile, int rungs, char *text, size_t size) {
    if (profile) words_add(text, size, " --profile %s", battery_profile_words[profile]);
    if (rungs) words_add(text, size, " --rungs %d", rungs);
}

static int set_bound(const struct battery_row *row, struct gate *gate, struct failure *why) {
    struct draw draw = draw_of(row);
    return draw_bound(&draw, gate->command, isnan(gate->ceiling) ? &gate->hi : &gate->ceiling, why);
}

/* A run each, by many threads; of failures the first row's is told. */
int battery_bounds(int order, struct gates *g, struct failure *why) {
    int first = g->declared;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < g->declared; i++)
        for (const struct battery_row *row = battery_table; row->order; row++) {
            struct failure own;
            if (strcmp(row->gate.id, g->result[i].gate.id) != 0 || row->order != order ||
                !set_bound(row, &g->result[i].gate, &own))
                continue;
#pragma omp critical(battery_bounds)
            if (i < first) first = i, *why = own;
        }
    return first < g->declared ? why->status : STATUS_OK;
}

/* The cases of one row, a ladder in space `seeds` times; a ladder in time has a directory a step below that of its
 * spacing. */
static int write_row(const struct gate *gate, int seeds, const char *dir, struct failure *why) {
    const char *const more[] = {"--solver", "{case} {out}", NULL};
    struct command r;
    char setting[PROGRAM_SETTING], rung[60] = "", dt[40];
    int status = command_read_with(gate->command, more, &r, why), written;
    struct experiment *e = &r.experiment;
    if (!status && (!e->scene || results_setting(e->scene, &e->problem, r.overridden, &e->program.map,
                                                 e->options.aspect, setting)))
        status = refuse(why, STATUS_INPUT, "'%.200s': has no scene, or too many parameters", gate->command);
    for (int i = 0; !status && i < (r.rungs.dt.count > 1 ? r.rungs.dt.count : 1); i++) {
        if (r.rungs.dt.count > 1) {
            e->options.dt = r.rungs.dt.value[i];
            results_number(e->options.dt, dt);
            snprintf(rung, sizeof rung, "dt=%s", dt);
        }
        const struct results_place at = {dir, setting, rung, &e->program.map,
                                         gates_is_drawn(gate) && seeds > 1 ? seeds : 0};
        status = results_write(&at, e->scene, &e->problem, &e->options, r.rungs.dx.text, &written, why);
    }
    command_free(&r);
    return status;
}

int battery_write(const struct gates *g, int seeds, const char *dir, int *cases, struct failure *why) {
    char path[RESULTS_PATH];
    for (int i = 0; i < g->declared; i++)
        if (write_row(&g->result[i].gate, seeds, dir, why)) return why->status;
    snprintf(path, sizeof path, "%.1000s/cases.txt", dir);
    char *list = whole_file_at(path, NULL);
    *cases = 0;
    for (const char *line = list; line && (line = strchr(line, '\n')); line++) ++*cases;
    free(list);
    return STATUS_OK;
}
