/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder bench: error against time and against counted work, and the speed of the engine; or, with --peers, error
 * against time beside the codes of others. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "verification/bench/bench.h"
#include "verification/bench/engine.h"
#include "verification/bench/mesh_peers.h"
#include "verification/bench/peers.h"
#include "verification/bench/bench_print.h"
#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/command/request.h"
#include "verification/text/words.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MESH = 448 };             /* particles along either axis, whose Voronoi cells are timed beside others' */
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

/* ---- Beside others ---- */

static void write_charts(const struct request *r, const struct peers *all, struct files *files) {
    const char *scene = "";
    for (const struct peers_row *row = all->row; row->peer; scene = row->peer->scene, row++)
        for (int many = 0; many < 2 && strcmp(row->peer->scene, scene) != 0; many++)
            if (!many || all->threads > 1)
                peers_print_data(all, row->peer->scene, many,
                                 output_open(&files->file[files->count++], "%s/peers_%s%s.csv", r->dir,
                                             row->peer->scene, many ? "_threads" : ""));
}

static int bench_peers(const struct request *r, struct files *files, struct failure *why) {
    const char *dir = r->dir ? r->dir : "";
    struct output *table = &files->file[files->count++];
    struct peers all = {.threads = omp_get_num_procs()};
    FILE *out = output_open(table, "%s/peers.txt", dir);
    int status = r->dir ? output_directory(r->dir, "peers.txt", why) : STATUS_OK;
    all.runs = output_open(&files->file[files->count++], "%s/runs.csv", dir);
    if (!status) status = peers_run(peers_table, r->bench_scene, &all, why);
    if (!status) peers_print(&all, out);
    if (!status && !r->bench_scene) status = mesh_peers_run(mesh_peers_table, MESH, out, why);
    if (!status && r->dir) write_charts(r, &all, files);
    output_end(table);
    if (!status) fputs(table->text, stdout);
    peers_free(&all);
    return status;
}

static int bench_ours(const struct request *r, struct files *files, struct failure *why) {
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
    int status = (r->peers ? bench_peers : bench_ours)(r, files, why);
    if (!status && r->dir) status = output_close(files->file, files->count, why);
    output_drop(files->file, files->count);
    free(files);
    return status;
}
