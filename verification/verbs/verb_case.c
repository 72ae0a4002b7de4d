/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder case: the cases of a ladder or of the battery, for a program that runs elsewhere and is judged later. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/gates/battery.h"
#include "verification/command/request.h"
#include "verification/foreign/case_file.h"
#include "verification/foreign/case_run.h"
#include "verification/foreign/results.h"
#include "verification/foreign/scratch.h"
#include "verification/text/atomic_file.h"
#include "verification/text/words.h"

#include <stdio.h>
#include <stdlib.h>

static int battery(const struct request *r, struct failure *why) {
    struct gates g = {0};
    int cases, order = r->order ? r->order : 2;
    int seeds = r->experiment.program.seeds;
    char words[100] = "";
    battery_words(r, words, sizeof words);
    if (seeds) words_add(words, sizeof words, " --seeds %d", seeds);
    int status = battery_add(order, r->profile, r->draw, &g, why);
    refine_gates(&g, r->more_rungs, r->time_order);
    if (!status) status = battery_write(&g, seeds, r->into, &cases, why);
    if (!status)
        printf("%d gates: %s/cases.txt names %d cases; when each has its out.csv beside it:\n"
               "  heatladder verify --order %d --seed %lu%s --results %s\n",
               g.declared, r->into, cases, order, r->draw, words, r->into);
    gates_free(&g);
    return status;
}

/* As `verify` would run it.  A case that is not for the program is no failure. */
static int run_one(const struct request *r, struct failure *why) {
    const struct program *g = &r->experiment.program;
    struct case_run run = {.dir = r->run_case, .solver = g->solver, .label = r->run_case, .timeout = g->timeout};
    struct scratch scratch;
    char path[RESULTS_PATH], dx[40];
    int code;
    if (snprintf(path, sizeof path, "%s/case", r->run_case) > RESULTS_PATH - 40 || !words_is_plain(path))
        return refuse(why, STATUS_INPUT, "--run '%.200s': at most %d of letters, digits and /._-+=,@%% are wanted",
                      r->run_case, RESULTS_PATH - 40);
    char *text = case_file_read(path, why);
    if (!text) return why->status;
    int bad = case_file_value(text, "dx", dx, sizeof dx);
    free(text);
    if (bad) return refuse(why, STATUS_INPUT, "%.300s: has no dx: not a case", path);
    if (case_run_is_over(r->run_case)) return printf("%s: has its answer\n", r->run_case) < 0;
    run.dx = dx;
    atomic_file_hold();
    int status = scratch_open(&scratch, why);
    if (!status) {
        status = case_run(&run, &scratch, &code, why);
        scratch_close(&scratch);
    }
    atomic_file_release();
    if (status != STATUS_SKIPPED) return status;
    return printf("%s: skipped: %s\n", r->run_case, why->text) < 0;
}

int verb_case(const struct request *r, struct failure *why) {
    const struct experiment *e = &r->experiment;
    int written;
    if (r->run_case) return run_one(r, why);
    if (r->battery) return battery(r, why);
    int seeds = e->program.seeds;
    if (results_write(&(struct results_place){r->into, "", "", &e->program.map, seeds}, e->scene, &e->problem,
                      &e->options, r->rungs.dx.text, &written, why))
        return why->status;
    printf("%d case%s of %s in %s, named in %s/cases.txt; when each has its out.csv beside it:\n"
           "  heatladder ladder %s NAME",
           written, written == 1 ? "" : "s", e->scene->name, r->into, r->into, e->scene->name);
    if (seeds) printf(" --seeds %d", seeds);
    printf(" --results %s\n", r->into);
    return STATUS_OK;
}
