/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder case: the cases of a ladder or of the battery, for a program that runs elsewhere and is judged later. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/cli/battery_options.h"
#include "verification/case/results.h"
#include "verification/text/json.h"
#include "verification/text/output.h"

#include <stdio.h>

struct case_options {
    struct command command;
    struct battery_options battery;
    int whole;                    /* 1: the whole battery */
    const char *into, *json_path; /* NULL for none */
};

/* cases: with their number, judge: the command that judges their answers. */
static int say(const struct case_options *r, int cases, const char *about, const char *judge, struct failure *why) {
    struct output page;
    printf("%s; once each has its out.csv beside it, judge them by\n  %s\n", about, judge);
    if (!r->json_path) return STATUS_OK;
    struct json j = json_on(output_open(&page, "%s", r->json_path));
    json_add(&j, "into %s|cases %d|judge %s", r->into, cases, judge);
    json_end(&j);
    return output_close(&page, 1, why);
}

static int write_battery(const struct case_options *r, struct failure *why) {
    struct gates g = {0};
    int cases, seeds = r->command.experiment.program.seeds, order = battery_order(&r->battery);
    unsigned long seed = battery_seed(&r->command, &r->battery);
    char words[100] = "", about[RESULTS_PATH + 60], judge[RESULTS_PATH + 160];
    battery_words(r->battery.profile, r->battery.rungs, words, sizeof words);
    if (seeds) words_add(words, sizeof words, " --seeds %d", seeds);
    int status = battery_add(order, r->battery.profile, seed, &g, why);
    gates_refine(&g, r->battery.rungs, 0);
    if (!status) status = battery_write(&g, seeds, r->into, &cases, why);
    if (!status) {
        snprintf(about, sizeof about, "%d gates: %s/cases.txt lists %d cases", g.declared, r->into, cases);
        snprintf(judge, sizeof judge, "heatladder verify --order %d --seed %lu%s --results %s", order, seed, words,
                 r->into);
        status = say(r, cases, about, judge, why);
    }
    gates_free(&g);
    return status;
}

static int act(const void *options, struct failure *why) {
    const struct case_options *r = options;
    const struct command *c = &r->command;
    const struct experiment *e = &c->experiment;
    int written, seeds = e->program.seeds;
    char about[2 * RESULTS_PATH], judge[RESULTS_PATH + 160], draws[30] = "";
    if (output_check(r->json_path, why)) return why->status;
    if (e->scene && r->whole) return refuse(why, STATUS_INPUT, "--battery has scenes of its own");
    if (!e->scene && !r->whole)
        return refuse(why, STATUS_INPUT,
                      "case needs a scene, or --battery: heatladder case SCENE --dx A,B,C --into DIR");
    if (r->whole) return write_battery(r, why);
    if (!c->rungs.dx.count) return refuse(why, STATUS_INPUT, "case needs --dx A,B,C,...: the spacings");
    if (results_write(&(struct results_place){r->into, "", "", &e->program.map, seeds}, e->scene, &e->problem,
                      &e->options, c->rungs.dx.text, &written, why))
        return why->status;
    if (seeds) snprintf(draws, sizeof draws, " --seeds %d", seeds);
    snprintf(about, sizeof about, "%d case%s of %s in %s, listed in %s/cases.txt", written, written == 1 ? "" : "s",
             e->scene->name, r->into, r->into);
    snprintf(judge, sizeof judge, "heatladder ladder %s NAME%s --results %s", e->scene->name, draws, r->into);
    return say(r, written, about, judge, why);
}

#define PLACE(member) OPTION_PLACE(case_options, member)
static const struct option own[] = {
    {"into", "DIR", "write DIR/SCENE/DX/case, and DIR/cases.txt with a directory a line", option_text, PLACE(into)},
    {"battery", NULL, "write the cases of the battery, which verify --results DIR judges", option_flag, PLACE(whole)},
    JSON_OPTION(PLACE(json_path), "the number of cases and the command that judges them"),
    BATTERY_OPTIONS(case_options),
    {0}};

static const struct command_syntax syntax = {
    "case", "[SCENE]", "into", "dx dt fourier threads t-end set seeds aspect map scale offset",
    "battery profile order seed rungs seeds dx aspect map scale offset into json"};

const struct verb verb_case = {
    &syntax, own, sizeof(struct case_options),
    "write the cases of a ladder or of the battery, to run elsewhere and judge later (--results)", act};
