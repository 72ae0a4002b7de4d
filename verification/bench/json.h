#ifndef HEATLADDER_VERIFICATION_BENCH_JSON_H
#define HEATLADDER_VERIFICATION_BENCH_JSON_H

struct bench_engine;
struct bench_scene;
struct json;

/* Members of an object that is open. */
void bench_json_machine(struct json *j);
void bench_json_engine(const struct bench_engine *e, struct json *j);
void bench_json_scene(const struct bench_scene *b, struct json *j);

#endif
