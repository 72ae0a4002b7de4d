/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A benchmark as text, as JSON, and as the data of its charts. */
#include "verification/bench/bench_print.h"

#include "references/scene.h"
#include "solver/options.h"
#include "verification/bench/bench.h"
#include "verification/case/lanes.h"
#include "verification/text/json.h"
#include "verification/text/table.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#ifndef BENCH_FLAGS
#define BENCH_FLAGS "unknown"
#endif

/* The machine of a benchmark, and the compiler. */
struct machine {
    char processor[120]; /* as the system reports it, or "unknown" */
    int cores;           /* available to this process */
    int lanes;           /* doubles per vector in the lattice sweeps */
    const char *compiler, *flags;
};

static void name_processor(char *name, size_t size) {
    char *text = whole_file_at("/proc/cpuinfo", NULL), *at = text ? strstr(text, "model name") : NULL;
    if (at) at = strstr(at, ": ");
    snprintf(name, size, "%.*s", at ? (int)strcspn(at + 2, "\n") : 7, at ? at + 2 : "unknown");
    free(text);
}

static struct machine machine_here(void) {
    struct machine m = {.cores = omp_get_num_procs(), .flags = BENCH_FLAGS};
#ifdef __clang__
    m.compiler = "clang " __VERSION__;
#else
    m.compiler = "gcc " __VERSION__;
#endif
    struct failure ignored; /* a width that the machine lacks was refused when the command line was read */
    if (lanes_forced(&m.lanes, &ignored) || m.lanes == 0) m.lanes = options_lanes_most();
    name_processor(m.processor, sizeof m.processor);
    return m;
}

void bench_print_machine(FILE *out) {
    struct machine m = machine_here();
    fprintf(out,
            "processor  %s, %d cores, vectors of %d (HEATLADDER_LANES=2, 4 or 8 forces a width)\ncompiler   "
            "%s\nflags      %s\ntimes      median of %d runs after one to warm up\n\n",
            m.processor, m.cores, m.lanes, m.compiler, m.flags, BENCH_RUNS);
}

static void print_front(const struct bench_scene *b, FILE *out) {
    struct table t = table_headed(1, "on a front|along x|E1|seconds|spread [%]|work [pairs]|B/particle|fronts");
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *r = &b->row[i];
        if (!r->front_time && !r->front_work) continue;
        table_add(&t, "%s|%d|%.3e|%.3g|%.0f|%.3g|%.3g|%s", r->candidate->label, r->n, r->result.error[NORM_L1],
                  r->time.median, 100 * (r->time.highest - r->time.lowest) / r->time.median, r->work,
                  (double)r->result.cost.bytes / (double)r->result.particles,
                  r->front_time && r->front_work ? "time, work"
                  : r->front_time                ? "time"
                                                 : "work");
    }
    table_end(&t, out);
}

static int same_failure(const struct bench_row *a, const struct bench_row *b) {
    return a->candidate == b->candidate && strcmp(a->result.failure.text, b->result.failure.text) == 0;
}

void bench_print_scene(const struct bench_scene *b, FILE *out) {
    fprintf(out, "%s\n", b->scene->name);
    print_front(b, out);
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *r = &b->row[i];
        if (!r->result.failure.status) continue;
        while (i + 1 < b->count && same_failure(&b->row[i + 1], r)) i++;
        fprintf(out, "%s: %s, %d", bench_outcome(r), r->candidate->label, r->n);
        if (b->row[i].n > r->n) fprintf(out, " to %d", b->row[i].n);
        fprintf(out, " along x: %s\n", r->result.failure.text);
    }
    fputc('\n', out);
}

static void write_row(const struct bench_row *r, FILE *out) {
    fprintf(out, "%d,%zu,%.17g,%.9g,%.9g,%.9g,%.9g,%zu,%lld,\"%s\"\n", r->n, r->result.particles,
            r->result.error[NORM_L1], r->time.median, r->time.lowest, r->time.highest, r->work, r->result.cost.bytes,
            r->result.cost.updates, r->candidate->label);
}

/* The plotter takes the last word of the header as the legend, so that it must not contain a comma. */
static void write_header(const struct candidate *c, int first, FILE *out) {
    fprintf(out, "%s# %s\nn,particles,E1,seconds,lowest,highest,work,bytes,updates,", first ? "" : "\n\n", c->label);
    for (const char *at = c->label; *at; at++) fputc(*at == ',' ? ';' : *at, out);
    fputc('\n', out);
}

static void write_front(const struct bench_scene *b, int by_work, FILE *out) {
    double below = 0;
    fprintf(out, "\n\n# front by %s\nn,particles,E1,seconds,lowest,highest,work,bytes,updates,Pareto front\n",
            by_work ? "work" : "time");
    for (;;) { /* in order of cost; along a front the error then decreases */
        const struct bench_row *next = NULL;
        for (int i = 0; i < b->count; i++) {
            const struct bench_row *r = &b->row[i];
            if (!(by_work ? r->front_work : r->front_time) || bench_cost(r, by_work) <= below) continue;
            if (!next || bench_cost(r, by_work) < bench_cost(next, by_work)) next = r;
        }
        if (!next) return;
        below = bench_cost(next, by_work);
        write_row(next, out);
    }
}

void bench_print_data(const struct bench_scene *b, FILE *out) {
    struct machine m = machine_here();
    fprintf(out, "# title: %s: error against cost\n# command: heatladder bench --scene %s\n# processor: %s\n",
            b->scene->name, b->scene->name, m.processor);
    fprintf(out, "# compiler: %s %s\n# seconds: median of %d; work: pairs\n", m.compiler, m.flags, BENCH_RUNS);
    const struct candidate *last = NULL;
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *r = &b->row[i];
        if (r->result.failure.status) {
            fprintf(out, "# %s: %s, %d along x: %s\n", bench_outcome(r), r->candidate->label, r->n,
                    r->result.failure.text);
            continue;
        }
        if (r->candidate != last) write_header(r->candidate, last == NULL, out);
        last = r->candidate;
        write_row(r, out);
    }
    write_front(b, 0, out);
    write_front(b, 1, out);
    fputc('\n', out);
}

/* ---- JSON ---- */

void bench_print_machine_json(struct json *j) {
    struct machine m = machine_here();
    json_object(j, "machine");
    json_add(j, "processor %s|cores %d|lanes %d", m.processor, m.cores, m.lanes);
    json_add(j, "compiler %s|flags %s|runs %d", m.compiler, m.flags, BENCH_RUNS);
    json_end(j);
}

void bench_print_scene_json(const struct bench_scene *b, struct json *j) {
    json_text(j, "scene", b->scene->name);
    json_array(j, "rows");
    for (int i = 0; i < b->count; i++) {
        const struct bench_row *r = &b->row[i];
        json_object(j, NULL);
        json_add(j, "candidate %s|along_x %d", r->candidate->label, r->n);
        json_text(j, "outcome", bench_outcome(r) ? bench_outcome(r) : "ran");
        result_json(&r->result, j);
        json_add(j, "seconds_median %g|seconds_lowest %g|seconds_highest %g", r->time.median, r->time.lowest,
                 r->time.highest);
        json_add(j, "work %g|front_time %d|front_work %d", r->work, r->front_time, r->front_work);
        json_end(j);
    }
    json_end(j);
}
