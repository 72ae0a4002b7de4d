/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder bench: error against time and against counted work. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "solver/words.h"
#include "verification/bench/bench.h"
#include "verification/bench/bench_print.h"
#include "verification/text/json.h"
#include "verification/text/output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SECONDS = 4;                       /* a scene; all scenes and the charts take a minute */
static const double BRIEF[DIM_MAX + 1] = {0, 1, 3, 6}; /* by dimension */
static const char *const brief[] = {"rod-step", "square-step", "cube-step", NULL};

struct bench_options {
    struct command command;
    const char *scene;                /* the one scene; NULL: all */
    const char *json_path, *csv_path; /* NULL for none */
    int brief;
};

/* The files of one run, kept until all can be written together. */
struct files {
    int count;
    struct output file[WORDS_MAX];
};

/* The same measurements as JSON and as a table. */
struct writers {
    struct json json, table;
};

static void write_scene(struct json *j, const struct bench_scene *b) {
    json_object(j, NULL);
    bench_print_scene_json(b, j);
    json_end(j);
}

/* Measures and prints one scene at its defaults; keeps its data if there is a directory. */
static int bench_one(const struct bench_options *given, const struct scene *s, struct writers *w, struct files *files,
                     struct failure *why) {
    struct experiment e = given->command.experiment;
    e.scene = s;
    scene_defaults(s, &e.problem);
    if (s->setup(&e.problem, why)) return why->status;
    struct bench_scene *b = xcalloc(1, sizeof *b);
    if (given->brief)
        bench_run(&e, BENCH_BRIEF, BRIEF[e.problem.dim], b);
    else
        bench_run(&e, BENCH_LONG, SECONDS, b);
    write_scene(&w->json, b);
    write_scene(&w->table, b);
    bench_print_scene(b, stdout);
    fflush(stdout);
    if (given->command.word[0])
        bench_print_data(
            b, output_open(&files->file[files->count++], "%s/bench_%s.csv", given->command.word[0], s->name));
    free(b);
    return STATUS_OK;
}

static int bench_scenes(const struct bench_options *r, struct writers *w, struct files *files, struct failure *why) {
    const struct scene *only = r->scene ? scene_find(r->scene) : NULL;
    const char *names[WORDS_MAX] = {0};
    int status = STATUS_OK;
    for (int i = 0; scenes[i] && i < WORDS_MAX - 1; i++) names[i] = scenes[i]->name;
    if (r->scene && !only) return words_unknown(names, "--scene", r->scene, why);
    bench_print_machine_json(&w->json);
    bench_print_machine(stdout);
    fflush(stdout);
    json_array(&w->json, "scenes");
    json_array(&w->table, "scenes");
    for (int i = 0; scenes[i] && !status; i++)
        if (only ? scenes[i] == only : !r->brief || words_index(brief, names[i]) >= 0)
            status = bench_one(r, scenes[i], w, files, why);
    for (int depth = 2; depth > 0; depth--) json_end(&w->json), json_end(&w->table);
    return status;
}

/* Checks the places and opens the first two files: the JSON, in DIR where --json does not name it, and the table. */
static int open_files(const struct bench_options *r, struct writers *w, struct files *files, struct failure *why) {
    const char *dir = r->command.word[0], *csv = r->csv_path ? r->csv_path : "/dev/null";
    struct output *json = &files->file[files->count++], *table = &files->file[files->count++];
    if (dir && output_directory(dir, "bench.json", why)) return why->status;
    if (output_check(r->json_path, why) || output_check(r->csv_path, why)) return why->status;
    FILE *out = r->json_path ? output_open(json, "%s", r->json_path)
                : dir        ? output_open(json, "%s/bench.json", dir)
                             : output_open(json, "/dev/null");
    *w = (struct writers){json_on(out), json_table(output_open(table, "%s", csv), 5)};
    return STATUS_OK;
}

static int act(const void *options, struct failure *why) {
    const struct bench_options *r = options;
    struct files *files = xcalloc(1, sizeof *files);
    struct writers writers;
    int status = open_files(r, &writers, files, why);
    if (!status) status = bench_scenes(r, &writers, files, why);
    if (!status) status = output_close(files->file, files->count, why);
    output_drop(files->file, files->count);
    free(files);
    return status;
}

#define PLACE(member) OPTION_PLACE(bench_options, member)
static const struct option own[] = {{"scene", "SCENE", "run only this scene", option_text, PLACE(scene)},
                                    {"brief", NULL,
                                     "a rod, a square and a cube, every method with its best stepper: ten seconds",
                                     option_flag, PLACE(brief)},
                                    CSV_OPTION(PLACE(csv_path), "the measurements"),
                                    JSON_OPTION(PLACE(json_path), "the measurements"),
                                    {0}};

static const struct command_syntax syntax = {"bench", "[DIR]", "", "", NULL};

const struct verb verb_bench = {&syntax, own, sizeof(struct bench_options),
                                "measure error against time and counted work; write the data of the charts into DIR",
                                act};
