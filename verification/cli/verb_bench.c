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
    const char *scene;     /* the one scene; NULL: all */
    const char *json_path; /* NULL for none */
    int brief;
};

/* The files of one run, kept until all can be written together. */
struct files {
    int count;
    struct output file[WORDS_MAX];
};

/* Measures and prints one scene at its defaults; keeps its data if there is a directory. */
static int bench_one(const struct bench_options *given, const struct scene *s, struct json *j, struct files *files,
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
    json_object(j, NULL);
    bench_print_scene_json(b, j);
    json_end(j);
    bench_print_scene(b, stdout);
    fflush(stdout);
    if (given->command.word[0])
        bench_print_data(
            b, output_open(&files->file[files->count++], "%s/bench_%s.csv", given->command.word[0], s->name));
    free(b);
    return STATUS_OK;
}

static int bench_scenes(const struct bench_options *r, FILE *out, struct files *files, struct failure *why) {
    struct json j = json_on(out);
    const struct scene *only = r->scene ? scene_find(r->scene) : NULL;
    const char *names[WORDS_MAX] = {0};
    int status = STATUS_OK;
    for (int i = 0; scenes[i] && i < WORDS_MAX - 1; i++) names[i] = scenes[i]->name;
    if (r->scene && !only) return words_unknown(names, "--scene", r->scene, why);
    bench_print_machine_json(&j);
    bench_print_machine(stdout);
    fflush(stdout);
    json_array(&j, "scenes");
    for (int i = 0; scenes[i] && !status; i++)
        if (only ? scenes[i] == only : !r->brief || words_index(brief, names[i]) >= 0)
            status = bench_one(r, scenes[i], &j, files, why);
    json_end(&j);
    json_end(&j);
    return status;
}

/* DIR/bench.json, or the file of --json, is the first file. */
static int bench_all(const struct bench_options *r, struct files *files, struct failure *why) {
    const char *dir = r->command.word[0];
    struct output *json = &files->file[files->count++];
    FILE *out =
        r->json_path ? output_open(json, "%s", r->json_path) : output_open(json, "%s/bench.json", dir ? dir : "");
    int status = dir ? output_directory(dir, "bench.json", why) : STATUS_OK;
    if (!status) status = output_check(r->json_path, why);
    return status ? status : bench_scenes(r, out, files, why);
}

static int act(const void *options, struct failure *why) {
    const struct bench_options *r = options;
    struct files *files = xcalloc(1, sizeof *files);
    int status = bench_all(r, files, why);
    if (!status && (r->command.word[0] || r->json_path)) status = output_close(files->file, files->count, why);
    output_drop(files->file, files->count);
    free(files);
    return status;
}

#define PLACE(member) OPTION_PLACE(bench_options, member)
static const struct option own[] = {{"scene", "SCENE", "run only this scene", option_text, PLACE(scene)},
                                    {"brief", NULL,
                                     "a rod, a square and a cube, every method with its best stepper: ten seconds",
                                     option_flag, PLACE(brief)},
                                    JSON_OPTION(PLACE(json_path), "the measurements"),
                                    {0}};

static const struct command_syntax syntax = {"bench", "[DIR]", "", "", NULL};

const struct verb verb_bench = {&syntax, own, sizeof(struct bench_options),
                                "measure error against time and counted work; write the data of the charts into DIR",
                                act};
