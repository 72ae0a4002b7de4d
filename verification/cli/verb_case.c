/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder case: the cases of a ladder or of the battery, for a program that runs elsewhere and is judged later. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/cli/battery_options.h"
#include "verification/case/results.h"

#include <stdio.h>

struct case_options {
    struct command command;
    struct battery_options battery;
    int whole; /* 1: the whole battery */
    const char *into;
};

static int write_battery(const struct case_options *r, struct failure *why) {
    struct gates g = {0};
    int cases, seeds = r->command.experiment.program.seeds, order = battery_order(&r->battery);
    unsigned long seed = battery_seed(&r->command, &r->battery);
    char words[100] = "";
    battery_words(r->battery.profile, r->battery.rungs, words, sizeof words);
    if (seeds) words_add(words, sizeof words, " --seeds %d", seeds);
    int status = battery_add(order, r->battery.profile, seed, &g, why);
    gates_refine(&g, r->battery.rungs, 0);
    if (!status) status = battery_write(&g, seeds, r->into, &cases, why);
    if (!status)
        printf("%d gates: %s/cases.txt names %d cases; when each has its out.csv beside it:\n"
               "  heatladder verify --order %d --seed %lu%s --results %s\n",
               g.declared, r->into, cases, order, seed, words, r->into);
    gates_free(&g);
    return status;
}

static int act(const void *options, struct failure *why) {
    const struct case_options *r = options;
    const struct command *c = &r->command;
    const struct experiment *e = &c->experiment;
    int written, seeds = e->program.seeds;
    if (e->scene && r->whole) return refuse(why, STATUS_INPUT, "--battery has scenes of its own");
    if (!e->scene && !r->whole)
        return refuse(why, STATUS_INPUT,
                      "case needs a scene, or --battery: heatladder case SCENE --dx A,B,C --into DIR");
    if (r->whole) return write_battery(r, why);
    if (!c->rungs.dx.count) return refuse(why, STATUS_INPUT, "case needs --dx A,B,C,...: the spacings");
    if (results_write(&(struct results_place){r->into, "", "", &e->program.map, seeds}, e->scene, &e->problem,
                      &e->options, c->rungs.dx.text, &written, why))
        return why->status;
    printf("%d case%s of %s in %s, named in %s/cases.txt; when each has its out.csv beside it:\n"
           "  heatladder ladder %s NAME",
           written, written == 1 ? "" : "s", e->scene->name, r->into, r->into, e->scene->name);
    if (seeds) printf(" --seeds %d", seeds);
    printf(" --results %s\n", r->into);
    return STATUS_OK;
}

#define PLACE(member) OPTION_PLACE(case_options, member)
static const struct option own[] = {
    {"into", "DIR", "write DIR/SCENE/DX/case, and DIR/cases.txt with a directory a line", option_text, PLACE(into)},
    {"battery", NULL, "write the cases of the battery, which verify --results DIR judges", option_flag, PLACE(whole)},
    BATTERY_OPTIONS(case_options),
    {0}};

static const struct command_syntax syntax = {
    "case", "[SCENE]", "into", "dx dt fourier threads t-end set seeds aspect map scale offset",
    "battery profile order seed rungs seeds dx aspect map scale offset into"};

const struct verb verb_case = {
    &syntax, own, sizeof(struct case_options),
    "write the cases of a ladder or of the battery, to run elsewhere and judge later (--results)", act};
