/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of the peers, run: each size first tuned, then timed, up to nine times where that is short, since a
 * machine is not equally fast from one tenth of a second to the next. */
#include "verification/bench/peers.h"

#include "verification/command/arguments.h"
#include "verification/ladder/ladder.h"
#include "verification/run/run.h"
#include "verification/text/progress.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 9, COMMAND = 500 };
static const double WARM = 0.1;   /* s: how long all solve, at least once, before what is timed */
static const double TUNED = 1.05; /* error over that of the tightest setting */

const char *const peers_kind_words[] = {"peer", "ours", "whole", "rate"};

/* Reads "`verb` SCENE METHOD `options`", a peer's command with its setting in the method's place. */
static int read_line(const struct peer *p, const char *verb, const char *options, int threads, const char *setting,
                     struct request *r, struct failure *why) {
    char line[COMMAND], solver[COMMAND];
    int theirs = p->kind == PEERS_THEIRS;
    snprintf(line, sizeof line, "%s %s %s%s --threads %d %s", verb, p->scene, theirs ? "peer" : p->command, options,
             threads, theirs ? "" : setting);
    snprintf(solver, sizeof solver, "export OMP_NUM_THREADS=%d OPENBLAS_NUM_THREADS=1 GOMP_SPINCOUNT=10000; %s %s",
             threads, p->command, setting);
    const char *more[] = {theirs ? "--solver" : NULL, solver, NULL};
    return arguments_parse_line_with(line, more, r, why);
}

static int run_once(const struct peer *p, int n, int threads, const char *setting, struct result *out) {
    char dx[60];
    struct request r;
    struct failure why;
    snprintf(dx, sizeof dx, " --dx %s/%d", p->side, n);
    int status = read_line(p, "run", dx, threads, setting, &r, &why);
    if (!status && p->kind != PEERS_THEIRS) status = run_warm_up(&r.experiment, &why);
    *out = (struct result){.failure = why};
    if (!status) status = run_experiment(&r.experiment, out, NULL);
    arguments_free(&r);
    return status;
}

/* One setting after the other, the tightest first, while the error stays. */
static void tune(const struct peer *p, struct peers_size *s) {
    char word[32], asked[PEERS_SETTING];
    double limit = INFINITY;
    int used;
    struct result r;
    for (const char *at = p->settings; at && sscanf(at, "%31s%n", word, &used) == 1; at += used) {
        snprintf(asked, sizeof asked, "%s%s", p->kind == PEERS_THEIRS ? "" : "--time-error ", word);
        int status = run_once(p, s->n, 1, asked, &r);
        if (status && *s->setting) continue;
        if (!status && r.error.l1 > limit) return;
        if (!status && isinf(limit)) limit = TUNED * r.error.l1;
        memcpy(s->setting, asked, sizeof asked);
        if (status) return; /* to be recorded as failed */
        if (p->kind != PEERS_THEIRS) snprintf(s->setting, sizeof s->setting, "--dt %.17g", r.dt);
    }
}

/* A text without what would end a cell of CSV, cut to size. */
static void keep_text(const char *text, char *to, size_t size) {
    snprintf(to, size, "%.*s", (int)size - 1, text);
    for (char *c = to; *c; c++)
        if (*c == ',' || *c == '"') *c = *c == ',' ? ';' : '\'';
}

/* One run: a line of CSV, and what is kept of it. */
static int record(const struct peers *all, struct peers_row *row, struct peers_size *s, int many, double *seconds) {
    const struct peer *p = row->peer;
    struct peers_runs *runs = &s->with[many];
    struct result r;
    int threads = many ? all->threads : 1, status = run_once(p, s->n, threads, s->setting, &r);
    row->missing =
        status == STATUS_SKIPPED && !row->size[0].with[0].count; /* else it is one size that is not for it */
    if (row->missing) return status;
    fprintf(all->runs, "%s,%d,%s,%s,%d,%s,", p->scene, threads, peers_kind_words[p->kind], p->who, s->n, s->setting);
    if (status) {
        keep_text(r.failure.text, runs->failure, sizeof runs->failure);
        fprintf(all->runs, ",,,,%s\n", runs->failure);
        return status;
    }
    /* A peer tells what its solve took, rates are those of the time loop; ours are a call, and all of it counts. */
    double solve = p->kind == PEERS_THEIRS || p->kind == PEERS_RATE ? r.cost.step_seconds : r.cost.seconds;
    fprintf(all->runs, "%.17g,%.9g,%.9g,%lld,\n", r.error.l1, solve, r.cost.seconds, r.cost.updates);
    if (runs->count == 0) {
        runs->error = r.error.l1;
        runs->updates = (double)r.cost.updates;
        runs->start_up = r.cost.seconds - solve - fmax(solve, WARM);
    }
    seconds[runs->count++] = solve;
    return STATUS_OK;
}

static int repeats(double seconds) {
    return seconds > 4 ? 1 : seconds > 0.05 ? 3 : seconds > 0.005 ? 5 : RUNS;
}

static void time_size(const struct peers *all, struct peers_row *row, struct peers_size *s, int many) {
    struct peers_runs *runs = &s->with[many];
    double seconds[RUNS];
    int most = 1;
    while (runs->count < most && !record(all, row, s, many, seconds))
        if (runs->count == 1) most = repeats(seconds[0]);
    if (runs->count) runs->time = bench_summary(seconds, runs->count);
}

/* The suite's own verdict on the order, over the same sizes, with the setting of the finest. */
static void judge(struct peers_row *row) {
    const struct peer *p = row->peer;
    char options[200];
    snprintf(options, sizeof options, " --expect %g,%g --dx ", p->gate[0], p->gate[1]);
    for (int i = 0; i < row->sizes; i++)
        words_add(options, sizeof options, "%s%s/%d", i ? "," : "", p->side, p->n[i]);
    struct ladder *l = xcalloc(1, sizeof *l);
    struct request r;
    struct failure why;
    int status = read_line(p, "ladder", options, 1, row->size[row->sizes - 1].setting, &r, &why);
    if (!status) status = ladder_run(&r.experiment, &r.rungs, l, &why);
    if (status == STATUS_INPUT)
        snprintf(row->order, sizeof row->order, "failed");
    else
        snprintf(row->order, sizeof row->order, "%s: %.2f (%g to %g)", verdict_words[l->verdict], l->slope.value,
                 p->gate[0], p->gate[1]);
    arguments_free(&r);
    free(l);
}

/* With one thread, where it is tuned and judged too; or with all. */
static void measure(const struct peers *all, struct peers_row *row, int many) {
    const struct peer *p = row->peer;
    if (row->missing || (many && p->serial)) return;
    for (int i = 0; i < PEERS_SIZES && p->n[i] && !row->missing; i++) {
        struct peers_size *s = &row->size[i];
        s->n = p->n[i];
        row->sizes = i + 1;
        if (!many) tune(p, s);
        time_size(all, row, s, many);
    }
    if (!many && p->gate[1] > 0 && !row->missing) judge(row);
}

int peers_run(const struct peer *table, const char *scene, struct peers *all, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    int rows = 0, count = 0, rounds = all->threads > 1 ? 2 : 1;
    for (const struct peer *p = table; p->scene; p++, rows++)
        if (words_index(names, p->scene) < 0 && count < WORDS_MAX - 1) names[count++] = p->scene;
    if (scene && words_index(names, scene) < 0) return words_unknown(names, "scene", scene, why);
    all->row = xcalloc((size_t)rows + 1, sizeof *all->row);
    rows = 0;
    for (const struct peer *p = table; p->scene; p++)
        if (!scene || strcmp(scene, p->scene) == 0) all->row[rows++].peer = p;
    struct progress progress = progress_start("programs", rounds * rows);
    fprintf(all->runs, "scene,threads,kind,who,n,setting,E1,solve,whole,updates,failure\n");
    for (int many = 0; many < rounds; many++) {
        for (struct peers_row *row = all->row; row->peer; row++) {
            measure(all, row, many);
            progress_tick(&progress);
        }
    }
    progress_end(&progress);
    return STATUS_OK;
}

void peers_free(struct peers *all) {
    free(all->row);
    all->row = NULL;
}
