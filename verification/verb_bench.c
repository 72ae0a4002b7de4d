/* heatladder bench: error against time and against counted work, and the speed of the engine. */
#include "verification/verb.h"

#include "references/scene.h"
#include "verification/atomic_file.h"
#include "verification/bench.h"
#include "verification/bench_engine.h"
#include "verification/bench_json.h"
#include "verification/bench_print.h"
#include "verification/json.h"
#include "verification/progress.h"
#include "verification/request.h"
#include "verification/words.h"

#include <stdio.h>
#include <stdlib.h>

/* One scene at its defaults: measured, printed and, with a folder, written. */
static int bench_one(const struct request *given, const struct scene *s, struct json *j, struct failure *why) {
    struct request r = *given;
    struct bench_scene *b = xcalloc(1, sizeof *b);
    r.scene = s;
    scene_defaults(s, &r.problem);
    int status = s->setup(&r.problem, why);
    if (!status) bench_run(&r, b);
    if (!status) {
        json_object(j, NULL);
        bench_json_scene(b, j);
        json_end(j);
    }
    if (!status && !r.json) {
        bench_print_scene(b, stdout);
        fflush(stdout);
    }
    if (!status && given->topic) status = bench_print_data(b, given->topic, why);
    free(b);
    return status;
}

static void measure_engine(const struct request *r, struct json *j) {
    struct bench_engine e;
    bench_engine_run(&e);
    bench_json_machine(j);
    bench_json_engine(&e, j);
    if (r->json) return;
    bench_print_machine(stdout);
    bench_print_engine(&e, stdout);
    fflush(stdout);
}

static int bench_scenes(const struct request *r, FILE *out, struct failure *why) {
    struct json j = json_on(out);
    const struct scene *only = r->only ? scene_find(r->only) : NULL;
    const char *names[WORDS_MAX] = {0};
    int total = 0, status = STATUS_OK;
    for (; scenes[total] && total < WORDS_MAX - 1; total++) names[total] = scenes[total]->name;
    if (r->only && !only) return words_unknown(names, "scene", r->only, why);
    json_object(&j, NULL);
    measure_engine(r, &j);
    json_array(&j, "scenes");
    struct progress progress = progress_start("scenes", only ? 1 : total);
    for (int i = 0; scenes[i] && !status; i++) {
        if (only && scenes[i] != only) continue;
        status = bench_one(r, scenes[i], &j, why);
        progress_tick(&progress);
    }
    progress_end(&progress);
    json_end(&j);
    json_end(&j);
    return status;
}

int verb_bench(const struct request *r) {
    struct failure why = {0};
    char path[512], *text = NULL;
    size_t size = 0;
    snprintf(path, sizeof path, "%.480s/bench.json", r->topic ? r->topic : "");
    FILE *out = open_memstream(&text, &size);
    int status =
        out ? atomic_file_check(r->topic ? path : NULL, &why) : fail(&why, STATUS_NUMERICAL, "out of memory");
    if (!status) status = bench_scenes(r, out, &why);
    if (out) fclose(out);
    if (!status && r->json) fputs(text, stdout);
    if (!status && r->topic) status = atomic_file_write(path, text, size, &why);
    if (status) fprintf(stderr, "heatladder: %s\n", why.text);
    free(text);
    return status;
}
