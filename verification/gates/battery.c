/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The battery: draws, the table, and its cases for a program that runs elsewhere.
 *
 * Draws: GSL's mt19937, seeded by the seed, the scene and the ranges, so that rows do not depend on each other.
 * Numbers are uniform (the scale: its logarithm) and rounded to the three digits of the command. */
#include "verification/gates/battery.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/command.h"
#include "verification/case/results.h"
#include "verification/gates/ceiling.h"
#include "verification/text/number.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Draws ---- */

static gsl_rng *generator(unsigned long seed, const char *scene, const char *more) {
    unsigned long hash = 2166136261; /* FNV-1a, 32 bits */
    for (const char *c = scene; *c; c++) hash = (hash ^ (unsigned char)*c) * 16777619 & 0xffffffff;
    for (const char *c = more; *c; c++) hash = (hash ^ (unsigned char)*c) * 16777619 & 0xffffffff;
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(r, (seed * 2654435761UL ^ hash) & 0xffffffff);
    return r;
}

static double between(gsl_rng *r, double lo, double hi) {
    char text[40];
    snprintf(text, sizeof text, "%.3g", lo + (hi - lo) * gsl_rng_uniform(r));
    return strtod(text, NULL);
}

/* Draws one of 2 images of a rod, 8 of a rectangle or 48 of a box. */
static struct mapping draw_map(unsigned long seed, const char *scene, int dim, int cross, int turned) {
    gsl_rng *r = generator(seed, scene, "");
    struct mapping m = {.axes = dim};
    for (int a = 0; a < dim; a++) m.against[a] = (int)gsl_rng_uniform_int(r, 2) != cross;
    int turn = dim == 2 ? (int)gsl_rng_uniform_int(r, 2) != cross : 0, back = 0;
    if (dim == 3) turn = (int)gsl_rng_uniform_int(r, 3) + cross + 2 * turned, back = (int)gsl_rng_uniform_int(r, 2);
    for (int a = 0; a < dim; a++) m.from[a] = (turn + (back ? dim - a : a)) % dim;
    gsl_rng_free(r);
    return m;
}

static int has_word(const char *ranges, const char *word) {
    return strstr(ranges, word) != NULL;
}

/* Draws the numbers of the ranges and appends them as options; *offset in K of the scene. */
static int draw_ranges(const char *ranges, gsl_rng *r, char *command, double *offset, struct failure *why) {
    for (const char *at = ranges; *at; at += strspn(at, " ")) {
        char name[32];
        double lo, hi;
        int used = 0;
        if (strncmp(at, "cross", 5) == 0 || strncmp(at, "turned", 6) == 0 || strncmp(at, "opposite", 8) == 0) {
            at += strcspn(at, " ");
            continue;
        }
        if (sscanf(at, "%31[A-Za-z0-9_]=%lf:%lf%n", name, &lo, &hi, &used) != 3 || !(lo < hi))
            return refuse(why, STATUS_INPUT, "ranges '%.100s': NAME=LO:HI is wanted", at);
        at += used;
        double value = between(r, lo, hi);
        if (strcmp(name, "offset") == 0)
            *offset = value;
        else
            words_add(command, BATTERY_COMMAND, " --set %s=%.3g", name, value);
    }
    return STATUS_OK;
}

/* 1 if the ranges contain the parameter of NAME=VALUE. */
static int is_drawn(const char *ranges, const char *set) {
    size_t n = strcspn(set, "=") + 1;
    for (const char *at = ranges; *at; at += strcspn(at, " "), at += strspn(at, " "))
        if (strncmp(at, set, n) == 0) return 1;
    return 0;
}

/* With the values of the row: mode_z of a wave makes a plane a box. */
static int dimension_of(const struct scene *s, const char *sets) {
    struct problem p;
    struct failure ignored;
    char name[32], value[32];
    int used;
    scene_defaults(s, &p);
    for (; sscanf(sets, " %31[^=]=%31s%n", name, value, &used) == 2; sets += used)
        for (int i = 0; s->params[i].name; i++)
            if (strcmp(s->params[i].name, name) == 0) number_read(value, &p.param[i]);
    return s->setup(&p, &ignored) ? 0 : p.dim;
}

/* Appends the row's further options; a side is the one of the scene there and that of the case in the command. */
static void add_rungs(const char *rungs, const struct mapping *m, char *command) {
    static const char *const sides[] = {"x_lo", "x_hi", "y_lo", "y_hi", "z_lo", "z_hi"}, flux[] = "--quantity flux_";
    const char *at = strstr(rungs, flux);
    for (int s = 0; at && s < 2 * m->axes; s++) {
        const char *name = at + strlen(flux), *of = sides[mapping_side(m, (enum side)s)];
        if (strncmp(name, of, strlen(of)) != 0) continue;
        words_add(command, BATTERY_COMMAND, " %.*s%s%s", (int)(name - rungs), rungs, sides[s], name + strlen(of));
        return;
    }
    words_add(command, BATTERY_COMMAND, " %s", rungs);
}

int battery_command(const struct battery_row *row, unsigned long seed, char command[BATTERY_COMMAND],
                    struct failure *why) {
    const char *scene = strchr(row->run, ' ') + 1;
    char map[MAPPING_WORDS];
    struct mapping m = {0};
    double offset = 0;
    snprintf(command, BATTERY_COMMAND, "%s mine", row->run);
    for (const char *at = row->sets; *at; at += strcspn(at, " "), at += strspn(at, " "))
        if (!seed || !is_drawn(row->ranges, at))
            words_add(command, BATTERY_COMMAND, " --set %.*s", (int)strcspn(at, " "), at);
    if (seed) {
        gsl_rng *r = generator(seed, scene, row->ranges);
        m = draw_map(seed, scene, dimension_of(scene_find(scene), row->sets), has_word(row->ranges, "cross"),
                     has_word(row->ranges, "turned"));
        for (int a = 0; a < m.axes && has_word(row->ranges, "opposite"); a++) m.against[a] = !m.against[a];
        int status = draw_ranges(row->ranges, r, command, &offset, why);
        double scale = exp2(between(r, -1, 1));
        gsl_rng_free(r);
        if (status) return status;
        mapping_print(&m, map);
        words_add(command, BATTERY_COMMAND, " --map %s --scale %.3g", map, scale);
        if (offset != 0) words_add(command, BATTERY_COMMAND, " --offset %.3g", scale * offset);
    }
    add_rungs(row->rungs, &m, command);
    return STATUS_OK;
}

/* ---- The table ---- */

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
