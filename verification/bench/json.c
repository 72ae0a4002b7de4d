/* A benchmark as JSON. */
#include "verification/bench/json.h"

#include "references/scene.h"
#include "verification/bench/bench.h"
#include "verification/bench/engine.h"
#include "verification/bench/machine.h"
#include "verification/text/json.h"

void bench_json_machine(struct json *j) {
    struct bench_machine m = bench_machine_here();
    json_object(j, "machine");
    json_text(j, "processor", m.processor);
    json_whole(j, "cores", m.cores);
    json_whole(j, "lanes", m.lanes);
    json_text(j, "compiler", m.compiler);
    json_text(j, "flags", m.flags);
    json_whole(j, "runs", BENCH_RUNS);
    json_end(j);
}

void bench_json_engine(const struct bench_engine *e, struct json *j) {
    json_array(j, "engine");
    for (int i = 0; i < e->count; i++) {
        const struct bench_engine_row *r = &e->row[i];
        json_object(j, NULL);
        json_text(j, "what", r->what);
        json_text(j, "unit", r->unit);
        json_number(j, "median", r->value);
        json_number(j, "lowest", r->lowest);
        json_number(j, "highest", r->highest);
        json_number(j, "aim", r->aim);
        json_whole(j, "held", bench_engine_holds(r));
        json_end(j);
    }
    json_end(j);
}

void bench_json_scene(const struct bench_scene *b, struct json *j) {
    json_text(j, "scene", b->scene->name);
    json_text(j, "same_against_same", b->slow.label);
    json_number(j, "same_ratio", b->slow.ratio);
    json_text(j, "same_fast", b->fast.label);
    json_number(j, "same_fast_ratio", b->fast.ratio);
    json_array(j, "rows");
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *r = &b->row[i];
        json_object(j, NULL);
        json_text(j, "candidate", r->candidate->label);
        json_whole(j, "along_x", r->n);
        json_text(j, "outcome", bench_outcome(r) ? bench_outcome(r) : "ran");
        result_json(&r->result, j);
        json_number(j, "seconds_median", r->time.median);
        json_number(j, "seconds_lowest", r->time.lowest);
        json_number(j, "seconds_highest", r->time.highest);
        json_number(j, "work", r->work);
        json_whole(j, "front_time", r->front_time);
        json_whole(j, "front_work", r->front_work);
        json_end(j);
    }
    json_end(j);
    json_array(j, "growth");
    for (int i = 0; i < b->growths; i++) {
        const struct bench_growth *g = &b->growth[i];
        json_object(j, NULL);
        json_text(j, "candidate", g->candidate->label);
        json_whole(j, "rungs", g->rungs);
        json_number(j, "seconds", g->seconds);
        json_number(j, "work", g->work);
        json_number(j, "expected", g->expected);
        json_end(j);
    }
    json_end(j);
}
