/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder bench: error against time and against counted work, and the speed of the engine. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "verification/bench/bench.h"
#include "verification/bench/engine.h"
#include "verification/bench/bench_print.h"
#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/command/request.h"
#include "verification/text/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SECONDS = 4; /* of a scene: of a minute ten scenes leave a third to the engine and the charts */

/* The files of one run, kept until all can be put in their places. */
struct files {
    int count;
    struct output file[WORDS_MAX];
};

/* One scene at its defaults: measured, printed and, with a folder, kept for it. */
static int bench_one(const struct request *given, const struct scene *s, struct json *j, struct files *files,
                     struct failure *why) {
    struct experiment e = given->experiment;
    e.scene = s;
    scene_defaults(s, &e.problem);
    if (s->setup(&e.problem, why)) return why->status;
    struct bench_scene *b = xcalloc(1, sizeof *b);
    bench_run(&e, SECONDS, b);
    json_object(j, NULL);
    bench_print_scene_json(b, j);
    json_end(j);
    if (!given->json) bench_print_scene(b, stdout);
    fflush(stdout);
    if (given->dir)
        bench_print_data(b, output_open(&files->file[files->count++], "%s/bench_%s.csv", given->dir, s->name));
    free(b);
    return STATUS_OK;
}

static void measure_engine(const struct request *r, struct json *j) {
    struct bench_engine e;
    bench_engine_run(&e, 1);
    bench_print_machine_json(j);
    bench_print_engine_json(&e, j);
    if (r->json) return;
    bench_print_machine(stdout);
    bench_print_engine(&e, stdout);
    fflush(stdout);
}

static int bench_scenes(const struct request *r, FILE *out, struct files *files, struct failure *why) {
    struct json j = json_on(out);
    const struct scene *only = r->bench_scene ? scene_find(r->bench_scene) : NULL;
    const char *names[WORDS_MAX] = {0};
    int status = STATUS_OK;
    for (int i = 0; scenes[i] && i < WORDS_MAX - 1; i++) names[i] = scenes[i]->name;
    if (r->bench_scene && !only) return words_unknown(names, "scene", r->bench_scene, why);
    measure_engine(r, &j);
    json_array(&j, "scenes");
    for (int i = 0; scenes[i] && !status; i++)
        if (!only || scenes[i] == only) status = bench_one(r, scenes[i], &j, files, why);
    json_end(&j);
    json_end(&j);
    return status;
}

static int bench_all(const struct request *r, struct files *files, struct failure *why) {
    struct output *json = &files->file[files->count++];
    FILE *out = output_open(json, "%s/bench.json", r->dir ? r->dir : "");
    int status = r->dir ? output_directory(r->dir, "bench.json", why) : STATUS_OK;
    if (!status) status = bench_scenes(r, out, files, why);
    output_end(json);
    if (!status && r->json) fputs(json->text, stdout);
    return status;
}

int verb_bench(const struct request *r, struct failure *why) {
    struct files *files = xcalloc(1, sizeof *files);
    int status = bench_all(r, files, why);
    if (!status && r->dir) status = output_close(files->file, files->count, why);
    output_drop(files->file, files->count);
    free(files);
    return status;
}
