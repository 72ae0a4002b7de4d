/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder case: the cases of a ladder or of the battery, for a program that runs elsewhere and is judged later. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/gates/battery.h"
#include "verification/command/request.h"
#include "verification/foreign/results.h"
#include "verification/text/words.h"

#include <stdio.h>

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

int verb_case(const struct request *r, struct failure *why) {
    const struct experiment *e = &r->experiment;
    int written;
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
